"""loading_test.py CUTWATER: how [hull] and [mass] say where a ship floats, and what they refuse."""
import csv
import io
import sys
import unittest

from command import InFolder, call

BOX = "".join(f"v {x} {y} {z}\n" for x in (-10, 10) for y in (-3, 3) for z in (-2, 2)) + \
    "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
DISPLACEMENT = 1025 * 240.0  # [kg] of 20 x 6 x 2 m


class Loading(InFolder):
    def ship(self, hull, mass):
        self.path("box.obj", BOX)
        return self.path("ship.toml", f'[hull]\nmesh = "box.obj"\npanels = 30\n{hull}\n'
                                      f"[mass]\n{mass}\n")

    def rows(self, hull, mass):
        done = call("hydrostatics", self.ship(hull, mass))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = csv.DictReader(io.StringIO(done.stdout))
        return {row["name"]: float(row["value"]) for row in rows if row["unit"]}, done.stderr

    def refused(self, hull, mass, *words):
        done = call("hydrostatics", self.ship(hull, mass))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_a_ship_that_floats_displaces_its_mass(self):
        rows, said = self.rows("float = true", "mass = 300000.0\ncog = [0.4, 0.0, -0.3]")
        # Panels and hull have flat faces: what is left are the digits of the file.
        self.assertAlmostEqual(rows["volume"], 300000 / 1025, delta=1e-5 * 300)
        self.assertIn("0.439 m deeper", said)
        self.assertIn("bow down", said)
        self.assertIn("0.00 deg to starboard", said)

    def test_a_heeled_ship_floats_whole(self):
        rows, said = self.rows("float = true", "mass = 300000.0\ncog = [0.0, 0.05, -0.3]")
        self.assertAlmostEqual(rows["volume"], 300000 / 1025, delta=1e-5 * 300)
        self.assertIn("deg to port", said)

    def test_a_ship_drawn_from_its_keel_floats(self):
        drawn = 'float = true\nwaterline = -2.0'  # calm water at the box's bottom
        rows, said = self.rows(drawn, "mass = 300000.0\ncog = [0.4, 0.0, 1.7]")
        self.assertAlmostEqual(rows["volume"], 300000 / 1025, delta=1e-5 * 300)
        self.assertIn("2.439 m deeper", said)
        _, auto = self.rows(drawn, 'mass = 300000.0\ncog = "auto"\ngyradii = "auto"')
        self.assertIn("0.00 deg bow down", auto)
        self.assertIn("gyradii are [", auto)

    def test_auto_puts_g_above_b(self):
        _, said = self.rows("", 'cog = "auto"\ngyradii = "auto"')
        self.assertIn("a usual one", said)
        _, said = self.rows("", 'cog = "auto"\ncog_height = 0.2')
        self.assertIn("GM 0.3 m", said)
        self.refused("", "cog = [0.0, 0.0, 0.0]\ncog_height = 0.2", "cog_height", "auto")

    def test_cog_may_be_in_the_axes_of_the_file(self):
        drawn, _ = self.rows("waterline = 0.5", "cog = [0.0, 0.0, -0.3]")
        inFile, _ = self.rows("waterline = 0.5", 'cog = [0.0, 0.0, 0.2]\naxes = "file"')
        self.assertEqual(drawn["gm_t"], inFile["gm_t"])

    def test_places_are_named_in_the_axes_of_the_file_too(self):
        plate = "v -5 5 -1\nv 5 5 -1\nv 5 6 -1\nv -5 6 -1\nf 9 10 11 12\n"
        mesh = self.path("plate.obj", BOX + plate)
        done = call("panel", mesh, "-n", "30", "--waterline", "0.5", "-o", self.path("p.obj"))
        self.assertEqual(done.returncode, 0, done.stderr)
        places = r"\([-.0-9]+, [-.0-9]+, -1.5\), in the file \([-.0-9]+, [-.0-9]+, -1\)"
        self.assertRegex(done.stderr, places)

    def test_mistakes_are_refused_with_what_to_do(self):
        self.refused("", f"mass = {DISPLACEMENT / 1000}\ncog = [0.0, 0.0, 0.0]", "kilograms")
        self.refused("", "mass = 400000.0\ncog = [0.0, 0.0, 0.0]", "displaces", "float = true")
        self.refused("", "cog = [2.5, 0.0, 0.0]", "trim by", "float = true")
        self.refused("waterline = -2.0", 'cog = "auto"', "waterline", "keel")
        self.refused('forward = "y"', 'cog = "auto"', "forward")
        self.refused('unit = "mm"', 'cog = "auto"', "unit")
        self.refused("float = true", "cog = [0.0, 0.0, 0.0]", "mass", "needed")
        self.refused("float = true", 'cog = "auto"\nmass = 246.0', "kilograms")
        self.refused("", 'cog = "auto"\naxes = "file"', "axes")
        self.refused("waterline = -1.99", 'cog = "auto"', "waterline", "keel")
        self.refused("float = true\ntrim_deg = 1.0", 'cog = "auto"\nmass = 1.0', "trim_deg")
        self.refused("float = true", "mass = 900000.0\ncog = [0.0, 0.0, 0.0]", "sinks")
        self.refused("float = true", "mass = 300000.0\ncog = [0.0, 0.0, 3.0]", "falls over")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
