"""stability_test.py COMMAND FOLDER MESHES: speeds at which a ship's own motions grow.

A launch with an immersed transom steams off by itself in the report's form of the speed terms; in
Tuck's it keeps its speed.
"""
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

COMMAND, FOLDER, MESHES = (os.path.abspath(argument) for argument in sys.argv[1:4])

SHIP = f"""[hull]
mesh = "{FOLDER}/transom_launch.obj"
panels = 120
[mass]
cog = [-2.2, 0.0, 0.3]
[solve]
FORM
omega = {{ from = 0.2, to = 5.0, step = 0.2 }}
"""
RUN = """database = "launch.h5"
[bullet]
duration = 100.0
[waves]
type = "none"
[motion]
mean = "fixed"
speed = 3.5
restrain = [2, 3, 4, 5, 6]
start = { u = 0.1 }
"""


def call(*arguments, folder):
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False,
                          cwd=folder)


class Launch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def solve(self, form=""):
        ship = self.write("launch.toml", SHIP.replace("FORM", form))
        done = call("solve", ship, "-o", "launch.h5", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def simulate(self, text):
        return call("simulate", self.write("run.toml", text), folder=self.folder)

    def info(self):
        text = call("info", "launch.h5", folder=self.folder).stdout
        return {row["name"]: row["value"] for row in csv.DictReader(io.StringIO(text))}

    def last_speed(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        return float(list(csv.DictReader(io.StringIO(done.stdout)))[-1]["u"])

    def test_the_reports_form_is_refused_where_it_grows(self):
        self.assertIn("in surge", self.solve('forward_speed = "report"'))
        names = self.info()
        self.assertEqual(names["unstable_above_mode"], "surge")
        self.assertLess(float(names["unstable_above"]), 0.5)
        done = self.simulate(RUN)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        for word in ("run.toml", "speed = 3.5", "unstable above", "surge", "tuck",
                     "allow_unstable"):
            self.assertIn(word, done.stderr)
        # On request it runs, with a warning, and does what was said. 25 s: e-fold in 6 s.
        short = RUN.replace("duration = 100.0", "duration = 25.0")
        done = self.simulate(short + "allow_unstable = true\n")
        self.assertIn("unstable above", done.stderr)
        # A warning speaks once: what, its name, since when, in how many of the ticks.
        lines = [line for line in done.stderr.splitlines() if "kSpeedOutsideTheory" in line]
        self.assertEqual(len(lines), 1, done.stderr)
        for word in ("warning: run.toml: ", "outside the theory", "first at t = 0 s",
                     "in 1251 ticks"):
            self.assertIn(word, lines[0])
        self.assertGreater(self.last_speed(done), 5.0)
        # With surge held nothing grows.
        held = RUN.replace("restrain = [2, 3, 4, 5, 6]", "restrain = [1]")
        self.assertEqual(self.simulate(held).returncode, 0)

    def test_a_run_that_breaks_leaves_the_rows_before_and_fails(self):
        """A speed that grows e-fold in 6 s ends at numbers that single precision cannot hold."""
        self.solve('forward_speed = "report"')
        growing = RUN.replace("duration = 100.0", "duration = 2000.0\ndouble = false\nsubsteps = 3")
        self.write("run.toml", growing + "allow_unstable = true\n")
        for arguments in (["-o", "run.csv"], []):
            done = call("simulate", "run.toml", *arguments, folder=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            lines = done.stderr.strip().splitlines()
            self.assertEqual(sum("kSpeedOutsideTheory" in line for line in lines), 1)
            last = lines[-1]
            self.assertIn("run.toml: ", last)
            self.assertRegex(last, r"\(k(Load|State)NotFinite.*\) at t = [0-9.]+ s; the run ended")
            self.assertEqual(len([line for line in lines if "NotFinite" in line]), 1)
            text = done.stdout
            if arguments:
                self.assertEqual(text, "")
                with open(os.path.join(self.folder, "run.csv"), encoding="utf-8") as file:
                    text = file.read()
            self.assertTrue(text.endswith("\n"))
            rows = list(csv.DictReader(io.StringIO(text)))
            broke = float(re.search(r"at t = ([0-9.]+) s; the", last)[1])
            # 0.02 s a tick; what broke at the end of a tick is seen at the beginning of the next.
            self.assertAlmostEqual(float(rows[-1]["t"]), broke - 0.02, delta=1e-3)
            self.assertIn(f"{len(rows)} rows before it", last)
            # Before the last tick, in which numbers of this size have any sign.
            self.assertGreater(float(rows[-2]["x"]), 1e9)
            for row in rows[::100] + rows[-2:]:
                self.assertTrue(all(math.isfinite(float(value)) for value in row.values()))

    def test_a_sweep_names_the_waves_whose_runs_broke_and_fails(self):
        """A wave of more surge grows to the end of the numbers earlier."""
        self.solve('forward_speed = "report"')
        text = (RUN.replace('"none"', '"regular"\nomega = [0.5, 3.0]\nramp = 1.0')
                .replace("start = { u = 0.1 }", "allow_unstable = true")
                .replace("duration = 100.0", "duration = DURATION\ndouble = false"))

        def sweep(duration):
            self.write("sweep.toml", text.replace("DURATION", str(duration)))
            done = call("sweep", "sweep.toml", folder=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            lines = done.stderr.strip().splitlines()
            warned = [line for line in lines if "kSpeedOutsideTheory" in line]
            self.assertEqual(len(warned), 1)
            self.assertIn("of 2 of 2 runs", warned[0])
            ran = [line for line in lines if "surge" in line and "no harmonic" in line]
            times = dict(re.findall(r"omega = ([0-9.]+): [^:]*?NotFinite[^:]*? at t = ([0-9.]+) s",
                                    lines[-1]))
            rows = list(csv.DictReader(io.StringIO(done.stdout)))
            self.assertEqual(len(rows), 12)
            self.assertEqual(len(ran) + len(times), 2, done.stderr)
            for row in rows:
                # Surge that grew is no answer to a wave, even where the run did not break.
                if row["omega"] in times or row["j"] == "1":
                    self.assertEqual(row["time_amplitude"], "nan")
                self.assertTrue(math.isfinite(float(row["freq_amplitude"])))
            return {omega: float(time) for omega, time in times.items()}

        times = sweep(2000)
        self.assertEqual(sorted(times), ["0.5", "3"])
        between = 0.5 * sum(times.values())
        self.assertEqual(len(sweep(between)), 1)

    def test_a_sweep_without_any_harmonic_motion_fails(self):
        self.solve('forward_speed = "report"')
        text = (RUN.replace('"none"', '"regular"\nomega = [0.5, 3.0]\nramp = 1.0')
                .replace("start = { u = 0.1 }", "allow_unstable = true")
                .replace("duration = 100.0", "duration = 60.0"))
        self.write("sweep.toml", text)
        done = call("sweep", "sweep.toml", folder=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        lines = done.stderr.strip().splitlines()
        for omega in ("0.5", "3"):
            warned = [line for line in lines if f"[waves] omega = {omega}: surge: " in line]
            self.assertEqual(len(warned), 1, done.stderr)
            self.assertIn("written as nan", warned[0])
        self.assertIn("sweep.toml: [motion]: in no wave a motion was harmonic", lines[-1])
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        self.assertEqual(len(rows), 12)
        self.assertTrue(all(row["time_amplitude"] == "nan" for row in rows if row["j"] == "1"))

    def test_tucks_form_is_the_default_and_keeps_the_speed(self):
        self.solve()
        names = self.info()
        self.assertEqual(names["forward_speed"], "tuck")
        self.assertEqual(names["x_derivatives"], "0")
        self.assertEqual(names["course_stable"], "1")
        # 3.6 m/s at the start; the waves that getting under way made take a little.
        self.assertAlmostEqual(self.last_speed(self.simulate(RUN)), 3.6, delta=0.02)

    def test_the_reports_form_of_a_file_in_tucks_is_refused_by_name(self):
        self.solve()
        done = call("coefficients", "launch.h5", "--speed", "3", "--form", "report",
                    folder=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("forward_speed", done.stderr)
        rows = list(csv.DictReader(io.StringIO(
            call("coefficients", "launch.h5", folder=self.folder).stdout)))
        entry = {(row["omega"], row["j"], row["k"]): row for row in rows}
        self.assertEqual(entry["0.4", "5", "3"]["dA_dx"], entry["0.4", "3", "3"]["A"])  # T_53 = 1
        self.assertEqual(float(entry["0.4", "6", "2"]["dB_dx"]),
                         -float(entry["0.4", "2", "2"]["B"]))

    # With the roll damping of its hull and keels. Without any the report's form makes it roll.
    def test_frigate_is_stable_to_20_m_s_in_either_form(self):
        for form in ("tuck", "report"):
            ship = self.write("f.toml", f"""[hull]
mesh = "{MESHES}/frigate/frigate_224.obj"
[mass]
cog = [-2.4044, 0.0, 1.29]
[solve]
forward_speed = "{form}"
omega = {{ from = 0.1, to = 4.0, step = 0.1 }}
[supplementary]
roll_damping = 2.0e7
""")
            done = call("solve", ship, "-o", "launch.h5", folder=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = self.info()
            self.assertEqual(names["unstable_above"], "none")
            self.assertGreater(float(names["stability_checked_to"]), 20.0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
