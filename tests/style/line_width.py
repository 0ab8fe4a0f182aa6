"""line_width.py ROOT: no line of a source or script, comments included, is longer than 100 columns.

Characters are counted, not bytes: a formula's letters count one each. Prose (*.md) may have long
lines, for its tables.
"""
import sys

import tree

WIDEST = 100


def faults(root):
    for path in tree.files(root, tree.CODE + tree.SCRIPTS):
        for number, line in enumerate(tree.read(root, path).split("\n"), 1):
            if len(line) > WIDEST:
                yield f"{path}:{number}: {len(line)} columns"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), f"lines over {WIDEST} columns")
