"""prose_names.py ROOT: what the prose names is there.

In every *.md: files and folders, links, numbers of decisions, test suites and tests, constants
(kName), and in code every identifier with a capital or an underscore inside and every --option,
must exist. In comments of .h and .cpp: files and constants. The CHANGELOG and decisions that were
superseded tell of the past; there only links count.
"""
import os
import re
import sys

import tree

FILE = re.compile(r"(?<![\w./<>*-])[\w./*-]*[\w*]\.(?:h|cpp|md|py|cmake|toml|txt|gp|obj)\b(?!\.\w)")
FOLDER = re.compile(r"(?<![\w./<-])(?:plugin|hydro|meshes|demos|docs|tests)/[\w./-]*")
KIND = "ClosedForm|Identity|Convergence|Verification|Regression"
SUITE = re.compile(rf"\b([A-Z]\w*(?:{KIND}))(?:\.([A-Z]\w*|\*))?(…)?")
CONSTANT = re.compile(r"\bk[A-Z][a-z]\w*\b")
IDENTIFIER = re.compile(r"\b(?=\w*[a-z])(?:[A-Za-z]+\w*[a-z0-9][A-Z]\w*|[A-Za-z]\w{2,}_\w{2,})\b")
MACRO = re.compile(r"\bCUTWATER_[A-Z_]+\b")
QUALIFIED = re.compile(r"\b\w+(?:::\w+)+")
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]+")
DECISION = re.compile(r"\b(?:decisions? |and |to |\()(0\d{3})\b")
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
TEST = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)")

# Files that a reader makes by following the prose.
READERS_OWN = {"run.toml", "panels.obj", "frigate.obj"}
# Names of Bullet, the C++ library and CMake.
THEIRS = re.compile(r"(bt|CMAKE_)[A-Z]\w*|m_\w+|worldUserInfo|applyForce|std")
# Keys that are made of a mode and one of these; keys_test.py compares them with the program.
OF_MODES = re.compile(r"(?:surge|sway|heave|roll|pitch|yaw)_(?:damping|stiffness)")


class Project:
    """What there is to be named."""

    def __init__(self, root):
        self.root = root
        everything = tree.files(root, ("",))
        self.paths = set(everything)
        self.folders = {os.path.dirname(path) for path in everything}
        self.folders |= {part for folder in list(self.folders) for part in parents(folder)}
        self.words, self.tests = set(), {}
        for path in tree.files(root, tree.CODE + tree.SCRIPTS):
            text = tree.read(root, path)
            mark = r"//" if path.endswith(tree.CODE) else r"(?:^|\s)#(?!include)"
            code = re.sub(rf"{mark}.*", "", text, flags=re.MULTILINE)
            self.words |= set(re.findall(r"[A-Za-z_]\w*", code))
            self.words |= set(OPTION.findall(code))
            for suite, test in TEST.findall(code):
                self.tests.setdefault(suite, set()).add(test)
        self.paths_by_name = {}
        for path in everything:
            self.paths_by_name.setdefault(os.path.basename(path), []).append(path)

    def has_file(self, name):
        """By its path from the root, or by the end of that path; * stands for anything."""
        name = name.removeprefix("./")
        stem = os.path.basename(name).split(".")[0]
        if name in READERS_OWN or (stem.isupper() and not name.endswith(".md")):
            return True  # DB.h5, SHIP.toml: a placeholder
        if "*" in name:
            pattern = re.compile(r"(?:.*/)?" + re.escape(name).replace(r"\*", r"[^/]*") + "$")
            return any(pattern.match(path) for path in self.paths)
        return any(path == name or path.endswith("/" + name)
                   for path in self.paths_by_name.get(os.path.basename(name), []))

    def has_folder(self, name):
        return name.rstrip("/.") in self.folders or name.rstrip(".") in self.paths

    def has_test(self, suite, test, beginning):
        tests = self.tests.get(suite)
        if tests is None or test in ("", "*"):
            return tests is not None
        return any(name == test or (beginning and name.startswith(test)) for name in tests)


def parents(folder):
    while folder:
        yield folder
        folder = os.path.dirname(folder)


def code_of(text):
    """Everything set as code: `spans`, fenced and indented blocks."""
    fenced = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
    blocks = fenced.findall(text)
    rest = fenced.sub("", text)
    blocks += re.findall(r"^ {4,}\S.*$", rest, re.MULTILINE)
    return "\n".join(blocks + re.findall(r"`([^`\n]+)`", rest))


def of_the_past(path, text):
    return path == "CHANGELOG.md" or (
        path.startswith("hydro/decisions/") and "Status: superseded" in text)


def faults_of_prose(project, path, text):
    here = os.path.dirname(path)
    for link in LINK.findall(text):
        target = os.path.normpath(os.path.join(here, link))
        if "://" not in link and target not in project.paths | project.folders:
            yield f"link {link}"
    if of_the_past(path, text):
        return
    for number in DECISION.findall(text):
        if not any(name.startswith(f"hydro/decisions/{number}-") for name in project.paths):
            yield f"decision {number}"
    for suite, test, beginning in SUITE.findall(text):
        if not project.has_test(suite, test, beginning):
            yield f"test {suite}{'.' if test else ''}{test}"
    yield from faults_of_files_and_constants(project, LINK.sub("]", text))
    code = FILE.sub("", SUITE.sub("", code_of(text)))
    names = set(IDENTIFIER.findall(code)) | set(MACRO.findall(code)) | set(OPTION.findall(code))
    for parts in (name.split("::") for name in QUALIFIED.findall(code)):
        names = names - set(parts) if THEIRS.fullmatch(parts[0]) else names | set(parts)
    for name in sorted(names - project.words):
        if not THEIRS.fullmatch(name) and not OF_MODES.fullmatch(name):
            yield f"name {name}"


def faults_of_files_and_constants(project, text):
    for name in sorted(set(CONSTANT.findall(text)) - project.words):
        yield f"constant {name}"
    # Paths below these are made by ./run, and <layer> or NAME stand for any.
    text = re.sub(r"\b(?:build|out)[\w-]*/[\w./*-]*|https?://\S+|\S*<\w+>\S*", "", text)
    for name in sorted(set(FILE.findall(text))):
        if not project.has_file(name):
            yield f"file {name}"
    for name in sorted(set(FOLDER.findall(text))):
        if "*" not in name and not FILE.search(name) and not project.has_folder(name):
            yield f"folder {name}"


def faults(root):
    project = Project(root)
    for path in tree.files(root, tree.PROSE):
        for fault in faults_of_prose(project, path, tree.read(root, path)):
            yield f"{path}: {fault}"
    for path in tree.files(root, tree.CODE):
        comments = "\n".join(re.findall(r"//.*", tree.read(root, path)))
        for fault in faults_of_files_and_constants(project, comments):
            yield f"{path}: {fault}"


if __name__ == "__main__":
    tree.report(list(faults(sys.argv[1])), "names of nothing")
