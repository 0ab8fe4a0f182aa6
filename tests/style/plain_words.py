"""plain_words.py ROOT: words that a newcomer stumbles over. A ship is "it".

Quotations from other people's titles are left alone by keeping the list short.
"""
import re
import sys

import tree

WORDS = {
    r"she|hers?|herself": "a ship is \"it\"",
    r"not installed": "say who includes it, or put it where its folder says so",
}


def faults(root):
    rules = [(re.compile(rf"\b({words})\b", re.IGNORECASE), why) for words, why in WORDS.items()]
    for path in tree.files(root, tree.CODE + tree.SCRIPTS + tree.PROSE):
        if path.startswith("tests/style/"):
            continue
        for number, line in enumerate(tree.read(root, path).split("\n"), 1):
            for rule, why in rules:
                for word in rule.findall(line):
                    yield f"{path}:{number}: \"{word}\": {why}"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), "words to be replaced")
