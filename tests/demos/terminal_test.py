"""terminal_test.py COMMAND DATABASE SHIP.toml: what people see on a terminal, and files get."""
import os
import pty
import re
import subprocess
import sys
import unittest

from command import COMMAND, InFolder

DATABASE, SHIP = (os.path.abspath(a) for a in sys.argv[2:4])
RUN = f"""database = "{DATABASE}"
[bullet]
dt = 0.02
duration = 300.0
[waves]
type = "regular"
omega = 0.8
"""
SWEEP = RUN.replace("omega = 0.8", "omega = [0.5, 0.6, 0.7, 0.8]").replace("300.0", "120.0")


def on_terminal(arguments, stream):
    """What `stream`, "stdout" or "stderr", shows where it is a terminal of 80 columns."""
    ours, theirs = pty.openpty()
    other = {"stdout": "stderr", "stderr": "stdout"}[stream]
    with subprocess.Popen([COMMAND, *arguments],
                          **{stream: theirs, other: subprocess.DEVNULL}) as process:
        os.close(theirs)
        shown = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            shown += piece
    os.close(ours)
    assert process.returncode == 0, shown
    return shown.decode().replace("\r\n", "\n")


class Terminal(InFolder):
    def test_tables_are_aligned_for_people_and_csv_for_programs(self):
        for arguments in (["info", DATABASE], ["hydrostatics", SHIP]):
            done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=True)
            rows = done.stdout.splitlines()
            self.assertEqual(rows[0], "name,value,unit")
            shown = on_terminal(arguments, "stdout").splitlines()
            self.assertNotIn(",value,", "".join(shown))
            names = [line.split()[0] for line in shown if not line.startswith(" ")]
            self.assertEqual(names, [row.split(",")[0] for row in rows[1:]])
            column = max(len(name) for name in names) + 2
            self.assertEqual({line[column - 1] for line in shown}, {" "})
            self.assertTrue(all(len(line) > column and line[column] != " " for line in shown
                                if not line.startswith("file_") and "  " in line.strip()), shown)
            self.assertLess(max(len(line) for line in shown), 110)
            # Both are the same where a file is asked for.
            on_terminal([*arguments, "-o", self.path("t.csv")], "stdout")
            with open(self.path("t.csv"), encoding="utf-8") as file:
                self.assertEqual(file.read(), done.stdout)

    def test_a_run_shows_one_line(self):
        shown = on_terminal(
            ["simulate", self.path("run.toml", RUN), "-o", self.path("run.csv")], "stderr")
        lines = shown.split("\r\x1b[K")[1:]
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, r"^t = \d+/300 s, \d+x real time, \d+ s left, roll -?\d+\.\d "
                                   r"pitch -?\d+\.\d deg, heave -?\d+\.\d\d m")
            self.assertLess(len(line.strip()), 80)
        self.assertIn("t = 300/300 s", lines[-1])
        self.assertTrue(shown.endswith("\n"))

    def test_a_sweep_shows_one_line(self):
        shown = on_terminal(
            ["sweep", self.path("sweep.toml", SWEEP), "-o", self.path("sweep.csv")], "stderr")
        last = shown.split("\r\x1b[K")[-1]
        self.assertTrue(re.match(r"sweep: 4/4 frequencies, \d+ s, 0 s left\n", last), shown)

    def test_nothing_where_it_is_none(self):
        for command, text in (("simulate", RUN), ("sweep", SWEEP)):
            run = self.path("run.toml", text)
            done = subprocess.run([COMMAND, command, run, "-o", self.path("run.csv")],
                                  capture_output=True, text=True, check=True)
            self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
