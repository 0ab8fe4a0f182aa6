"""report_test.py COMMAND FRIGATE.h5 FRIGATE.toml BOAT.h5 CRANE: the page of `cutwater report`.

Its data are those of the other commands and of the runs' CSV; what does not fit is refused.
"""
import array
import base64
import csv
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

import h5py

from command import InFolder, call, table

DATABASE, SHIP, BOAT, CRANE = (os.path.abspath(a) for a in sys.argv[2:6])
FULL = "CUTWATER_FULL" in os.environ
MOTIONS = "t,x,y,z,roll_deg,pitch_deg,yaw_deg,u,v,w,p,q,r,wave".split(",")
RUN = """database = "{database}"
[bullet]
dt = 0.05
duration = 20.0
[waves]
type = "jonswap"
hs = 3.0
tp = 9.0
components = 40
ramp = 5.0
[motion]
heading_deg = 150.0
{motion}
"""
SWEEP = """database = "{database}"
[bullet]
dt = 0.05
duration = 120.0
[waves]
type = "regular"
omega = [0.5, 0.8]
amplitude = 0.05
ramp = 30.0
[motion]
heading_deg = 150.0
"""
BODY = """[body]
size = [4.0, 3.0, 2.0]
[waves]
type = "regular"
omega = 0.8
"""


def blob(value):
    numbers = array.array({"f32": "f", "f64": "d", "u32": "I"}[value["type"]])
    numbers.frombytes(base64.b64decode(value["data"]))
    assert len(numbers) == value["n"]
    return numbers


def series(value):
    if "values" in value:
        return blob(value["values"])
    numbers, before, before_that, bits, shift = [], 0, 0, 0, 0
    for byte in zlib.decompress(base64.b64decode(value["data"]), -15):
        bits |= (byte & 127) << shift
        shift += 7
        if byte >= 128:
            continue
        q = ((bits >> 1) ^ -(bits & 1)) + 2 * before - before_that
        before, before_that, bits, shift = q, before, 0, 0
        numbers.append(q * value["scale"])
    assert len(numbers) == value["n"]
    return numbers


def complex_at(values, index):
    return complex(values[2 * index], values[2 * index + 1])


def earth(row, point):
    """A point of the body, from G, in earth axes; row: x, y, z, roll, pitch, yaw [deg]."""
    (x, y, z), (roll, pitch, yaw) = point, (math.radians(angle) for angle in row[3:])
    y, z = y * math.cos(roll) - z * math.sin(roll), y * math.sin(roll) + z * math.cos(roll)
    x, z = x * math.cos(pitch) + z * math.sin(pitch), z * math.cos(pitch) - x * math.sin(pitch)
    x, y = x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw)
    return row[0] + x, row[1] + y, row[2] + z


def elevation(run, t, x, y):
    sea = run["sea"]
    ramp = 1 if t >= sea["ramp"] else 0.5 * (1 - math.cos(math.pi * t / sea["ramp"]))
    waves = zip(*(blob(sea[key]) for key in ("omega", "amplitude", "phase", "heading")))
    return ramp * sum(
        a * math.cos(o * t - o * o / run["gravity"] * (x * math.cos(b) - y * math.sin(b)) + e)
        for o, a, e, b in waves)


class Pages(InFolder):
    def simulated(self, name, database=DATABASE, motion="", options=()):
        run = self.path(name + ".toml", RUN.format(database=database, motion=motion))
        done = call("simulate", run, *options, "-o", self.path(name + ".csv"))
        assert done.returncode == 0, done.stderr
        return run

    def data(self, *runs, database=DATABASE):
        done = call("report", database, *runs, "-o", self.path("page.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("page.json"), encoding="utf-8") as file:
            text = file.read()
        self.assertNotIn("<", text)
        return json.loads(text)

    def refused(self, arguments, *words, code=1):
        """Exit `code`, a last line that holds all of `words`, no page."""
        page = self.path("no.json")
        done = call("report", *arguments, "-o", page)
        self.assertEqual(done.returncode, code, done.stderr)
        last = done.stderr.strip().splitlines()[-1]
        for word in words:
            self.assertIn(word, last)
        self.assertFalse(os.path.exists(page))


class Database(Pages):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "page.json")
            done = call("report", DATABASE, "-o", out)
            assert done.returncode == 0, done.stderr
            with open(out, encoding="utf-8") as file:
                cls.page = json.load(file)

    def test_a_page_without_runs(self):
        self.assertEqual(self.page["format"], 1)
        self.assertEqual(self.page["runs"], [])
        self.assertEqual([rao["speed"] for rao in self.page["raos"]], [0, 0])

    def test_coefficients(self):
        page = self.page["coefficients"]
        seen = 0
        for row in table("coefficients", DATABASE):
            omega, pair = float(row["omega"]), row["j"] + row["k"]
            if omega == 0 or math.isinf(omega):
                limit = page["A0" if omega == 0 else "Ainf"].get(pair, 0)
                self.assertEqual(limit, float(row["A"]))
                continue
            at = page["omega"].index(omega)
            for name in "AB":
                value = page[name][pair][at] if pair in page[name] else 0
                self.assertEqual(value, float(row[name]))
            seen += pair in page["A"]
        self.assertGreater(seen, 18 * 20)

    def test_excitation(self):
        page = self.page["excitation"]
        parts = [blob(page["froudeKrylov"]), blob(page["diffraction"])]
        heading = page["headingsDeg"].index(150)
        waves = len(page["omega"])
        self.assertGreaterEqual(waves, 60)
        grid = f"{page['omega'][0]}:{page['omega'][-1]}:{waves}"
        rows = table("excitation", DATABASE, "--heading", "150", "--omega", grid)
        for i, row in enumerate(rows):
            self.assertAlmostEqual(float(row["omega"]), page["omega"][i // 6], delta=1e-7)
            for part, name in zip(parts, ("fk", "diff")):
                value = complex_at(part, heading * waves * 6 + i)
                wanted = complex(float(row[name + "_re"]), float(row[name + "_im"]))
                self.assertLess(abs(value - wanted), 1e-6 * abs(wanted) + 1)

    def test_motions(self):
        for rao, options in zip(self.page["raos"], ([], ["--free"])):
            self.assertEqual(rao["free"], bool(options))
            values = blob(rao["values"])
            heading, waves = rao["headingsDeg"].index(150), len(rao["omega"])
            grid = f"{rao['omega'][0]}:{rao['omega'][-1]}:{waves}"
            rows = table("rao", DATABASE, "--heading", "150", "--omega", grid, *options)
            for i, row in enumerate(rows):
                value = complex_at(values, heading * waves * 6 + i)
                self.assertAlmostEqual(abs(value), float(row["amplitude"]),
                                       delta=2e-6 * abs(value) + 1e-12)

    def test_retardation(self):
        page = self.page["retardation"]
        tau = page["tau"]
        step = tau[40]
        rows = table("retardation", DATABASE, "--dt", repr(step), "--duration", repr(tau[-1]))
        largest = max(abs(k) for k in page["K"]["33"])
        for row in rows:
            if row["j"] + row["k"] == "33":
                value = page["K"]["33"][40 * round(float(row["tau"]) / step)]
                self.assertAlmostEqual(value, float(row["K0"]), delta=1e-6 * largest)

    def test_hydrostatics_and_righting_levers(self):
        page = self.page["ship"]
        rows = {row["name"]: float(row["value"]) for row in table("hydrostatics", SHIP)}
        self.assertEqual({name for name, _, _ in page["hydrostatics"]}, set(rows))
        for name, value, _ in page["hydrostatics"]:
            self.assertAlmostEqual(value, rows[name], delta=1e-7 * abs(rows[name]) + 1e-9)
        levers = table("righting", SHIP, "--heel", "0:180:37")
        self.assertEqual(page["righting"]["heelDeg"], [5 * i for i in range(37)])
        for value, row in zip(page["righting"]["gz"], levers):
            self.assertAlmostEqual(value, float(row["gz"]), delta=1e-6)

    def test_the_hull_is_closed_about_g(self):
        hull = self.page["ship"]["hull"]
        points, faces = blob(hull["points"]), blob(hull["faces"])
        corners = [points[3 * i:3 * i + 3] for i in range(len(points) // 3)]
        edges = set()
        for i in range(0, len(faces), 3):
            a, b, c = faces[i:i + 3]
            edges |= {(a, b), (b, c), (c, a)}
        self.assertTrue(all((b, a) in edges for a, b in edges))
        cog = self.page["ship"]["cog"]
        self.assertAlmostEqual(min(z for _, _, z in corners) + cog[2],
                               -self.page["ship"]["draught"], delta=1e-4)

    def test_panels_of_both_sides_and_pressures(self):
        """Of heave: ∫p n_z dS is at least what ω²A − iωB makes of it, and little more."""
        panels = self.page["ship"]["panels"]
        points, faces = blob(panels["points"]), blob(panels["faces"])
        count = len(faces) // 4
        self.assertEqual(len(blob(panels["quality"])), count)
        self.assertGreater(panels["lid"], 0)
        up = []
        for i in range(count):
            a, b, c, d = (points[3 * p:3 * p + 3] for p in faces[4 * i:4 * i + 4])
            up.append(0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])))
        hull = count - panels["lid"]
        self.assertAlmostEqual(sum(up[:hull]) / sum(up[hull:]), -1, delta=0.02)
        heave = next(f for f in panels["fields"] if f["name"].startswith("heave radiation"))
        omega = float(heave["name"].split()[2])
        table_ = self.page["coefficients"]
        at = min(range(len(table_["omega"])), key=lambda i: abs(table_["omega"][i] - omega))
        omega = table_["omega"][at]
        force = sum(abs(p * n) for p, n in zip(blob(heave["values"]), up[:hull]))
        wanted = abs(omega**2 * table_["A"]["33"][at] - 1j * omega * table_["B"]["33"][at])
        self.assertGreater(force, 0.99 * wanted)
        self.assertLess(force, 1.05 * wanted)

    def test_a_plain_bemio_file_lacks_a_hull_and_motions(self):
        """What it has is there, at its own headings; what it lacks is null, not an error."""
        plain = self.path("plain.h5")
        shutil.copy(DATABASE, plain)
        with h5py.File(plain, "a") as file:
            del file["cutwater"]
        page = self.data(database=plain)
        self.assertEqual(page["excitation"]["headingsDeg"], [0, 90, 180])
        self.assertEqual(page["raos"], [])
        for name in ("hydrostatics", "hull", "panels", "righting"):
            self.assertIsNone(page["ship"][name])
        self.assertIn("33", page["coefficients"]["A"])
        self.assertIn("33", page["retardation"]["K"])

    def test_gates(self):
        gates = {gate["name"].split(":")[0]: gate for gate in self.page["gates"]}
        for name in ("symmetry of the added mass A", "energy", "Kramers-Kronig closure", "memory",
                     "resolved by the panels"):
            self.assertIn(name, gates)
            self.assertIsInstance(gates[name]["value"], (int, float))
            self.assertIsInstance(gates[name]["passes"], bool)
        for gate in gates.values():
            self.assertTrue(gate["passes"] or gate["advice"], gate)


class Runs(Pages):
    def test_motions_sea_and_forces_are_the_run(self):
        run = self.simulated("run", motion="speed = 5.0\nkeep_course = true",
                             options=["--forces", "--wetted"])
        page = self.data(run)
        shown = page["runs"][0]
        self.assertEqual((shown["name"], shown["kind"], shown["mean"], shown["mode"]),
                         ("run", "simulate", "free", "nonlinear"))
        self.assertIn("JONSWAP, Hs 3 m, Tp 9 s, from 150 deg", shown["sea"]["text"])
        self.assertIsNone(shown["hull"])
        with open(self.path("run.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([c["name"] for c in shown["columns"]], list(rows[0]))
        self.assertEqual(shown["parts"][:2], ["gravity", "wetted_pressure"])
        columns = {}
        for column in shown["columns"]:
            values = series(column["series"])
            wanted = [float(row[column["name"]]) for row in rows]
            span = max(wanted) - min(wanted)
            worst = max(abs(a - b) for a, b in zip(values, wanted))
            self.assertLessEqual(worst, 1e-6 * span if span else 1e-8 * abs(wanted[0]))
            columns[column["name"]] = values
        for t, x, y, wave in zip(*(columns[name] for name in ("t", "x", "y", "wave"))):
            self.assertAlmostEqual(elevation(shown, t, x, y), wave, delta=1e-3)
        self.assertEqual(sorted({rao["speed"] for rao in page["raos"]}), [0, 5])
        linear = shown["linear"]
        values, waves = blob(linear["values"]), linear["omega"]
        grid = f"{waves[0]}:{waves[-1]}:{len(waves)}"
        rows = table("rao", DATABASE, "--speed", "5", "--heading", "150", "--omega", grid, "--free")
        for i, row in enumerate(rows):
            self.assertAlmostEqual(abs(complex_at(values, i)), float(row["amplitude"]),
                                   delta=2e-6 * float(row["amplitude"]) + 1e-12)

    def test_a_sweep(self):
        run = self.path("sweep.toml", SWEEP.format(database=DATABASE))
        self.assertEqual(call("sweep", run, "-o", self.path("sweep.csv")).returncode, 0)
        shown = self.data(run)["runs"][0]
        self.assertEqual((shown["kind"], shown["mean"]), ("sweep", "fixed"))
        with open(self.path("sweep.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for name, column in (("omega", "omega"), ("omegaE", "omega_e"), ("mode", "j"),
                             ("timeAmplitude", "time_amplitude"),
                             ("freqPhaseDeg", "freq_phase_deg")):
            self.assertEqual(shown["sweep"][name], [float(row[column]) for row in rows])

    def test_two_ships_and_a_body_in_one_sea(self):
        motion = "speed = 2.0\nmean = \"free\""
        runs = [self.simulated("one", motion=motion), self.simulated("two", BOAT, motion)]
        runs.append(self.path("crate.toml", BODY))
        with open(self.path("crate.csv"), "w", encoding="utf-8") as file:
            file.write(",".join(MOTIONS) + "\n")
            for i in range(3):
                file.write(f"{i},0,0,nan,0,0,0,0,0,0,0,0,0,0\n")
        one, two, crate = self.data(*runs)["runs"]
        self.assertIsNone(one["hull"])
        self.assertGreater(len(blob(two["hull"]["faces"])), 100)
        self.assertEqual(two["cogZ"], 0.3)
        self.assertEqual(crate["body"], {"size": [4, 3, 2]})
        self.assertIsNone(crate["linear"])
        self.assertTrue(math.isnan(series(crate["columns"][3]["series"])[0]))
        self.assertEqual(list(blob(crate["sea"]["omega"])), [0.8])

    def test_a_scene_of_several_bodies(self):
        """Of the demo `crane`: the load hangs 10 m below the boom's head at every common time."""
        subprocess.run([CRANE, DATABASE, self.path("crane.csv")], check=True, capture_output=True)
        runs = [self.path("crane_ship.toml"), self.path("crane_load.toml")]
        ship, load = self.data(*runs)["runs"]
        self.assertEqual((ship["mode"], ship["body"], load["body"]),
                         ("nonlinear", None, {"size": [2, 2, 2]}))
        rows = []
        for run in (ship, load):
            columns = [series(column["series"]) for column in run["columns"][:7]]
            rows.append({round(row[0], 6): row[1:] for row in zip(*columns)})
        common = sorted(set(rows[0]) & set(rows[1]))
        self.assertGreater(len(common), 3000)
        for t in common:
            x, y, z = (a - b for a, b in zip(rows[1][t], earth(rows[0][t], (-9, 12, 14))))
            self.assertAlmostEqual(math.sqrt(x * x + y * y + z * z), 10, delta=0.003)

    def test_long_runs_go_through_in_seconds(self):
        rows = 720000 if FULL else 72000
        run = self.path("long.toml", BODY)
        with open(self.path("long.csv"), "w", encoding="utf-8") as file:
            file.write(",".join(MOTIONS) + "\n")
            for i in range(rows):
                a = f"{math.sin(0.03 * i) + 0.3 * math.sin(0.0517 * i):.9g}"
                file.write(f"{0.05 * i:.9g}{(',' + a) * 13}\n")
        start = time.monotonic()
        shown = self.data(run)["runs"][0]
        self.assertLess(time.monotonic() - start, 60)
        self.assertEqual(shown["columns"][1]["series"]["n"], rows)
        sizes = [len(column["series"]["data"]) / rows for column in shown["columns"]]
        self.assertLess(sizes[0], 0.1)
        self.assertLess(max(sizes), 2.7)  # bytes of text a number

    def test_the_page_itself(self):
        done = call("report", DATABASE, "-o", self.path("page.html"))
        if done.returncode == 1 and "built without the page" in done.stderr:
            self.assertEqual(len(done.stderr.strip().splitlines()), 1)
            self.assertFalse(os.path.exists(self.path("page.html")))
            self.skipTest(done.stderr.strip())
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("page.html"), encoding="utf-8") as file:
            page = file.read()
        begin = '<script id="cutwater-data" type="application/json">'
        data = page[page.index(begin) + len(begin):].split("</script>")[0]
        self.assertEqual(json.loads(data), self.data())
        self.assertLess(len(page.encode()) - len(data.encode()), 1.5e6)


class Refusals(Pages):
    def run_with(self, text, toml=BODY):
        with open(self.path("bad.csv"), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path("bad.toml", toml)

    def test_a_run_without_its_csv(self):
        run = self.path("run.toml", RUN.format(database=DATABASE, motion=""))
        self.refused([DATABASE, run], "run.toml", "run.csv", "cutwater simulate")

    def test_columns_that_do_not_fit(self):
        head = ",".join(MOTIONS)
        for text, *words in (
                ("", "is empty"),
                ("t,x,y,height\n0,0,0,0\n", "column height", "must be z"),
                (head + ",drag_F1\n", "column (none)", "must be drag_F2"),
                (head + ",fuel\n", "column fuel", "is none of"),
                (head + ",wetted_area,fuel\n", "column fuel", "must be submerged_volume"),
                ("omega,omega_e,j,a\n", "column a", "must be time_amplitude"),
                (head + "\n", "no rows"),
                (head + "\n" + "0," * 12 + "0\n", "line 2", "13 values"),
                (head + "\n" + "0," * 13 + "wet\n", "line 2", "wave = wet", "must be a number"),
                (head + "\n" + 2 * ("1" + ",0" * 13 + "\n"), "line 3", "t = 1", "must rise"),
                (head + "\n" + "nan" + ",0" * 13 + "\n", "line 2", "t = nan")):
            with self.subTest(text=text[-40:]):
                self.refused([DATABASE, self.run_with(text)], "bad.csv", *words)

    def test_run_files_that_do_not_fit(self):
        rows = ",".join(MOTIONS) + "\n" + "0" + ",0" * 13 + "\n"
        for toml, *words in (
                ("[waves]\ntype = \"none\"\n", "database", "is missing"),
                ("[body]\nlength = 3.0\n", "[body] size", "is missing"),
                ("[body]\nsize = [1.0, -2.0, 3.0]\n", "[body] size", "must be above 0"),
                (BODY + "wind = 3.0\n", "wind", "unknown key"),
                ('database = "none.h5"\n', "database", "no file")):
            with self.subTest(toml=toml):
                self.refused([DATABASE, self.run_with(rows, toml)], "bad.toml", *words)

    def test_a_body_alone_is_not_to_be_run(self):
        done = call("simulate", self.path("crate.toml", BODY))
        self.assertEqual(done.returncode, 1)
        self.assertIn("database: is missing", done.stderr)

    def test_command_line(self):
        self.refused([self.path("none.h5")], "none.h5")
        self.assertEqual(call("report", DATABASE).returncode, 2)
        rows = ",".join(MOTIONS) + "\n" + "0" + ",0" * 13 + "\n"
        run = self.run_with(rows)
        done = call("report", DATABASE, run, "-o", self.path("bad.csv"))
        self.assertEqual(done.returncode, 1)
        with open(self.path("bad.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), rows)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
