"""compartments_test.py COMMAND DATABASE: [[compartment]] of run files, in the CSV and on the page;
and steep regular waves, [waves] order."""
import csv
import json
import math
import os
import sys
import unittest

from command import InFolder, call

DATABASE = os.path.abspath(sys.argv[2])
PUMPED = """[[compartment]]
name = "fore_peak"
centre = [20.0, 0.0, -1.0]
size = [4.0, 6.0, 2.0]
permeability = 0.9
volume = 3.0
rate = 0.25
"""
HOLED = """[[compartment]]
centre = [0.0, -3.0, -1.5]
size = [10.0, 3.0, 5.0]
openings = [ { place = [0.0, -4.5, -2.0], area = 0.5 } ]
"""


class Compartments(InFolder):
    def simulate(self, rest, duration):
        run = self.path("run.toml",
                        f'database = "{DATABASE}"\n[bullet]\nduration = {duration}\n{rest}')
        return call("simulate", run, "-o", self.path("run.csv"))

    def columns(self, rest, duration):
        done = self.simulate(rest, duration)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("run.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {name: [float(row[name]) for row in rows] for name in rows[0]}

    def test_what_is_pumped_in_is_in_its_column(self):
        run = self.columns(PUMPED, 40.0)
        self.assertEqual(list(run)[-1], "fore_peak_water")
        for t, water in zip(run["t"], run["fore_peak_water"]):
            # At the end of the tick of 0.02 s; nine digits are written.
            self.assertAlmostEqual(water, 3.0 + 0.25 * (t + 0.02), delta=1e-7)
        self.assertGreater(run["pitch_deg"][-1], 0.01)  # bow down

    def test_a_hole_fills_the_room_to_the_sea_and_heels_the_ship(self):
        run = self.columns(HOLED, 200.0)
        water = run["room1_water"]
        self.assertLess(max(water) - water[-1], 0.05)  # m3; the ship rolls a little as it comes
        self.assertLess(water[-1] - water[-500], 0.05)  # m3 in 10 s: level with the sea
        self.assertGreater(run["roll_deg"][-1], 1.0)  # starboard down
        # Level with the sea, 2.5 + 1.5 m and what the ship sinks and heels by, of 10 m x 3 m.
        self.assertTrue(110.0 < water[-1] < 150.0, water[-1])

    def test_the_page_has_rooms_about_g(self):
        self.columns(PUMPED + HOLED, 1.0)
        done = call("report", DATABASE, self.path("run.toml"), "-o", self.path("page.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("page.json"), encoding="utf-8") as file:
            page = json.load(file)
        fore, room = page["runs"][0]["compartments"]
        cog = page["ship"]["cog"]
        self.assertEqual([fore["name"], room["name"]], ["fore_peak", "room2"])
        self.assertEqual(fore["size"], [4.0, 6.0, 2.0])
        for is_, centre, g in zip(fore["centre"], [20.0, 0.0, -1.0], cog):
            self.assertAlmostEqual(is_, centre - g, delta=1e-6)
        names = [column["name"] for column in page["runs"][0]["columns"]]
        self.assertEqual(names[-2:], ["fore_peak_water", "room2_water"])

    def test_what_does_not_fit_is_refused(self):
        for wrong, said in ((PUMPED + PUMPED, "name"), (PUMPED.replace("3.0", "99.0"), "volume"),
                            (PUMPED.replace("6.0", "-6.0"), "size"),
                            (HOLED.replace(", area = 0.5", ""), "area"),
                            (PUMPED.replace("fore_peak", "fore peak"), "name")):
            with self.subTest(wrong=wrong):
                done = self.simulate(wrong, 1.0)
                self.assertEqual(done.returncode, 1)
                self.assertIn(said, done.stderr.strip().splitlines()[-1])

    def test_a_steep_wave_has_higher_crests_than_troughs(self):
        waves = ('[waves]\ntype = "regular"\nomega = 0.8\namplitude = 4.0\norder = ORDER\n'
                 'ramp = 0.0\n[motion]\nmean = "fixed"\nmode = "MODE"\n')
        crest = {}
        for order in (1, 2, 5):
            run = self.columns(waves.replace("ORDER", str(order)).replace("MODE", "nonlinear"),
                               8.0)
            crest[order] = (max(run["wave"]), min(run["wave"]))
        k = 0.8 ** 2 / 9.80665
        for _ in range(50):
            k = 0.8 ** 2 / (9.80665 * (1 + 0.5 * (4.0 * k) ** 2) ** 2)
        # Ticks of 0.02 s miss the crest by up to (0.8 · 0.01)²/2 of it.
        self.assertAlmostEqual(crest[1][0], 4.0, delta=2e-4)
        self.assertAlmostEqual(crest[2][0], 4.0 + 8.0 * k, delta=5e-4)
        self.assertAlmostEqual(crest[2][1], -4.0 + 8.0 * k, delta=5e-4)
        steepness = 4.0 * k  # the fifth order adds 2/3 of its fourth power, at another k
        self.assertAlmostEqual((crest[5][0] - crest[2][0]) * k, 2 / 3 * steepness ** 4,
                               delta=3.0 * steepness ** 5)
        done = self.simulate(waves.replace("ORDER", "2").replace("MODE", "linear"), 1.0)
        self.assertEqual(done.returncode, 1)
        self.assertIn("order", done.stderr)
        self.assertTrue(math.isfinite(crest[5][1]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
