"""line_breaks.py ROOT: comments do not tear formulas and numbers apart at the end of a line.

A line of a comment does not end in an operator when the comment goes on, and not in a number whose
unit begins the next line. It does not begin with an operator either, unless it is indented, as the
second line of a formula that is set apart is.
"""
import re
import sys

import tree

OPERATOR = re.compile(r"(?:^|\s)(?:[=+−×·/<>≤≥≈≪≫]|<=|>=)$")
BEGINNING = re.compile(r"(?:[=+×·<>≤≥≈≪≫]|<=|>=) ")
NUMBER = re.compile(r"(?:^|[\s(\[±~≈<>≤≥=])[−-]?\d[\d.,]*(?:e-?\d+)?(?:[–-]\d[\d.,]*)?$")
UNIT = re.compile(r"(?:%|°|(?:m|mm|cm|km|s|ms|µs|ns|kg|t|N|J|W|Pa|Hz|rad|deg|kn|B|kB|MB|GB|panels)"
                  r"(?:[²³]|/\w+[²³]?|·\w+[²³]?)*(?![\w']))")


def comment(line, mark):
    """The text of a line's comment, or None; of a line of its own, whether that is all there is."""
    found = re.match(rf"(.*?)(?:^|(?<=\s)){mark}(?: (.*))?$", line)
    if found is None:
        return None, False
    return (found.group(2) or "").rstrip(), not found.group(1).strip()


def torn(text, after):
    """What is wrong between two lines of one comment, or None."""
    if OPERATOR.search(text):
        return "ends in an operator"
    if BEGINNING.match(after):
        return "is followed by one that begins with an operator"
    if NUMBER.search(text) and UNIT.match(after.strip()):
        return "ends in a number whose unit is on the next line"
    return None


def faults(root):
    for path in tree.files(root, tree.CODE + tree.SCRIPTS):
        mark = r"//[/!]?<?" if path.endswith(tree.CODE) else "#"
        lines = [comment(line, mark) for line in tree.read(root, path).split("\n")]
        for number, ((text, _), (after, alone)) in enumerate(zip(lines, lines[1:]), 1):
            what = torn(text, after) if text and after and alone else None
            if what:
                yield f"{path}:{number}: {what}: {text}"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), "comments torn apart")
