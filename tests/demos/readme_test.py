"""readme_test.py ROOT: the program in the README is the one that is built and run."""
import os
import sys

root = sys.argv[1]
with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
    readme = file.read()
with open(os.path.join(root, "demos/scenes/first_ship.cpp"), encoding="utf-8") as file:
    program = file.read()
program = program[program.index("#include"):]  # without the comment on top
# ... and without the marks by which the manual quotes it
program = "".join(line for line in program.splitlines(True) if not line.strip().startswith("//! ["))
sys.exit(None if program in readme else "README.md does not quote first_ship.cpp as it is")
