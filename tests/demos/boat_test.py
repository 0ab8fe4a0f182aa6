"""boat_test.py COMMAND BOAT_FOLDER DATABASE: the boat's model, hull, hydrostatics and database.

Volume and stability are computed here anew, from the formula in its README and from the file's own
triangles, beside what the command finds.
"""
import csv
import io
import math
import os
import subprocess
import sys
import unittest

from glb_file import Glb

COMMAND, FOLDER, DATABASE = sys.argv[1:4]
SHIP = os.path.join(FOLDER, "ship.toml")
MODEL = Glb(os.path.join(FOLDER, "boat.glb"))
COG_HEIGHT = 0.30  # [m] ship.toml


def table(*arguments):
    done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return list(csv.DictReader(io.StringIO(done.stdout)))


def values(*arguments):
    return {row["name"]: row["value"] for row in table(*arguments)}


def in_hull_axes(triangles):
    """glTF: y up, z to the bow, x to port."""
    return [[(z, x, y) for x, y, z in triangle] for triangle in triangles]


def open_edges(triangles):
    """Edges from a to b that are run along that way more often than back."""
    count = {}
    for triangle in triangles:
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            count[a, b] = count.get((a, b), 0) + 1
            count[b, a] = count.get((b, a), 0) - 1
    return [edge for edge, times in count.items() if times > 0]


def volume(triangles):
    """Of tetrahedra from the origin: (volume, its moments about the planes x = 0 and z = 0)."""
    whole, along, up = 0.0, 0.0, 0.0
    for p, q, r in triangles:
        part = (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                p[2] * (q[0] * r[1] - q[1] * r[0])) / 6.0
        whole += part
        along += part * (p[0] + q[0] + r[0]) / 4.0
        up += part * (p[2] + q[2] + r[2]) / 4.0
    return whole, along, up


def below_water():
    """The hull's faces below z = 0. Its waterline is a line of edges: no face crosses it."""
    hull = in_hull_axes(MODEL.triangles("hull"))
    wet = [t for t in hull if min(p[2] for p in t) < 0.0]
    assert all(p[2] <= 0.0 for t in wet for p in t)
    return wet


def waterplane(wet):
    """Area and second moment about the centre line, from its outline: the wet faces' open edges."""
    area, second = 0.0, 0.0
    for a, b in open_edges(wet):  # clockwise seen from above
        assert a[2] == b[2] == 0.0
        cross = b[0] * a[1] - a[0] * b[1]
        area += cross / 2.0
        second += cross * (a[1] ** 2 + a[1] * b[1] + b[1] ** 2) / 12.0
    return area, second


def formula(steps=20000):
    """Volume, its moments, area and second moment of the waterplane by the README's formula."""
    length, sums = 11.3, [0.0] * 5
    for i in range(steps):
        u = (i + 0.5) / steps
        x = -6.0 + length * u
        aft, fore = max(0.0, 1.0 - u / 0.40), max(0.0, (u - 0.40) / 0.60)
        run, forefoot = max(0.0, 1.0 - u / 0.60), max(0.0, (u - 0.78) / 0.22)
        b = 1.62 * (1.0 - 0.12 * aft ** 2 - fore ** 2)
        d = (0.88 - 0.58 * run ** 2) * math.sqrt(1.0 - forefoot ** 2)
        n = 1.9 + 0.7 * aft ** 2 - 0.6 * fore ** 2
        section = 2.0 * b * d * n / (n + 1.0)
        up = -2.0 * b * d ** 2 * (0.5 - 1.0 / (n + 2.0))
        for k, value in enumerate((section, section * x, up, 2.0 * b, 2.0 / 3.0 * b ** 3)):
            sums[k] += value * length / steps
    return sums


class Model(unittest.TestCase):
    def test_parts_are_closed_and_where_they_belong(self):
        self.assertEqual(list(MODEL.parts),
                         "hull transom coachroof wheelhouse mast rudder".split())
        boxes = {}
        for name in MODEL.parts:
            triangles = in_hull_axes(MODEL.triangles(name))
            boxes[name] = [(min(p[i] for t in triangles for p in t),
                            max(p[i] for t in triangles for p in t)) for i in range(3)]
            if name != "rudder":
                self.assertEqual(open_edges(triangles), [], name)
                self.assertGreater(volume(triangles)[0], 0.0, name)
        (stern, bow), (starboard, port), (keel, deck) = boxes["hull"]
        self.assertAlmostEqual(bow - stern, 12.0, delta=1e-6)
        self.assertAlmostEqual(port, -starboard, delta=1e-6)
        self.assertAlmostEqual(port, 1.86, delta=1e-3)  # of the widest of 41 stations
        self.assertAlmostEqual(keel, -0.88, delta=1e-6)
        self.assertAlmostEqual(deck, 1.80, delta=1e-6)
        self.assertGreater(boxes["transom"][2][0], 0.0)
        self.assertEqual(boxes["transom"][0][1], stern)
        self.assertEqual(boxes["mast"][2][0], boxes["wheelhouse"][2][1])
        self.assertGreater(boxes["mast"][2][1], 4.5)
        # A plate under the stern: below water, no deeper than the keel.
        self.assertEqual(boxes["rudder"][1], (0.0, 0.0))
        self.assertLess(boxes["rudder"][2][1], -0.3)
        self.assertGreater(boxes["rudder"][2][0], keel)

    def test_houses_stand_on_the_deck(self):
        # The sheer: 1.05 m at the transom, 1.80 m at the bow, a parabola. No overlap, no gap.
        for name in ("coachroof", "wheelhouse"):
            triangles = in_hull_axes(MODEL.triangles(name))
            floor = [t for t in triangles if all(p[2] < 1.7 for p in t) and (
                (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) -
                (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])) < -1e-4]
            self.assertGreater(len(floor), 8)
            for x, _, z in (p for t in floor for p in t):
                self.assertAlmostEqual(z, 1.05 + 0.75 * ((x + 6.0) / 12.0) ** 2, delta=1e-6)

    def test_plates_are_drawn_from_both_sides_and_solids_from_outside(self):
        colours = set()
        for name, surfaces in MODEL.parts.items():
            for material, _ in surfaces:
                self.assertEqual(material["doubleSided"], name == "rudder")
                colours.add(tuple(material["pbrMetallicRoughness"]["baseColorFactor"]))
        self.assertGreaterEqual(len(colours), 6)


class Hydrostatics(unittest.TestCase):
    found = {name: float(value) for name, value in values("hydrostatics", SHIP).items()}

    def close(self, name, value, delta):
        self.assertAlmostEqual(self.found[name], value, delta=delta, msg=name)

    def test_are_those_of_the_hull_part_alone(self):
        # Sums of the same numbers: 1e-9 but for single precision in the file, 6e-8 of 6 m.
        wet = below_water()
        displaced, along, up = volume(wet)  # from the origin, on the waterplane: no lid needed
        area, second = waterplane(wet)
        self.close("volume", displaced, 1e-6 * displaced)
        self.close("lcb", along / displaced, 1e-5)
        self.close("vcb", up / displaced, 1e-5)
        self.close("waterplane_area", area, 1e-6 * area)
        self.close("bm_t", second / displaced, 1e-5)
        self.close("gm_t", second / displaced + up / displaced - COG_HEIGHT, 1e-5)
        self.close("C33", 1025.0 * 9.80665 * area, 1.0)

    def test_are_the_formulas_less_what_chords_cut_off(self):
        # Vertices lie on the formula's surface. One chord would cut (n − 1)/2n off a section: 24 %
        # amidships, 31 % at the transom. Twelve of equal length cut off that by 12², times 1.5, as
        # they are not of equal depth: 0.25 to 0.32 %. 40 stations along the hull add 0.05 %.
        displaced, along, up, area, second = formula()
        self.assertLess(self.found["volume"], displaced)
        self.close("volume", displaced, 0.004 * displaced)
        self.close("lcb", along / displaced, 0.004)
        self.close("vcb", up / displaced, 0.004 * 0.88)
        self.close("waterplane_area", area, 0.001 * area)
        self.close("gm_t", second / displaced + up / displaced - COG_HEIGHT, 0.01)

    def test_are_a_motor_boats(self):
        self.close("lcb", -0.8489, 1e-3)  # where ship.toml has the centre of gravity: level
        self.close("mass", 14044.0, 1.0)
        self.assertTrue(0.8 < self.found["gm_t"] < 1.5)
        block = self.found["volume"] / (11.3 * 3.24 * 0.88)
        self.assertTrue(0.35 < block < 0.5)


class Database(unittest.TestCase):
    def test_passes_its_own_checks(self):
        info = values("info", DATABASE)
        self.assertEqual(info["status"], "finished")
        self.assertTrue(info["verdict"].startswith("good for the frequency and the time domain"))
        self.assertEqual(float(info["masked_frequencies"]), 0)
        self.assertGreater(float(info["check_damping_smallest_diagonal"]), 0.0)
        self.assertLess(float(info["check_damping_asymmetry"]), 5.0)
        self.assertEqual((info["file_up"], info["file_forward"]), ("y", "z"))
        self.assertAlmostEqual(float(info["volume"]), Hydrostatics.found["volume"], delta=1e-6)
        self.assertLess(os.path.getsize(DATABASE), 4e6)

    def test_rolls_as_long_as_a_boat_does(self):
        # Uncoupled: the square root of C44 over (I44 + A44). Sway takes part: some per cent.
        rows = [row for row in table("rao", DATABASE, "--heading", "90", "--omega", "1.5:2.5:201")
                if row["j"] == "4"]
        peak = max(rows, key=lambda row: float(row["amplitude"]))
        period = 2.0 * math.pi / float(peak["omega"])
        self.assertTrue(2.5 < period < 4.0, period)
        nearest = min((row for row in table("coefficients", DATABASE)
                       if row["j"] == row["k"] == "4" and row["omega"] != "inf"),
                      key=lambda row: abs(float(row["omega"]) - float(peak["omega"])))
        inertia = Hydrostatics.found["mass"] * 1.4 ** 2 + float(nearest["A"])
        uncoupled = 2.0 * math.pi * math.sqrt(inertia / Hydrostatics.found["C44"])
        self.assertAlmostEqual(period / uncoupled, 1.0, delta=0.05)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
