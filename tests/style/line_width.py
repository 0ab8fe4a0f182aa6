"""line_width.py ROOT: no line of a source or script, comments included, is longer than 100 columns.

Characters are counted as they are seen, not bytes: ω is one, and so is η̇ with its dot. Prose (*.md)
may have long lines, for its tables.
"""
import sys
import unicodedata

import tree

WIDEST = 100


def width(line):
    return sum(not unicodedata.combining(letter) for letter in line)


def faults(root):
    for path in tree.files(root, tree.CODE + tree.SCRIPTS + tree.WEB):
        for number, line in enumerate(tree.read(root, path).split("\n"), 1):
            if width(line) > WIDEST:
                yield f"{path}:{number}: {width(line)} columns"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), f"lines over {WIDEST} columns")
