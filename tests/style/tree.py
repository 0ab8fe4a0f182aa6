"""The project's own text files, for the checks of style beside this file."""
import os

FOLDERS = ("plugin", "hydro", "meshes", "demos", "docs", "tests", ".ci")
CODE = (".h", ".cpp")
SCRIPTS = (".py", ".cmake", ".sh", ".gp", ".toml", ".in", "CMakeLists.txt", "packages.txt")
WEB = (".js", ".mjs", ".css", ".html")
PROSE = (".md",)
SKIPPED = ("__pycache__", "node_modules")


def files(root, endings):
    """Paths from the root of the files with one of these endings; `run` counts as .sh."""
    found = [name for name in os.listdir(root) if os.path.isfile(os.path.join(root, name))]
    for folder in FOLDERS:
        for where, folders, names in os.walk(os.path.join(root, folder)):
            folders[:] = [name for name in folders if name not in SKIPPED]
            found += [os.path.relpath(os.path.join(where, name), root) for name in names]
    if ".sh" in endings:
        endings = (*endings, "run")
    return sorted(path for path in found if path.endswith(tuple(endings)))


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def report(faults, what):
    """Prints the faults and ends the program: 1 if there are any."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} {what}")
    raise SystemExit(1 if faults else 0)
