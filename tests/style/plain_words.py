"""plain_words.py ROOT: words that a newcomer stumbles over. A ship is "it"."""
import re
import sys

import tree

# Words: (endings of the files, what to do instead).
WORDS = {
    r"she|hers?|herself": (tree.CODE + tree.SCRIPTS + tree.PROSE, "a ship is \"it\""),
    r"manieth|resounds": (tree.CODE + tree.SCRIPTS + tree.PROSE, "every n-th; resonates"),
    r"(?:is|are|was|were|be|being) had|have it": (
        tree.CODE + tree.PROSE, "is obtained, gives, contains"),
    r"of now|none the less": (tree.CODE + tree.PROSE, "present; all the same"),
    r"whence|thence|thereof|therefrom|whereof|whereby|thereupon|hitherto|forthwith|hath|unto": (
        tree.CODE + tree.SCRIPTS + tree.PROSE, "an everyday word"),
    r"not installed": ((".h",), "the folder or the CMake list says so"),
}


def faults(root):
    for words, (endings, instead) in WORDS.items():
        rule = re.compile(rf"\b({words})\b", re.IGNORECASE)
        for path in tree.files(root, endings):
            if path.startswith("tests/style/"):
                continue
            for number, line in enumerate(tree.read(root, path).split("\n"), 1):
                for word in rule.findall(line):
                    yield f"{path}:{number}: \"{word}\": {instead}"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), "words to be replaced")
