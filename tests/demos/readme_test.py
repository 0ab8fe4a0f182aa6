"""readme_test.py ROOT: the program in the README is the program that is built and run."""
import os
import sys

root = sys.argv[1]
readme = open(os.path.join(root, "README.md"), encoding="utf-8").read()
program = open(os.path.join(root, "demos/scenes/hello_ship.cpp"), encoding="utf-8").read()
sys.exit(None if program in readme else "README.md does not quote demos/scenes/hello_ship.cpp as it is")
