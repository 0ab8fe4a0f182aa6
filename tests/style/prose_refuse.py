"""prose_refuse.py: the checks of prose, words and line width refuse what they are there to refuse.

Plants one fault at a time in a small tree, and one right name of each kind.
"""
import os
import tempfile
import unittest

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

    def test_a_ship_is_it(self):
        self.assertEqual(planted(plain_words, "README.md", "The ship and its sheer there."), [])
        for text in ("She rolls.", "`her` course"):
            self.assertEqual(len(planted(plain_words, "README.md", text)), 1, text)


if __name__ == "__main__":
    unittest.main()
