"""sea_test.py CUTWATER: `sea`, the waves of a run file's sea and what they amount to."""
import math
import unittest

from command import InFolder, call, table

COLUMNS = ["omega", "heading_deg", "amplitude", "phase_deg"]
NAMES = ["hs", "m0", "m1", "m2", "tz", "tm01", "repeat_time", "share_outside"]
WIND = 'type = "jonswap"\nhs = 2.0\ntp = 6.0\n'
SWELL = "{ hs = 1.5, tp = 14.0, gamma = 7.0, heading_deg = 120.0, components = 50 }"


class Sea(InFolder):
    def run_file(self, waves, motion="heading_deg = 150.0"):
        return self.path("run.toml", f"[waves]\n{waves}\n[motion]\n{motion}\n")

    def waves(self, text):
        return [{name: float(value) for name, value in row.items()}
                for row in table("sea", self.run_file(text))]

    def moments(self, text):
        rows = table("sea", self.run_file(text), "--moments")
        self.assertEqual([row["name"] for row in rows], NAMES)
        return {row["name"]: float(row["value"]) for row in rows}

    def said(self, text):
        done = call("sea", self.run_file(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def refused(self, text, *words):
        done = call("sea", self.run_file(text))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        last = done.stderr.strip().splitlines()[-1]
        for word in words:
            self.assertIn(word, last)

    def test_waves_and_moments_are_of_one_sea(self):
        waves, moments = self.waves(WIND), self.moments(WIND)
        self.assertEqual(list(waves[0]), COLUMNS)
        self.assertEqual(len(waves), 200)
        for n, name in enumerate(("m0", "m1", "m2")):
            found = sum(w["omega"] ** n * w["amplitude"] ** 2 / 2 for w in waves)
            self.assertAlmostEqual(found / moments[name], 1, delta=1e-7)  # nine digits are written
        self.assertAlmostEqual(moments["hs"], 2.0, delta=1e-8)
        tz = 2 * math.pi * math.sqrt(moments["m0"] / moments["m2"])
        self.assertAlmostEqual(moments["tz"], tz, delta=1e-7)
        self.assertEqual(moments["repeat_time"], math.inf)
        self.assertEqual({w["heading_deg"] for w in waves}, {150.0})

    def test_height_is_that_asked_for_with_any_number_of_waves(self):
        for count in (1, 2, 7, 200):
            for kind in ("jonswap", "bretschneider", "pierson-moskowitz", "ochi-hubble"):
                found = self.moments(f'type = "{kind}"\nhs = 2.0\ncomponents = {count}')
                self.assertAlmostEqual(found["hs"], 2.0, delta=1e-8)

    def test_what_cut_offs_leave_out(self):
        # Bretschneider below r = omega/omega_p: exp(-1.25 r^-4) of m0.
        found = self.moments('type = "bretschneider"\nhs = 2.0\ntp = 8.0')
        below = [math.exp(-1.25 * r ** -4) for r in (0.5, 4.0)]
        self.assertAlmostEqual(found["share_outside"], 1 - (below[1] - below[0]), delta=1e-8)
        cut = WIND + "omega_max = 1.2"
        self.assertIn("omega_min, omega_max = 0.5236, 1.2 rad/s leave out", self.said(cut))
        self.assertAlmostEqual(self.moments(cut)["hs"], 2.0, delta=1e-8)
        self.assertNotIn("leave out", self.said(WIND))

    def test_systems_add_up_in_squares(self):
        both = WIND + f"spreading = 4.0\nsystems = [ {SWELL} ]"
        waves = self.waves(both)
        self.assertEqual(len(waves), 250)
        self.assertEqual({w["heading_deg"] for w in waves[200:]}, {120.0})
        self.assertAlmostEqual(self.moments(both)["hs"], 2.5, delta=1e-8)
        said = self.said(both)
        self.assertIn("cos2s 4, sigma 36.24 deg", said)
        self.assertIn("heading 120 deg, long-crested; 50 waves", said)
        # Without a type of its own the sea is the systems alone.
        self.assertEqual(len(self.waves(f"systems = [ {SWELL} ]")), 50)
        self.refused('type = "regular"\nomega = 1.0\n' + f"systems = [ {SWELL} ]", "systems")
        self.refused('systems = [ { hs = 1.0, colour = 1 } ]', "waves.systems[0]", "colour")

    def test_names_choose_laws_and_factors(self):
        said = self.said(WIND + 'normalisation = "dnv"\nspreading = 2\nspreading_law = "cosn"')
        self.assertIn('"dnv": the sea\'s Hs is 2.00241 m, 0.121 % above hs = 2', said)
        self.assertIn("cosn 2, sigma 31.5 deg", said)
        self.assertIn("member 4, its published shares scaled to hs",
                      self.said('type = "ochi-hubble"\nhs = 2.0\nmember = 4'))
        self.assertIn("steeper than seas are", self.said('type = "jonswap"\nhs = 6.0\ntp = 5.0'))

    def test_a_table_is_read_and_refused_by_line(self):
        self.path("s.csv", "# m2 s\nomega,S\n0.4,0\n0.8,2\n1.2,0\n")
        text = 'type = "table"\nfile = "s.csv"'
        self.assertAlmostEqual(self.moments(text)["m0"], 0.8, delta=1e-8)  # a triangle
        for rows, words in (("0.4,0\n0.3,1\n", "line 3"), ("0.4,0\n0.5,-1\n", "line 3"),
                            ("0.4,0\n0.5,nan\n", '"0.5,nan"'), ("0.4,1\n", "two points")):
            self.path("s.csv", "omega,S\n" + rows)
            self.refused(text, "s.csv: line", words)
        self.refused('type = "table"', "file", "is missing")
        self.refused('type = "table"\nfile = "none.csv"', "none.csv")

    def test_regular_waves_components_and_calm_water(self):
        text = 'type = "regular"\nomega = 0.8\namplitude = 1.5\nphase_deg = 30.0'
        self.assertEqual(self.waves(text), [dict(zip(COLUMNS, (0.8, 150.0, 1.5, 30.0)))])
        self.assertAlmostEqual(self.moments(text)["repeat_time"], 2 * math.pi / 0.8, delta=1e-6)
        self.refused('type = "regular"\nomega = [0.8, 0.9]', "omega")
        self.assertEqual(self.waves('type = "none"'), [])
        self.assertEqual(self.moments('type = "none"')["hs"], 0.0)

    def test_rows_are_components_of_a_run_file(self):
        sea = self.waves(WIND + "spreading = 2.0\ncomponents = 20")
        items = ", ".join(f"{{ omega = {w['omega']}, amplitude = {w['amplitude']}, phase_deg = "
                          f"{w['phase_deg']}, direction_deg = {w['heading_deg']} }}" for w in sea)
        again = self.waves(f'type = "components"\ncomponents = [ {items} ]')
        for a, b in zip(sea, again, strict=True):
            for name in COLUMNS:
                # Degrees become radians and degrees again, of nine digits.
                self.assertAlmostEqual(a[name], b[name], delta=2e-6)

    def test_depth_is_refused_with_the_reason(self):
        for text in (WIND + "depth = 20.0", "systems = [ { hs = 1.0, depth = 20.0 } ]"):
            self.refused(text, "depth = 20", "deep water")


if __name__ == "__main__":
    unittest.main(argv=["sea_test.py"])
