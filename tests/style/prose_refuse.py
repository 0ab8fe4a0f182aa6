"""prose_refuse.py: the checks of prose, words and lines refuse what they are there to refuse.

Plants one fault at a time in a small tree, and one right name of each kind.
"""
import os
import tempfile
import unittest

import line_breaks
import line_width
import plain_words
import prose_names

TREE = {
    "run": "usage --full\n",
    "hydro/bem/Lid.h": "constexpr double kFarRatio = 12.0;\nclass RankinePanel { int area(); };\n",
    "tests/bem/lid_test.cpp": "TEST(LidIdentity, IsFlat) {}\n",
    "hydro/decisions/0001-a-lid.md": "Status: current.\n",
    "hydro/decisions/0002-no-lid.md": "Status: superseded by 0001. It was in `Gone.h`.\n",
    "CHANGELOG.md": "Before: `OldName`.\n",
}

RIGHT = (
    "`Lid.h`", "`bem/Lid.h`", "hydro/bem/Lid.h", "`hydro/bem/`", "[lid](hydro/bem/Lid.h)",
    "`lid_*.cpp`",
    "LidIdentity.IsFlat", "`LidIdentity.*`", "`LidIdentity.Is…`", "12 radii (kFarRatio)",
    "`RankinePanel::area`", "`./run test --full`", "decision 0001", "`DB.h5`, `SHIP.toml`",
    "`build/bem/Lid2.h`", "`btRigidBody::setMassProps`, of Bullet",
    "\n```cpp\nRankinePanel lid;\n```\n")
WRONG = (
    "`Lit.h`", "`green/Lid.h`", "hydro/green/Lid.h", "`hydro/gren/`", "[lid](hydro/Lid.h)",
    "`lit_*.cpp`",
    "LidIdentity.IsRound", "`LitIdentity.*`", "`LidIdentity.Was…`", "20 radii (kNearRadii)",
    "`RankinePanel::width`", "`RankinPanel`", "`./run test --whole`", "decision 0003",
    "`far_ratio_of`", "`CUTWATER_NO_SUCH`",
    "\n```cpp\nRankinPanel lid;\n```\n", "\n    RankinPanel lid;\n")


def planted(check, path, text):
    with tempfile.TemporaryDirectory() as root:
        for name, content in {**TREE, path: text}.items():
            os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
            with open(os.path.join(root, name), "w", encoding="utf-8") as file:
                file.write(content)
        return list(check.faults(root))


class Refuse(unittest.TestCase):
    def test_right_names_in_prose_are_allowed(self):
        for text in RIGHT:
            self.assertEqual(planted(prose_names, "README.md", text), [], text)

    def test_wrong_names_in_prose_are_refused(self):
        for text in WRONG:
            self.assertEqual(len(planted(prose_names, "README.md", text)), 1, text)

    def test_wrong_names_in_comments_are_refused(self):
        for text in ("// as in Lit.h", "/// beyond kNearRadii"):
            self.assertEqual(len(planted(prose_names, "plugin/Ship.h", text)), 1, text)

    def test_wide_lines_are_refused_and_characters_are_counted(self):
        self.assertEqual(planted(line_width, "plugin/Ship.h", "//" + "ω" * 98), [])
        self.assertEqual(planted(line_width, "plugin/Ship.h", "//" + "η̇" * 98), [])
        self.assertEqual(len(planted(line_width, "plugin/Ship.h", "//" + "ω" * 99)), 1)
        self.assertEqual(len(planted(line_width, "tests/CMakeLists.txt", "#" * 101)), 1)

    def test_torn_formulas_and_numbers_are_refused(self):
        for text in ("/// a = b +\n/// c", "// is ω <\n// 0", "// at 1.5\n// rad/s",
                     "// 3 to 5\n// %,", "// with ω\n// = 3",
                     "int a;  ///< of 1e-3\n        ///< m³"):
            self.assertEqual(len(planted(line_breaks, "plugin/Ship.h", text)), 1, text)
        self.assertEqual(len(planted(line_breaks, "tests/CMakeLists.txt", "# 20\n# s")), 1)
        for text in ("/// a = b +\nint c;", "// at 1.5 rad/s\n// and", "// of (4)\n// m is",
                     "// F(X) is\n//   = 2", "int a;  // 5\nint m;", "// in 1984\n// the",
                     "// 20\n// seconds", "// it −\n"):
            self.assertEqual(planted(line_breaks, "plugin/Ship.h", text), [], text)

    def test_words_of_old_are_refused(self):
        for text in ("every how manieth", "It is had by", "ways to have it", "the speed of now"):
            self.assertEqual(len(planted(plain_words, "plugin/Ship.h", "// " + text)), 1, text)
        self.assertEqual(planted(plain_words, "plugin/Ship.h", "// They have its ends."), [])

    def test_a_ship_is_it(self):
        self.assertEqual(planted(plain_words, "README.md", "The ship and its sheer there."), [])
        for text in ("She rolls.", "`her` course"):
            self.assertEqual(len(planted(plain_words, "README.md", text)), 1, text)


if __name__ == "__main__":
    unittest.main()
