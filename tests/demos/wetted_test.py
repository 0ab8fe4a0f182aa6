"""wetted_test.py COMMAND DATABASE: what of the hull is wet, as simulate --wetted writes it.

And what simulate and sweep say of the hull that the waves press on.
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest

COMMAND, DATABASE = (os.path.abspath(a) for a in sys.argv[1:3])
COLUMNS = ["wetted_area", "submerged_volume", "buoyancy_x", "buoyancy_y", "buoyancy_z", "immersion"]
RUN = """database = "DATABASE"
[bullet]
duration = DURATION
[waves]
WAVES
[motion]
MOTION
"""
# 10 m x 4 m x 2 m, half in the water, without a deck.
OPEN_BOX = """v -5 -2 -1
v -5 -2 1
v -5 2 -1
v -5 2 1
v 5 -2 -1
v 5 -2 1
v 5 2 -1
v 5 2 1
f 1 3 7 5
f 1 5 6 2
f 3 4 8 7
f 5 7 8 6
f 1 2 4 3
"""
REGULAR = 'type = "regular"\nomega = 2.0\nramp = 0.0\n'


class Wetted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def call(self, *arguments):
        return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False,
                              cwd=self.folder)

    def run_file(self, motion, waves="", duration=0.2, database=DATABASE):
        text = (RUN.replace("DATABASE", database).replace("WAVES", waves)
                .replace("DURATION", str(duration)).replace("MOTION", motion))
        with open(os.path.join(self.folder, "run.toml"), "w", encoding="utf-8") as file:
            file.write(text)
        return "run.toml"

    def simulate(self, motion, *options, **run):
        return self.call("simulate", self.run_file(motion, **run), *options)

    def first(self, start):
        done = self.simulate(f"start = {{ {start} }}\n", "--wetted")
        self.assertEqual(done.returncode, 0, done.stderr)
        row = next(csv.DictReader(done.stdout.splitlines()))
        return {name: float(value) for name, value in row.items()}

    def info(self):
        rows = csv.DictReader(self.call("info", DATABASE).stdout.splitlines())
        return {row["name"]: row["value"] for row in rows}

    def test_columns_come_after_the_motions_and_before_the_parts(self):
        done = self.simulate("", "--wetted", "--forces")
        self.assertEqual(done.returncode, 0, done.stderr)
        header = done.stdout.splitlines()[0].split(",")
        self.assertEqual(header[14:20], COLUMNS)
        self.assertEqual(header[20], "gravity_F1")
        self.assertIn("wetted_pressure_F6", header)

    def test_a_ship_at_rest_displaces_its_weight_below_its_centre_of_gravity(self):
        """0.1 %: what may differ without a warning (PressureHull); of the centre, of the length."""
        row, info = self.first("z = 0.0"), self.info()
        displaced = row["submerged_volume"] * float(info["density"])
        self.assertAlmostEqual(displaced / float(info["mass"]), 1.0, delta=1e-3)
        self.assertAlmostEqual(row["buoyancy_x"] - row["x"], 0.0, delta=0.1)
        self.assertAlmostEqual(row["buoyancy_y"], 0.0, delta=1e-3)
        self.assertLess(row["buoyancy_z"], 0.0)
        self.assertEqual(row["immersion"], 1.0)

    def test_in_the_air_nothing_is_wet_and_deep_down_all_is(self):
        """The centre of a body that is wholly in the water moves with it: no wave reaches there."""
        rest, air = self.first("z = 0.0"), self.first("z = 50.0")
        for name in ("wetted_area", "submerged_volume", "immersion"):
            self.assertEqual(air[name], 0.0)
        deep, deeper = self.first("z = -100.0"), self.first("z = -200.0")
        self.assertGreater(deep["submerged_volume"], 2.0 * rest["submerged_volume"])
        self.assertGreater(deep["wetted_area"], 2.0 * rest["wetted_area"])
        self.assertEqual(deep["immersion"], 1.0)
        for name in ("submerged_volume", "wetted_area"):
            self.assertAlmostEqual(deep[name] / deeper[name], 1.0, delta=1e-9)
        self.assertAlmostEqual(deep["buoyancy_z"] - deeper["buoyancy_z"], 100.0, delta=1e-6)

    def test_linear_mode_has_no_such_columns(self):
        for motion in ('mode = "linear"\n', 'mean = "fixed"\n'):
            done = self.simulate(motion, "--wetted")
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stdout, "")
            lines = done.stderr.strip().splitlines()
            self.assertEqual(len(lines), 1, done.stderr)
            for word in ("run.toml", "--wetted", "linear", "nonlinear"):
                self.assertIn(word, lines[0])

    def warnings(self, done):
        """Of the triangles: what else is told of this hull is left out."""
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line for line in done.stderr.splitlines()
                if "warning" in line and "the hull displaces" not in line]

    def test_too_few_triangles_for_the_waves_are_warned_of(self):
        """Waves of 15 m on a hull of 124 m: triangles must be shorter than (kh)²/12 = 0.05, 2 m."""
        lines = self.warnings(self.simulate("hull_triangles = 100\n", waves=REGULAR))
        self.assertEqual(len(lines), 1, lines)
        for word in ("run.toml", "hull_triangles = 100", "% of their pressure", "give more"):
            self.assertIn(word, lines[0])
        self.assertEqual(self.warnings(self.simulate("", waves=REGULAR.replace("2.0", "0.6"))), [])
        coarse = ('mode = "nonlinear"\nhull_triangles = 100\nrestrain = [1, 2, 3, 4, 5, 6]\n')
        waves = REGULAR.replace("2.0", "[0.6, 2.0]")
        lines = self.warnings(self.call("sweep", self.run_file(coarse, waves, 45.0)))
        self.assertEqual(len(lines), 1, lines)
        for word in ("run.toml", "hull_triangles = 100", "omega = 2"):
            self.assertIn(word, lines[0])

    def test_a_profile_that_nothing_reads_is_warned_of(self):
        waves = REGULAR.replace("2.0", "0.6") + 'profile = "wheeler"\n'
        lines = self.warnings(self.simulate('mode = "linear"\n', waves=waves))
        self.assertEqual(len(lines), 1, lines)
        for word in ("run.toml", 'profile = "wheeler"', "no effect", "linear"):
            self.assertIn(word, lines[0])
        self.assertEqual(self.warnings(self.simulate("", waves=waves)), [])
        lines = self.warnings(self.call("sweep", self.run_file("restrain = [2, 4, 6]\n", waves,
                                                               45.0)))
        self.assertTrue(any('profile = "wheeler"' in line for line in lines), lines)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def test_a_hull_that_is_open_is_linear_and_says_so(self):
        # Little above water is left to close it by: it is no bowl.
        self.write("box.obj", OPEN_BOX.replace(" 1\nv", " 0.02\nv").replace(" 1\nf", " 0.02\nf", 1))
        self.write("box.toml", """[hull]
mesh = "box.obj"
panels = 100
symmetric = "none"
[mass]
cog = [0.0, 0.0, 0.0]
gyradii = [1.0, 3.0, 3.0]
[solve]
omega = { from = 0.2, to = 5.2, step = 0.2 }
""")
        done = self.call("solve", "box.toml", "-o", "box.h5")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = self.warnings(self.simulate("", database="box.h5"))
        self.assertEqual(len(lines), 1, lines)
        for word in ("run.toml", "linear", "box.h5", "no closed hull"):
            self.assertIn(word, lines[0])
        self.assertEqual(self.warnings(self.simulate('mode = "linear"\n', database="box.h5")), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
