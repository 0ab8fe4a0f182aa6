"""new_test.py COMMAND MESHES: `cutwater new`, from a mesh to a ship that solves; what it says, what
it refuses, its picture."""
import math
import os
import re
import sys
import unittest
import xml.etree.ElementTree as ET

import tomllib

from command import InFolder, call

MESHES = os.path.abspath(sys.argv[2])
BOAT = f"{MESHES}/boat/boat.glb"
FRIGATE = f"{MESHES}/frigate/frigate_433.obj"
SVG = "{http://www.w3.org/2000/svg}"
DENSITY = 1025.0


def obj(vertices, faces):
    return "".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices) + "".join(
        "f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def read_obj(path):
    vertices, faces = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                vertices.append(tuple(float(word) for word in words[1:4]))
            if words and words[0] == "f":
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return vertices, faces


def box(length, breadth, low, high, at=(0.0, 0.0)):
    """Twelve triangles."""
    x, y = length / 2, breadth / 2
    vertices = [(at[0] + sx * x, at[1] + sy * y, z) for z in (low, high)
                for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    quads = [(3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)]
    return vertices, [face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]


def column(radius, low, high, sides=24):
    ring = [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides))
            for i in range(sides)]
    vertices = [(x, y, z) for z in (low, high) for x, y in ring] + [(0, 0, low), (0, 0, high)]
    faces = []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(i, j, sides + j, sides + i), (j, i, 2 * sides),
                  (sides + i, sides + j, 2 * sides + 1)]
    return vertices, faces


class New(InFolder):
    def made(self, mesh, *options, name="ship"):
        """The TOML, the lines on stderr, the tree of the picture."""
        out = self.path(f"{name}.toml")
        done = call("new", mesh, *options, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")
        with open(out, "rb") as file:
            ship = tomllib.load(file)
        return ship, done.stderr.splitlines(), ET.parse(self.path(f"{name}.svg")).getroot()

    def listed(self, name="ship"):
        done = call("hydrostatics", self.path(f"{name}.toml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split(",") for line in done.stdout.splitlines()[1:]]
        return {row[0]: row[1] for row in rows}, done.stderr

    def refused(self, code, *words, mesh=BOAT, options=(), out="none.toml"):
        done = call("new", mesh, *options, "-o", self.path(out))
        self.assertEqual(done.returncode, code, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse(os.path.exists(self.path("none.toml")))

    def solves(self, name="ship"):
        """With four frequencies: whether the file is right, not how good the grid is."""
        toml = self.path(f"{name}.toml")
        with open(toml, encoding="utf-8") as file:
            text = file.read()
        step = float(re.search(r"^omega = \{ from = ([\d.e+-]+)", text, re.M).group(1))
        text = re.sub(r"^omega = .*$", f"omega = [{2 * step}, {4 * step}, {8 * step}, {16 * step}]",
                      text, flags=re.M)
        text = re.sub(r"^wave_omega = .*$", f"wave_omega = [{4 * step}]", text, flags=re.M)
        coarse = self.path(f"{name}_coarse.toml", text)
        done = call("solve", coarse, "-o", self.path(f"{name}.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def turned(self, name, turn, mesh=FRIGATE):
        vertices, faces = read_obj(mesh)
        return self.path(name, obj([turn(*vertex) for vertex in vertices], faces))

    def test_the_boat_becomes_the_ship_that_stands_beside_it(self):
        ship, lines, _ = self.made(BOAT, "-n", "60")
        with open(f"{MESHES}/boat/ship.toml", "rb") as file:
            ours = tomllib.load(file)
        for key in ("up", "forward"):
            self.assertEqual(ship["hull"][key], ours["hull"][key])
        self.assertEqual(ship["hull"]["waterline"], 0)
        # Our file's number has four digits.
        self.assertAlmostEqual(ship["mass"]["cog"][0], ours["mass"]["cog"][0], delta=1e-4)
        self.assertIn("engine", ship)
        listed, messages = self.listed()
        self.assertNotIn("warning", messages)
        self.assertGreater(float(listed["gm_t"]), 0.0)
        self.assertTrue(any("--up" in line and "clear" in line for line in lines))
        self.solves()

    def test_axes_and_units_of_any_file(self):
        cases = {
            "z.obj": (lambda x, y, z: (x, y, z), "z", "x", "m"),
            "game.obj": (lambda x, y, z: (-100 * y, 100 * z, -100 * x), "y", "-z", "cm"),
            "cad.obj": (lambda x, y, z: (1e3 * y, -1e3 * x, 1e3 * z), "z", "-y", "mm"),
        }
        for name, (turn, up, forward, unit) in cases.items():
            with self.subTest(name):
                ship, _, _ = self.made(self.turned(name, turn), "--force")
                hull = ship["hull"]
                self.assertEqual((hull["up"], hull["forward"], hull["unit"]), (up, forward, unit))
                # The formula hull's 4509 m^3 less what 433 flat panels a side lack.
                self.assertAlmostEqual(float(self.listed()[0]["volume"]), 4487.2, delta=0.1)

    def test_a_keel_at_zero_is_asked_for_or_found(self):
        keel = self.turned("keel.obj", lambda x, y, z: (x, y, z + 4.97))
        _, lines, _ = self.made(keel)
        self.assertTrue(any("waterline" in line and "a guess" in line and "--draught" in line
                            for line in lines))
        ship, _, _ = self.made(keel, "--draught", "4.97", "--force")
        self.assertAlmostEqual(ship["hull"]["waterline"], 4.97, delta=1e-9)
        mass = float(self.listed()[0]["mass"])
        ship, _, _ = self.made(keel, "--displacement", f"{mass:.9g}", "--force")
        # The waterline is written with nine digits.
        self.assertAlmostEqual(ship["hull"]["waterline"], 4.97, delta=2e-5)
        self.assertAlmostEqual(float(self.listed()[0]["mass"]) / mass, 1.0, delta=1e-5)
        ship, _, _ = self.made(keel, "--mass", "3e6", "--force")
        self.assertEqual(ship["mass"]["mass"], 3e6)
        listed, messages = self.listed()
        self.assertAlmostEqual(float(listed["displacement"]), 3e6, delta=30)
        self.assertNotIn("warning", messages)

    def test_a_box_floats_as_archimedes_has_it(self):
        mesh = self.path("box.obj", obj(*box(30.0, 8.0, 0.0, 4.0)))
        mass = DENSITY * 30.0 * 8.0 * 1.5
        ship, _, _ = self.made(mesh, "--displacement", str(mass))
        self.assertAlmostEqual(ship["hull"]["waterline"], 1.5, delta=1e-6)
        ship, _, _ = self.made(mesh, "--displacement", str(mass), "--density", "1000", "--force")
        self.assertAlmostEqual(ship["hull"]["waterline"], 1.5 * 1.025, delta=1e-6)
        self.assertEqual(ship["water"]["density"], 1000)
        self.refused(1, "displaces 960 m3 at most", mesh=mesh, options=("--mass", "2e6"))

    def test_each_guess_is_overridden(self):
        mesh = self.path("box.obj", obj(*box(30.0, 8.0, -1.5, 2.5)))
        for option, value, table, key in (
                ("--forward", "-x", "hull", "forward"), ("--unit", "ft", "hull", "unit"),
                ("--waterline", "0.5", "hull", "waterline"), ("--trim", "1.5", "hull", "trim_deg"),
                ("--heel", "2", "hull", "heel_deg"), ("--symmetric", "none", "hull", "symmetric"),
                ("--panels", "90", "hull", "panels"), ("--density", "1000", "water", "density"),
                ("--up", "-z", "hull", "up")):
            with self.subTest(option):
                ship, _, _ = self.made(mesh, option, value, "--force")
                given = value if isinstance(ship[table][key], str) else float(value)
                self.assertEqual(ship[table][key], given)
                self.listed()
        ship, _, _ = self.made(mesh, "--cog-height", "0.25", "--force")
        self.assertEqual(ship["mass"]["cog"][2], 0.25)
        ship, lines, _ = self.made(mesh, "--cog-height", "9", "--force")
        self.assertTrue(any("not stable" in line for line in lines))
        plain = self.path("box.3ds", obj(*box(30.0, 8.0, -1.5, 2.5)))
        self.refused(1, "any_format", mesh=plain)

    def test_a_spar_has_no_bow_and_solves(self):
        ship, lines, _ = self.made(self.path("spar.obj", obj(*column(3.0, -20.0, 5.0))), "-n", "60")
        self.assertTrue(any("no ship with a bow" in line for line in lines))
        self.assertNotIn("engine", ship)
        # Ballast: G lies below B, which is at half the draught, as BM is next to nothing.
        self.assertLess(ship["mass"]["cog"][2], -10.0)
        self.assertGreaterEqual(min(ship["mass"]["gyradii"][:2]), 0.29 * 25.0 - 1e-3)
        self.solves()

    def test_the_barge_and_a_catamaran_solve(self):
        self.made(f"{MESHES}/barge/barge_196.obj", "-n", "60", name="barge")
        self.solves("barge")
        left, faces = box(20.0, 1.5, -1.0, 1.5, (0.0, 4.0))
        right, _ = box(20.0, 1.5, -1.0, 1.5, (0.0, -4.0))
        twin = obj(left + right, faces + [[i + 8 for i in face] for face in faces])
        self.made(self.path("twin.obj", twin), "-n", "60", name="twin")
        self.solves("twin")

    def test_the_picture_has_the_waterline_where_it_is(self):
        ship, _, svg = self.made(BOAT)
        self.assertEqual(svg.tag, SVG + "svg")
        groups = {group.get("id"): group for group in svg.iter(SVG + "g")}
        self.assertEqual(set(groups), {"profile", "plan", "body"})
        listed, _ = self.listed()
        for name in ("profile", "body"):
            line = groups[name].find(f"{SVG}line[@class='waterline']")
            self.assertEqual((float(line.get("y1")), float(line.get("y2"))), (0.0, 0.0))
            heights = self.places(groups[name])[1]
            # Five digits in the picture; the rudder, which is left out of the hull, is above.
            self.assertAlmostEqual(-min(heights), float(listed["draft"]), delta=0.01)
        waterline = groups["plan"].find(f"{SVG}path[@class='waterline']")
        along, across = self.places(waterline)
        self.assertAlmostEqual(max(along) - min(along), float(listed["length"]), delta=1e-3)
        self.assertAlmostEqual(max(across) - min(across), float(listed["beam"]), delta=1e-3)
        self.assertEqual(ship["hull"]["unit"], "m")

    @staticmethod
    def places(element):
        numbers = [float(word) for path in element.iter(SVG + "path")
                   for word in re.findall(r"-?[\d.]+(?:e[+-]?\d+)?", path.get("d"))]
        return numbers[::2], numbers[1::2]

    def test_names_that_need_care(self):
        """Quotes in a TOML, marks in an XML, a file in another folder."""
        os.mkdir(self.path("to"))
        mesh = self.path('a "b" & <c>.obj', obj(*box(30.0, 8.0, -1.5, 2.5)))
        done = call("new", mesh, "-o", self.path("to/ship.toml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("to/ship.toml"), "rb") as file:
            self.assertEqual(tomllib.load(file)["hull"]["mesh"], '../a "b" & <c>.obj')
        title = ET.parse(self.path("to/ship.svg")).getroot().find(f"{SVG}text[@class='title']")
        self.assertEqual(title.text, 'a "b" & <c>.obj')
        self.assertEqual(call("hydrostatics", self.path("to/ship.toml")).returncode, 0)

    def test_nothing_is_written_over(self):
        self.made(BOAT)
        self.refused(1, "ship.toml: is there already", "--force", out="ship.toml")
        os.remove(self.path("ship.toml"))
        self.refused(1, "ship.svg: is there already", "--force", out="ship.toml")
        self.made(BOAT, "--force")

    def test_what_is_refused(self):
        self.refused(2, "must end in .toml", out="none.txt")
        self.refused(2, "is the axis that points up", options=("--up", "x", "--forward", "-x"))
        for option in ("--draught", "--displacement", "--mass", "--cog-height", "--trim", "--heel",
                       "--density", "--waterline"):
            for value in ("nan", "inf", "-1e20"):
                self.refused(2, option, "must be in", options=(option, value))
        self.refused(1, "no such file", mesh=self.path("nothing.obj"))
        self.refused(1, "is a ship.toml already", mesh=f"{MESHES}/boat/ship.toml")
        self.refused(1, "outside the mesh", "--draught", options=("--draught", "20"))
        tiny = self.path("tiny.obj", obj(*box(0.011, 0.003, -0.001, 0.001)))
        self.refused(1, "is 0.011 long", "--unit", mesh=tiny)
        done = call("new", BOAT, "--draught", "1", "--waterline", "0", "-o", self.path("none.toml"))
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_planks_have_no_volume_that_can_be_trusted(self):
        """A box of boards 2 cm thick that overlap: closed solids, but the water stays outside."""
        parts = [box(4.0, 1.5, -0.4, -0.38), box(4.02, 0.02, -0.41, 0.2, (0.0, 0.74)),
                 box(4.02, 0.02, -0.41, 0.2, (0.0, -0.74)), box(0.02, 1.5, -0.41, 0.2, (2.0, 0.0)),
                 box(0.02, 1.5, -0.41, 0.2, (-2.0, 0.0))]
        vertices, faces = [], []
        for corners, ones in parts:
            faces += [[i + len(vertices) for i in face] for face in ones]
            vertices += corners
        done = call("new", self.path("planks.obj", obj(vertices, faces)), "-o", self.path("p.toml"))
        if done.returncode == 0:  # repaired: then it is the box that the water sees
            volume = float(re.search(r"volume ([\d.]+) m3", done.stderr).group(1))
            self.assertAlmostEqual(volume / (4.02 * 1.5 * 0.4), 1.0, delta=0.03)
        else:
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertFalse(os.path.exists(self.path("p.toml")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
