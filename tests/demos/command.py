"""What the tests of the command share. The first argument of each is the command."""
import csv
import io
import os
import subprocess
import sys
import tempfile
import unittest

COMMAND = os.path.abspath(sys.argv[1])


def call(*arguments):
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)


def table(*arguments):
    """The rows of a CSV on stdout."""
    done = call(*arguments)
    assert done.returncode == 0, done.stderr
    return list(csv.DictReader(io.StringIO(done.stdout)))


class InFolder(unittest.TestCase):
    """Tests with files in a folder of their own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        """The path of a file there, written if there is a text."""
        full = os.path.join(self.folder.name, name)
        if text is not None:
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)
        return full
