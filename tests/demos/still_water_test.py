"""still_water_test.py COMMAND MESHES: `righting` and `buoyancy`, columns, messages and refusals."""
import csv
import io
import math
import os
import re
import sys
import tempfile
import unittest

from command import call

MESHES = os.path.abspath(sys.argv[2])
FRIGATE = f"{MESHES}/frigate/ship.toml"
RIGHTING = "heel_deg gz height trim_deg volume".split()
WEIGHT_OF_WATER = 1025 * 9.80665  # [N/m^3]


def table(*arguments):
    """Rows of numbers, and the lines on stderr."""
    done = call(*arguments)
    assert done.returncode == 0, done.stderr
    rows = csv.DictReader(io.StringIO(done.stdout))
    return [{k: float(v) for k, v in row.items()} for row in rows], done.stderr.splitlines()


def box(length, breadth, draught, freeboard, closed=True):
    """OBJ of a box amidships, calm water at z = 0."""
    x, y = length / 2, breadth / 2
    corners = [(sx * x, sy * y, z) for z in (-draught, freeboard)
               for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    faces = ["4 3 2 1", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"] + ["5 6 7 8"] * closed
    return "".join(f"v {a} {b} {c}\n" for a, b, c in corners) + "".join(f"f {f}\n" for f in faces)


class StillWater(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def box_ship(self, kg, mass="", waterline=0.0, shape=(60.0, 20.0, 8.0, 12.0), closed=True):
        self.write("box.obj", box(*shape, closed))
        cog = [0.0, 0.0, kg - shape[2] - waterline]
        return self.write("box.toml", f'[hull]\nmesh = "box.obj"\nwaterline = {waterline}\n'
                                      f"[mass]\ncog = {cog}\n{mass}\n")

    def refused(self, arguments, *words, code=1):
        out = os.path.join(self.folder, "out.csv")
        done = call(*arguments, "-o", out)
        self.assertEqual(done.returncode, code, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr.strip().splitlines()[-1])
        self.assertEqual(done.stdout, "")
        self.assertFalse(os.path.exists(out))

    # Nine digits are written, here and below.
    def test_levers_of_a_wall_sided_box(self):
        kg, bm = 7.0, 400 / 96
        for trim in ([], ["--trim", "free"], ["--trim", "fixed"]):
            rows, said = table("righting", self.box_ship(kg), "--heel", "-30:30:13", *trim)
            self.assertEqual(list(rows[0]), RIGHTING)
            self.assertEqual([row["heel_deg"] for row in rows], [5.0 * i for i in range(-6, 7)])
            for row in rows:
                heel = math.radians(row["heel_deg"])
                exact = (4 + bm - kg + 0.5 * bm * math.tan(heel) ** 2) * math.sin(heel)
                self.assertAlmostEqual(row["gz"], exact, delta=1e-8)
                self.assertAlmostEqual(row["volume"], 9600.0, delta=1e-5)
                self.assertAlmostEqual(row["trim_deg"], 0.0, delta=1e-8)
                # The middle of the waterline stays on the centre plane, 8 m above the keel: the
                # file's origin, in it, stays in the water.
                self.assertAlmostEqual(row["height"], 0.0, delta=1e-8)
            self.assertEqual(said, [])  # its gz grows up to 30 degrees

    def test_height_is_that_of_the_files_origin(self):
        self.write("box.obj", box(60.0, 20.0, 8.0, 12.0))
        for waterline in (0.0, 2.0):
            rows, _ = table("righting", self.box_ship(7.0, waterline=waterline), "--heel", "0:0:1")
            self.assertAlmostEqual(rows[0]["height"], -waterline, delta=1e-8)

    # tan^2 = -2 GM/BM; acceptance 0.001 deg.
    def test_loll_is_found_and_unstable_upright_is_warned_of(self):
        gm, bm = -0.5, 400 / 96
        loll = math.degrees(math.atan(math.sqrt(-2 * gm / bm)))
        ship = self.box_ship(4 + bm - gm)
        for heels, side in (("0:90:2", "starboard"), ("-90:0:2", "port"), ("0:5:2", "starboard")):
            _, said = table("righting", ship, "--heel", heels)
            self.assertIn("gm_t = -0.500 m", said[0])
            self.assertIn("warning", said[0])
            told = re.search(r"box.toml: it lies at rest at an angle of loll of (.+) deg to (.+)",
                             said[1])
            self.assertAlmostEqual(float(told[1]), loll, delta=0.001)
            self.assertEqual(told[2], side)

    # Twice the mass: T is 8 m instead of 4, GM 4 + 400/96 - 9 instead of 2 + 400/48 - 9.
    def test_gm_is_that_of_the_mass(self):
        ship = self.box_ship(9.0, f"mass = {2 * 4800 * 1025}", shape=(60.0, 20.0, 4.0, 16.0))
        rows, said = table("righting", ship, "--heel", "0:90:2")
        self.assertTrue(any("GM is -0.833 m" in line for line in said), said)
        self.assertTrue(any("angle of loll" in line for line in said), said)
        self.assertAlmostEqual(rows[0]["height"], -4.0, delta=1e-8)

    # box_gz_exact.csv: D 12 m, KG 7 m; 0.7495 m at 35 deg, falls through 0 between 65 and 70.
    def test_greatest_lever_and_where_it_vanishes(self):
        ship = self.box_ship(7.0, shape=(60.0, 20.0, 8.0, 4.0))
        rows, said = table("righting", ship, "--heel", "0:180:37")
        text = "\n".join(said)
        greatest = re.search(r"greatest gz ([0-9.]+) m at ([0-9.]+) deg", text)
        vanishes = float(re.search(r"gz vanishes at ([0-9.]+) deg", text)[1])
        self.assertGreaterEqual(float(greatest[1]), 0.7495)
        self.assertLess(abs(float(greatest[2]) - 35), 5)
        self.assertTrue(65 < vanishes < 70)
        at, _ = table("righting", ship, "--heel", f"{vanishes}:{vanishes}:1")
        self.assertLess(abs(at[0]["gz"]), 1e-4)  # three decimals of the angle
        self.assertAlmostEqual(rows[18]["gz"], -1.0, delta=1e-8)  # on its side
        _, said = table("righting", ship, "--heel", "0:30:4")
        self.assertEqual(said, [])

    # All attitudes, all kinds of hulls; odd in heel where the mesh is symmetric.
    def test_every_ship_at_every_heel(self):
        for name in ("frigate", "boat", "barge", "wigley", "sphere_oes"):
            rows, _ = table("righting", f"{MESHES}/{name}/ship.toml", "--heel", "-180:180:73")
            size = rows[0]["volume"] ** (1 / 3)
            for row, other in zip(rows, reversed(rows)):
                self.assertTrue(all(map(math.isfinite, row.values())))
                self.assertAlmostEqual(row["gz"], -other["gz"], delta=1e-6 * size, msg=name)
                self.assertAlmostEqual(row["volume"], rows[0]["volume"], delta=1e-6 * size ** 3)

    def test_righting_refuses(self):
        ship = self.box_ship(7.0)
        self.refused(["righting", self.box_ship(7.0, "mass = 4e7"), "--heel", "0:90:2"], "box.toml",
                     "mass = 4e+07 kg", "2.46e+07 kg", "24000 m^3", "sinks")
        opened = self.box_ship(7.0, closed=False)
        self.refused(["righting", opened, "--heel", "0:90:2"], "box.toml", "not closed", "deck")
        self.refused(["buoyancy", opened, "--heave", "0:1:2"], "box.toml", "not closed", "deck")
        self.refused(["righting", self.path_to("none.toml"), "--heel", "0:90:2"], "none.toml")
        for arguments, *words in (
                ([], "--heel is required"), (["--heel", "0:181:2"], "--heel 0:181:2", "180"),
                (["--heel", "9:3:2"], "A <= B"), (["--heel", "0:9"], "A:B:N"),
                (["--heel", "0:9:2.5"], "whole number"), (["--heel", "a:9:2"], "a:9:2")):
            done = call("righting", ship, *arguments)
            self.assertEqual(done.returncode, 2, arguments)
            for word in words:
                self.assertIn(word, done.stderr)
        self.assertEqual(call("righting", ship, "--heel", "0:9:2", "--trim", "loose").returncode, 2)

    def path_to(self, name):
        return os.path.join(self.folder, name)

    def test_buoyancy_of_a_box(self):
        ship = self.box_ship(7.0, shape=(60.0, 20.0, 8.0, 4.0))
        rows, _ = table("buoyancy", ship, "--heave", "-6:9:31")
        names = [f"F{j}" for j in range(1, 7)]
        self.assertEqual(list(rows[0]), ["value", *names, *("linear_" + n for n in names)])
        self.assertEqual([row["value"] for row in rows], [-6 + 0.5 * i for i in range(31)])
        for row in rows:
            depth = min(max(8 - row["value"], 0), 12)
            self.assertAlmostEqual(row["F3"] / (1200 * WEIGHT_OF_WATER), depth, delta=1e-7)
            linear = 1200 * WEIGHT_OF_WATER * (8 - row["value"])
            self.assertAlmostEqual(row["linear_F3"] / linear if linear else 1, 1, delta=1e-8)
        for row in table("buoyancy", ship, "--roll", "-20:20:9")[0]:
            roll, bm = math.radians(row["value"]), 400 / 96
            # What is left out of the linear load is cubic; 8: twice its coefficient here.
            arm = row["F4"] / (WEIGHT_OF_WATER * 9600)
            self.assertAlmostEqual(row["linear_F4"] / (WEIGHT_OF_WATER * 9600),
                                   -(4 + bm - 7) * roll, delta=1e-8)
            self.assertLess(abs(arm - -(4 + bm - 7) * roll), 8 * abs(roll) ** 3 + 1e-9)
        for row in table("buoyancy", ship, "--pitch", "-2:2:5")[0]:
            self.assertLess(abs(row["F4"]), 1e-3)
            self.assertLess(abs(row["F5"] / row["linear_F5"] - 1) if row["value"] else 0, 0.01)

    def test_a_frigates_buoyancy(self):
        rows, _ = table("buoyancy", FRIGATE, "--heave", "-8:6:29")
        self.assertEqual(rows[-1]["F3"], 0)
        self.assertEqual(rows[16]["value"], 0)
        self.assertAlmostEqual(rows[16]["F3"] / rows[16]["linear_F3"], 1, delta=1e-8)
        roll, _ = table("buoyancy", FRIGATE, "--roll", "-180:180:25")
        for row, other in zip(roll, reversed(roll)):
            for name in ("F1", "F2", "F6"):
                self.assertLess(abs(row[name]), 1e-6 * rows[16]["F3"])
            self.assertAlmostEqual(row["F4"], -other["F4"], delta=1e-6 * rows[16]["F3"])

    def test_buoyancy_takes_one_pose(self):
        for arguments in ([], ["--heave", "0:1:2", "--roll", "0:1:2"], ["--yaw", "0:1:2"],
                          ["--roll", "0:181:2"], ["--heave", "up"]):
            self.assertEqual(call("buoyancy", FRIGATE, *arguments).returncode, 2, arguments)

    def test_help_says_axes(self):
        for name, *words in (("righting", "starboard", "gz > 0", "trim"),
                             ("buoyancy", "own x", "level y", "vertical", "weight")):
            done = call(name, "--help")
            self.assertEqual(done.returncode, 0)
            for word in ("Example", *words):
                self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
