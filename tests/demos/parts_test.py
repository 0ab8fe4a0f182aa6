"""parts_test.py COMMAND DATABASE: the parts of the load as the command shows them.

Columns, lines on stderr, switches.
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest

COMMAND, DATABASE = (os.path.abspath(a) for a in sys.argv[1:3])
PARTS = ["gravity", "wetted_pressure", "restoring", "froude_krylov", "diffraction", "radiation",
         "added_mass", "supplementary", "autopilots", "hull_lift", "resistance"]
OF_FREE_SHIPS = ["hull_lift", "resistance"]
RUN = f"""database = "{DATABASE}"
[bullet]
duration = 20.0
[waves]
type = "regular"
omega = 0.8
ramp = 1.0
"""


class Parts(unittest.TestCase):
    def simulate(self, motion="", *options):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "run.toml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(RUN + "[motion]\n" + motion)
            return subprocess.run([COMMAND, "simulate", path, *options], capture_output=True,
                                  text=True, check=False)

    def rows(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(done.stdout.splitlines()))

    def test_columns_are_those_of_the_parts_in_order(self):
        def columns(motion):
            return list(self.rows(self.simulate(motion, "--forces"))[0])[14:]

        def of(parts):
            return [f"{part}_F{j}" for part in parts for j in range(1, 7)]

        self.assertEqual(columns(""), of(PARTS))  # a run is of a free ship
        self.assertEqual(columns('mean = "free"\n'), of(PARTS))
        coasting = [part for part in PARTS if part not in OF_FREE_SHIPS]
        self.assertEqual(columns("resistance = false\nhull_lift = false\n"), of(coasting))
        linear = [part for part in PARTS if part != "wetted_pressure"]
        self.assertEqual(columns('mode = "linear"\n'), of(linear))
        fixed = [part for part in coasting if part in linear]
        self.assertEqual(columns('mean = "fixed"\n'), of(fixed))

    def test_the_wetted_pressure_takes_the_place_of_restoring_and_froude_krylov(self):
        rows = self.rows(self.simulate("", "--forces"))
        for row in rows:
            self.assertEqual(float(row["restoring_F3"]), 0.0)
            self.assertEqual(float(row["froude_krylov_F3"]), 0.0)
        # It carries the ship: its mean is the weight, but for heave's acceleration (2 %).
        mean = sum(float(row["wetted_pressure_F3"]) for row in rows) / len(rows)
        self.assertAlmostEqual(-mean / float(rows[0]["gravity_F3"]), 1.0, delta=0.02)

    def test_each_part_says_its_mean_and_what_it_costs(self):
        done = self.simulate("", "--forces")
        rows = self.rows(done)
        lines = [line for line in done.stderr.splitlines() if ": mean" in line]
        self.assertEqual([line.split(":")[0] for line in lines], PARTS)
        heave = sum(float(row["radiation_F3"]) for row in rows) / len(rows)
        radiation = lines[PARTS.index("radiation")]
        printed = float(radiation.split()[4].rstrip(","))
        self.assertAlmostEqual(printed, heave, delta=1e-4 * abs(heave))
        self.assertIn("ns a tick", radiation)
        self.assertNotIn("ns a tick", lines[0])  # gravity is Bullet's
        self.assertNotIn("mean", self.simulate().stderr)

    def test_a_part_that_is_switched_off_has_no_load_and_the_motion_is_another(self):
        with_all = self.rows(self.simulate("", "--forces"))
        without = self.rows(self.simulate('without = ["radiation"]\n', "--forces"))
        self.assertTrue(all(float(row["radiation_F3"]) == 0.0 for row in without))
        self.assertTrue(any(float(row["radiation_F3"]) != 0.0 for row in with_all))
        self.assertNotEqual([row["z"] for row in with_all], [row["z"] for row in without])

    def test_a_part_that_there_is_not_is_refused_by_file_field_and_name(self):
        for motion, words in (
                ('without = ["sail"]\n', ["run.toml", "without", '"sail"', "radiation"]),
                ('without = ["gravity"]\n', ["run.toml", "without", "gravity"]),
                ('without = "radiation"\n', ["run.toml", "[motion] without", "list"])):
            done = self.simulate(motion)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stdout, "")
            for word in words:
                self.assertIn(word, done.stderr.strip().splitlines()[-1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
