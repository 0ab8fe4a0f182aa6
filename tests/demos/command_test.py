"""command_test.py COMMAND DATABASE MESHES: the contract that others script against.

Columns, conventions, exit codes.
"""
import csv
import io
import math
import os
import re
import shutil
import signal
import stat
import subprocess
import sys
import time
import unittest

from command import COMMAND, InFolder, call, table

DATABASE, MESHES = (os.path.abspath(a) if os.path.exists(a) else a for a in sys.argv[2:4])


SHIP = f"""[hull]
mesh = "{MESHES}/frigate/frigate_224.obj"
[mass]
cog = [-2.4044, 0.0, 1.29]
"""
RUN = f"""database = "{DATABASE}"
[bullet]
duration = 4.0
[waves]
type = "regular"
omega = 0.8
ramp = 1.0
"""


class Files(InFolder):
    def refused(self, arguments, *words, code=1):
        """Exit `code`, one line on stderr that names everything in `words`, nothing on stdout."""
        done = call(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        last = done.stderr.strip().splitlines()[-1]
        for word in words:
            self.assertIn(word, last)
        self.assertEqual(done.stdout, "")


class Tables(Files):
    def test_hydrostatics_names(self):
        rows = table("hydrostatics", self.path("s.toml", SHIP))
        values = {row["name"]: float(row["value"]) for row in rows}
        for name in ("volume displacement wetted_area waterplane_area lcb lcf kb C33 C35 C44 C55 "
                     "bm_t bm_l gm_t gm_l draft length beam").split():
            self.assertIn(name, values)
        # Inscribed 224 panels: within 0.3 % of the recipe's volume of that mesh.
        self.assertAlmostEqual(values["volume"] / 4458.2, 1, delta=0.003)
        self.assertAlmostEqual(values["C33"], 1025 * 9.80665 * values["waterplane_area"], delta=1)

    def test_coefficients_hold_both_limits(self):
        rows = table("coefficients", DATABASE)
        self.assertEqual(list(rows[0]), "omega j k A B dA_dx dB_dx".split())
        self.assertEqual(rows[0]["omega"], "0")
        self.assertEqual(rows[-1]["omega"], "inf")
        self.assertEqual(len(rows), 36 * 62)

    def test_excitation_of_long_waves_is_hydrostatic(self):
        rows = table("excitation", DATABASE, "--heading", "90", "--omega", "0.1:0.1:1")
        self.assertEqual(list(rows[0]), "omega omega_e j fk_re fk_im diff_re diff_im".split())
        heave = complex(float(rows[2]["fk_re"]), float(rows[2]["fk_im"]))
        # Waterplane of the coarse mesh to 1 %; e^{-kT} of this wave: 0.5 %.
        c33 = 1025 * 9.80665 * 1372.0
        self.assertAlmostEqual(abs(heave) / c33, 1, delta=0.02)

    def test_rao_of_long_waves_follows_the_surface(self):
        rows = table("rao", DATABASE, "--speed", "0", "--heading", "180", "--omega", "0.1:0.2:2")
        self.assertEqual(list(rows[0]), "omega omega_e j amplitude phase_deg".split())
        self.assertAlmostEqual(float(rows[2]["amplitude"]), 1, delta=0.02)
        self.assertAlmostEqual(float(rows[2]["phase_deg"]), 0, delta=2)
        for row in table("rao", DATABASE, "--heading", "37"):
            self.assertGreater(float(row["phase_deg"]), -180)
            self.assertLessEqual(float(row["phase_deg"]), 180)
        for odd in (1, 3, 5):  # head seas: no sway, roll, yaw
            self.assertLess(float(rows[odd]["amplitude"]), 1e-9)

    def test_default_wave_frequencies_are_the_solves(self):
        omegas = sorted({float(row["omega"]) for row in table("rao", DATABASE, "--heading", "180")})
        self.assertEqual(len(omegas), 37)
        self.assertAlmostEqual(omegas[0], 0.2)
        self.assertAlmostEqual(omegas[-1], 2.0)

    def test_retardation_integrates_to_nothing(self):
        rows = table("retardation", DATABASE, "--dt", "0.1", "--duration", "30")
        self.assertEqual(list(rows[0]), "tau j k K0 KU KUU".split())
        k33 = [float(row["K0"]) for row in rows if row["j"] == "3" and row["k"] == "3"]
        self.assertEqual(len(k33), 301)
        short = table("retardation", DATABASE, "--dt", "0.3", "--duration", "1.1")
        self.assertAlmostEqual(float(short[-1]["tau"]), 0.9)
        whole = 0.1 * (sum(k33) - 0.5 * (k33[0] + k33[-1]))
        # 0.5 % and as much for the trapezoid.
        self.assertLess(abs(whole), 0.01 * 0.1 * sum(map(abs, k33)))

    def test_info_says_what_is_in_the_file(self):
        names = {row["name"]: row["value"] for row in table("info", DATABASE)}
        self.assertEqual(float(names["frequencies"]), 60)
        self.assertEqual(names["code"], "Cutwater")
        self.assertNotEqual(float(names["check_damping_smallest_diagonal"]), 0)

    def test_a_database_knows_its_hull_files_axes_unit_and_origin(self):
        names = {row["name"]: row["value"] for row in table("info", DATABASE)}
        self.assertEqual([names[f"file_{name}"] for name in ("up", "forward", "unit")],
                         ["z", "x", "1"])
        lines = []
        with open(f"{MESHES}/frigate/frigate_224.obj", encoding="utf-8") as mesh:
            for line in mesh:
                if line.startswith("v "):
                    x, y, z = (100.0 * float(word) for word in line.split()[1:4])
                    line = f"v {-x} {z + 250.0} {y}\n"  # y up, -x forward: z to port, in cm
                lines.append(line)
        self.path("drawn.obj", "".join(lines))
        ship = self.path("s.toml", """[hull]
mesh = "drawn.obj"
up = "y"
forward = "-x"
unit = "cm"
waterline = 250.0
[mass]
cog = [-2.4044, 0.0, 1.29]
[solve]
omega = [0.8]
lid = false
""")
        done = call("solve", ship, "-o", self.path("s.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        names = {row["name"]: row["value"] for row in table("info", self.path("s.h5"))}
        self.assertEqual([names[f"file_{name}"] for name in ("up", "forward", "unit")],
                         ["y", "-x", "0.01"])
        self.assertEqual([float(names[f"file_origin_{axis}"]) for axis in "xyz"], [0, 0, -2.5])

    def test_headings_beyond_a_turn_are_the_same_directions(self):
        start = "[motion.start]\nyaw_deg = {}\nroll_deg = {}\n"
        plain = self.path("a.toml", RUN + "[motion]\nheading_deg = 40\n" + start.format(-10, 3))
        turned = self.path("b.toml",
                           RUN + "[motion]\nheading_deg = 400\n" + start.format(350, -357))
        self.assertEqual(table("simulate", plain), table("simulate", turned))

    def test_simulate_columns_and_start(self):
        run = self.path("run.toml", RUN)
        rows = table("simulate", run, "--forces")
        expected = "t x y z roll_deg pitch_deg yaw_deg u v w p q r wave".split()
        for part in ("gravity wetted_pressure restoring froude_krylov diffraction radiation "
                     "added_mass supplementary autopilots hull_lift resistance").split():
            expected += [f"{part}_F{i}" for i in range(1, 7)]
        self.assertEqual(list(rows[0]), expected)
        self.assertEqual(len(rows), 201)
        self.assertAlmostEqual(float(rows[0]["z"]), 1.29, delta=1e-9)
        self.assertAlmostEqual(float(rows[-1]["t"]), 4.0, delta=1e-9)
        # The ship is near the origin.
        self.assertAlmostEqual(float(rows[-1]["wave"]), math.cos(0.8 * 4.0), delta=0.01)

    def test_outside_the_theory_it_goes_on_and_says_so_once(self):
        run = self.path("run.toml", RUN + "[motion]\nmean = \"fixed\"\n"
                        "start = { x = 5000.0, z = 40.0 }\n")
        done = call("simulate", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 202)
        # At t = 0 the waves have not begun to grow.
        for name, words in (("kFarFromCourse", "first at t = 0.02 s, in 200 ticks, up to 50"),
                            ("kOutOfWater", "first at t = 0 s, in ")):
            lines = [line for line in done.stderr.splitlines() if name in line]
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertIn("cutwater: warning: " + run + ": ", lines[0])
            self.assertIn(words, lines[0])

    def test_single_precision_follows_double(self):
        double = table("simulate", self.path("d.toml", RUN))
        run = self.path("s.toml", RUN.replace("[waves]", "double = false\n[waves]"))
        single = table("simulate", run)
        self.assertNotEqual(double, single)  # chance may give one number the same nine digits
        self.assertAlmostEqual(float(double[-1]["z"]), float(single[-1]["z"]), delta=1e-4)

    def test_waves_shorter_than_the_panels_resolve_are_warned_of_once(self):
        resolved = next(float(row["value"]) for row in table("info", DATABASE)
                        if row["name"] == "omega_resolved")
        self.assertLess(resolved, 5)
        words = f"frigate.h5: panels resolve waves up to {resolved:.2f} rad/s"
        for omega, warnings in ((resolved - 0.1, 0), (resolved + 0.1, 1)):
            run = self.path("run.toml", RUN.replace("0.8", str(omega)))
            waves = ["--heading", "180", "--omega", f"0.5:{omega}:5"]
            for arguments in (["excitation", DATABASE, *waves], ["rao", DATABASE, *waves],
                              ["simulate", run], ["sweep", run.replace("run.toml", "sweep.toml")]):
                self.path("sweep.toml", RUN.replace("0.8", f"[{omega}]").replace("4.0", "20.0"))
                done = call(*arguments)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(done.stderr.count(words), warnings, done.stderr)

    def test_output_file_equals_stdout(self):
        target = self.path("o.csv")
        self.assertEqual(call("rao", DATABASE, "--heading", "30", "-o", target).returncode, 0)
        with open(target, encoding="utf-8") as file:
            self.assertEqual(file.read(), call("rao", DATABASE, "--heading", "30").stdout)


class ForwardSpeed(Files):
    """Made with Tuck's form, which needs nothing but A, B and the adjoint vectors."""

    def tuck(self, command, speed, *more):
        return table(command, DATABASE, "--speed", str(speed), "--form", "tuck", *more)

    def test_coefficients_at_speed(self):
        rest = {(r["omega"], r["j"], r["k"]): r for r in table("coefficients", DATABASE)}
        moving = {(r["omega"], r["j"], r["k"]): r for r in self.tuck("coefficients", 5)}
        a33 = float(rest["0.5", "3", "3"]["A"])
        change = float(moving["0.5", "5", "3"]["B"]) - float(rest["0.5", "5", "3"]["B"])
        self.assertAlmostEqual(change / (-5 * a33), 1, delta=1e-6)  # nine digits of a difference
        change = float(moving["0.5", "5", "5"]["A"]) - float(rest["0.5", "5", "5"]["A"])
        # besides (U/w^2)(B_35 - B_53), which is the solver's asymmetry
        self.assertAlmostEqual(change / ((5 / 0.5) ** 2 * a33), 1, delta=0.01)
        self.assertTrue(math.isnan(float(moving["0", "5", "5"]["A"])))  # diverges
        self.assertEqual(moving["0", "3", "3"]["A"], rest["0", "3", "3"]["A"])
        self.assertEqual(moving["0.5", "2", "4"]["dA_dx"], rest["0.5", "2", "4"]["dA_dx"])

    def test_omega_e_is_signed(self):
        rows = self.tuck("rao", 10, "--heading", "0", "--omega", "0.4:1.6:4")
        for row in rows:
            omega, met = float(row["omega"]), float(row["omega_e"])
            self.assertAlmostEqual(met, omega - 10 * omega**2 / 9.80665, delta=1e-8)
            self.assertTrue(math.isfinite(float(row["amplitude"])))
        self.assertLess(float(rows[-1]["omega_e"]), 0)

    def test_speed_does_not_change_the_incident_wave(self):
        rest = table("excitation", DATABASE, "--heading", "30", "--omega", "0.6:1.2:3")
        moving = self.tuck("excitation", 7, "--heading", "30", "--omega", "0.6:1.2:3")
        self.assertEqual([r["fk_re"] for r in rest], [r["fk_re"] for r in moving])
        self.assertNotEqual([r["diff_re"] for r in rest], [r["diff_re"] for r in moving])

    def test_standing_waves_are_nan_with_one_warning(self):
        done = call("rao", DATABASE, "--speed", "9.80665", "--form", "tuck", "--heading", "0",
                    "--omega", "0.99:1.01:3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)
        self.assertIn("0.1 rad/s", done.stderr)

    def test_the_form_of_the_file_is_the_default(self):
        names = {row["name"]: row["value"] for row in table("info", DATABASE)}
        self.assertEqual(names["forward_speed"], "tuck")
        self.assertEqual(names["adjoint_vectors_dx"], "0")
        moving = ["rao", DATABASE, "--speed", "8", "--heading", "180", "--omega", "0.2:0.3:2"]
        rows = table(*moving)
        self.assertEqual(rows, table(*moving, "--form", "tuck"))
        self.assertAlmostEqual(float(rows[2]["amplitude"]), 1, delta=0.1)
        self.refused([*moving, "--form", "report"], "frigate.h5", "forward_speed")

    def test_a_table_of_one_form_is_not_read_as_the_other(self):
        ship = self.path("s.toml", SHIP + """[solve]
omega = [0.5, 1.0, 1.5]
wave_omega = [0.5, 0.8]
speeds = [0.0, 5.0]
influence = "direct"
forward_speed = "report"
""")
        database = self.path("direct.h5")
        done = call("solve", ship, "-o", database)
        self.assertEqual(done.returncode, 0, done.stderr)
        at_speed = [database, "--speed", "5", "--heading", "180", "--omega", "0.5:0.8:2"]
        own = table("excitation", *at_speed)
        self.assertEqual(own, table("excitation", *at_speed, "--form", "report"))
        self.refused(["excitation", *at_speed, "--form", "tuck"], "direct.h5", "other form")
        self.refused(["rao", *at_speed, "--form", "tuck"], "direct.h5", "other form")
        # Radiation needs no table: A and B of either form are there.
        self.assertNotEqual(table("coefficients", database, "--speed", "5"),
                            table("coefficients", database, "--speed", "5", "--form", "tuck"))


class FreeShip(Files):
    """A ship on no course: `rao --free` beside `sweep` with mean = "free"."""

    SWEEP = RUN.replace("omega = 0.8", "omega = [0.8]\namplitude = 0.01").replace(
        "duration = 4.0", "duration = 600.0").replace("ramp = 1.0", "ramp = 60.0")

    def test_a_sweep_of_a_free_ship_stands_beside_rao_free(self):
        # The helmsman answers the slow motion alone: without him the ship would not keep its course
        # for ten minutes. Drag is in neither.
        run = self.path("w.toml", self.SWEEP + """[motion]
mean = "free"
speed = 5.0
heading_deg = 150.0
keep_course = true
""")
        rows = table("sweep", run)
        free = ["rao", DATABASE, "--free", "--speed", "5", "--heading", "150", "--omega"]
        expected = table(*free, "0.8:0.8:1")
        self.assertEqual(len(rows), 6)
        for row, of_rao in zip(rows, expected):
            self.assertEqual(row["freq_amplitude"], of_rao["amplitude"])
            self.assertEqual(row["freq_phase_deg"], of_rao["phase_deg"])
            # What the project accepts of a free ship: 1 % and 3 degrees.
            ratio = float(row["time_amplitude"]) / float(of_rao["amplitude"])
            self.assertAlmostEqual(ratio, 1, delta=0.01, msg=row)
            off = float(row["time_phase_deg"]) - float(of_rao["phase_deg"])
            self.assertLess(abs((off + 180) % 360 - 180), 3.0, row)
        fixed = table("rao", *free[1:2], *free[3:], "0.8:0.8:1")
        self.assertNotEqual([row["amplitude"] for row in fixed],
                            [row["amplitude"] for row in expected])
        self.refused([*free, "0.8:0.8:1", "--form", "report"], "--free", "Tuck", code=2)

    def test_a_free_ship_that_did_not_keep_its_way_is_no_answer(self):
        run = self.path("w.toml", self.SWEEP + "[motion]\nmean = \"free\"\nspeed = 5.0\n"
                        "resistance = true\n")
        done = call("sweep", run)  # no engine
        self.assertEqual(done.returncode, 1, done.stderr)
        warned = [line for line in done.stderr.splitlines() if "written as nan" in line]
        self.assertEqual(len(warned), 1, done.stderr)
        for word in ("w.toml: [waves] omega = 0.8: the ship did not keep its way", "keep_speed"):
            self.assertIn(word, warned[0])
        self.assertIn("w.toml: [motion]: in no wave", done.stderr.strip().splitlines()[-1])
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        self.assertEqual([row["time_amplitude"] for row in rows], ["nan"] * 6)

    def test_a_yaw_that_nothing_holds_is_warned_of(self):
        """The frigate without the yaw stiffness that stands for a helmsman."""
        ship = self.path("s.toml", SHIP + """[solve]
omega = { from = 0.1, to = 4.0, step = 0.1 }
[supplementary]
roll_damping = 2.0e7
""")
        database = self.path("s.h5")
        self.assertEqual(call("solve", ship, "-o", database).returncode, 0)
        loose = self.SWEEP.replace(DATABASE, database) + "[motion]\nspeed = 8.0\n"

        def warnings(done):
            self.assertEqual(done.returncode, 0, done.stderr)
            return [line for line in done.stderr.splitlines() if "nothing holds the yaw" in line]

        def said(motion):
            text = loose.replace("[0.8]", "0.8").replace("600.0", "4.0")
            return warnings(call("simulate", self.path("r.toml", text + motion)))

        done = call("sweep", self.path("w.toml", loose + "heading_deg = 120.0\n"))
        self.assertEqual(len(warnings(done)), 1)
        # It turns away; heave and pitch go on as before.
        lines = [line for line in done.stderr.splitlines() if "no harmonic" in line]
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertIn("w.toml: [waves] omega = 0.8: ", lines[0])
        self.assertIn("yaw", lines[0])
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        self.assertEqual([row["time_amplitude"] == "nan" for row in rows],
                         [name in lines[0] for name in
                          "surge sway heave roll pitch yaw".split()])
        self.assertTrue(all(math.isfinite(float(row["freq_amplitude"])) for row in rows))
        with_warning = said('mean = "fixed"\n')
        self.assertEqual(len(with_warning), 1)
        for word in ("r.toml: [motion] speed = 8 m/s", "yaw_stiffness", "keep_course", "free"):
            self.assertIn(word, with_warning[0])
        for held in ('mean = "fixed"\nkeep_course = true\n', 'mean = "fixed"\nrestrain = [6]\n',
                     'mean = "free"\n'):
            self.assertEqual(said(held), [])


class Loading(Files):
    BEAM = ["rao", DATABASE, "--heading", "90", "--omega", "0.5:0.6:2"]

    def test_a_higher_centre_of_gravity_rolls_slower(self):
        low = table(*self.BEAM, "--cog", "-2.4044,0,-0.5")
        high = table(*self.BEAM, "--cog", "-2.4044,0,2.5")
        self.assertNotEqual(low[3]["amplitude"], high[3]["amplitude"])
        same = table(*self.BEAM, "--cog", "-2.4044,0,1.29", "--gyradii", "5.82,28.8,28.8")
        self.assertEqual(same, table(*self.BEAM))

    def test_another_waterline_is_refused(self):
        self.refused([*self.BEAM, "--mass", "1e6"], "frigate.h5", "mass = 1000000", "displaces")
        self.refused([*self.BEAM, "--cog", "5,0,1"], "frigate.h5", "cog x = 5", "buoyancy")
        done = call(*self.BEAM, "--cog", "5,0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--cog 5,0: must be three numbers", done.stderr)
        self.assertNotIn("frigate.h5", done.stderr)
        self.refused([*self.BEAM, "--gyradii", "5,-1,1"], "gyradii", "-1")


class Interruption(Files):
    SOLVE = SHIP + "[solve]\nomega = { from = 0.1, to = 3.0, step = 0.05 }\n"

    def start(self, ship, database):
        return subprocess.Popen([COMMAND, "solve", ship, "-o", database, "--threads", "1"],
                                stderr=subprocess.PIPE, text=True)

    def test_a_killed_solve_goes_on_from_finished_frequencies_to_the_same_answers(self):
        ship, database = self.path("s.toml", self.SOLVE), self.path("s.h5")
        for end in (signal.SIGKILL, signal.SIGINT):
            running = self.start(ship, database)
            journal = database + ".sweep"
            before = os.path.getsize(journal) if os.path.exists(journal) else 0
            while running.poll() is None and not (
                    os.path.exists(journal) and os.path.getsize(journal) > max(before, 1000)):
                time.sleep(0.01)
            running.send_signal(end)
            message = running.communicate()[1]
            self.assertNotEqual(running.returncode, 0)
            self.assertFalse(os.path.exists(database))
            if end == signal.SIGINT:
                self.assertEqual(running.returncode, 1)
                self.assertRegex(message.splitlines()[-1], "interrupted; [0-9]+ of 59 .*s.h5.sweep")
        done = call("solve", ship, "-o", database)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "[0-9]+ of 59 frequencies taken from .*s.h5.sweep")
        self.assertFalse(os.path.exists(database + ".sweep"))
        whole = self.path("whole.h5")
        self.assertEqual(call("solve", ship, "-o", whole).returncode, 0)
        for what in ("coefficients", "excitation"):
            options = () if what == "coefficients" else ("--speed", "0", "--heading", "150")
            self.assertEqual(table(what, database, *options), table(what, whole, *options))


class Mask(Files):
    def test_masked_frequencies_are_interpolated_and_listed(self):
        ship = self.path("s.toml", SHIP + """[solve]
omega = { from = 0.4, to = 2.0, step = 0.4 }
wave_omega = [0.5, 1.0]
condition_limit_even = [[1.1, 1e12], [1.19, 1.0], [1.21, 1.0], [1.3, 1e12]]
""")
        database = self.path("mask.h5")
        done = call("solve", ship, "-o", database)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 of 5 frequencies masked", done.stderr)
        names = {row["name"]: row["value"] for row in table("info", database)}
        self.assertEqual(names["masked_frequencies"], "1")
        self.assertEqual(names["masked_omega"], "1.2")
        self.assertIn("condition limits with lid = true", done.stderr)
        self.assertNotIn("condition_limit_odd", done.stderr)
        nothing = self.path("n.toml", SHIP + "[solve]\nomega = [0.5, 1.0]\nwave_omega = 0.5\n"
                            "condition_limit_even = [[1.0, 1.0]]\n")
        self.refused(["solve", nothing, "-o", self.path("n.h5")], "n.toml", "0 of 2")

    def test_a_limit_of_odd_modes_needs_symmetry(self):
        whole = SHIP.replace("[mass]", "symmetric = \"none\"\n[mass]")
        ship = self.path("w.toml", whole + """[solve]
omega = [0.5, 1.0]
lid = false
condition_limit_odd = [[1.0, 1e12]]
""")
        done = call("solve", ship, "-o", self.path("w.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("w.toml: [solve] condition_limit_odd", done.stderr)
        self.assertNotIn("lid = true", done.stderr)


def read(path, mode="r"):
    with open(path, mode, encoding=None if "b" in mode else "utf-8") as file:
        return file.read()


class Unfinished(Files):
    """A grid too coarse for a memory: the frequency domain works, the time domain refuses."""

    def solve(self, omega):
        database = self.path("u.h5")
        ship = self.path("s.toml", SHIP + f"[solve]\nomega = {omega}\n")
        done = call("solve", ship, "-o", database)
        self.assertEqual(done.returncode, 0, done.stderr)
        return database, done.stderr

    def refused_in_time(self, database, *words):
        run = RUN.replace(DATABASE, database)
        self.refused(["simulate", self.path("r.toml", run)], "unfinished", *words)
        sweep = run.replace("omega = 0.8", "omega = [0.8]")
        self.refused(["sweep", self.path("w.toml", sweep)], "unfinished", *words)
        self.refused(["retardation", database, "--dt", "0.1", "--duration", "20"], "u.h5",
                     "unfinished", *words)
        names = {row["name"]: row["value"] for row in table("info", database)}
        self.assertEqual(names["status"], "unfinished")
        for word in words:
            self.assertIn(word, names["unfinished_because"])

    def test_a_single_frequency_works_in_the_frequency_domain(self):
        database, said = self.solve("[0.8]")
        self.assertIn("s.toml: [solve] omega", said)
        self.assertIn("0.1 rad/s (0.36 sqrt(g/L))", said)
        self.refused_in_time(database, "one frequency")
        rows = table("coefficients", database)
        self.assertEqual([row["omega"] for row in rows[::36]], ["0", "0.8", "inf"])
        whole = {row["omega"]: row for row in table("coefficients", DATABASE)[14::36]}  # j = k = 3
        for name in ("A", "B"):
            ratio = float(rows[36 + 14][name]) / float(whole["0.8"][name])
            self.assertAlmostEqual(ratio, 1, delta=1e-8)
        for command in ("excitation", "rao"):
            rows = table(command, database, "--heading", "150")
            self.assertEqual({row["omega"] for row in rows}, {"0.8"})
            self.assertTrue(all(math.isfinite(float(list(row.values())[-1])) for row in rows))
        self.refused(["rao", database, "--heading", "150", "--omega", "0.7:0.7:1"], "u.h5", "0.7")

    def test_steps_too_coarse_are_said_with_the_step_that_would_do(self):
        database, said = self.solve("{ from = 0.2, to = 4.0, step = 0.2 }")
        self.assertIn("steps of 0.2 rad/s are too coarse, 0.1 rad/s (0.36 sqrt(g/L)) would do",
                      said)
        self.refused_in_time(database, "0.2 rad/s")
        rows = table("rao", database, "--heading", "150", "--omega", "0.6:0.8:2")
        self.assertTrue(all(math.isfinite(float(row["amplitude"])) for row in rows))

    def test_frequencies_that_end_too_low_are_said_with_the_range_that_would_do(self):
        database, said = self.solve("{ from = 0.1, to = 1.0, step = 0.1 }")
        self.assertIn("end at 1 rad/s", said)
        self.assertIn("(3 sqrt(g/beam)) would do", said)
        self.refused_in_time(database, "end at 1 rad/s")

    def test_a_grid_for_zero_speed_only_is_warned_of(self):
        database, said = self.solve("{ from = 0.15, to = 6.0, step = 0.15 }")
        self.assertIn("K^UU", said)
        self.assertIn("steps of 0.15 rad/s are too coarse, 0.1 rad/s", said)
        names = {row["name"]: row["value"] for row in table("info", database)}
        self.assertEqual(names["status"], "finished")


class Panels(Files):
    FRIGATE = os.path.join(MESHES, "frigate", "frigate_1040.obj")

    def panelled(self, count, *more):
        out = self.path("p.obj")
        done = call("panel", self.FRIGATE, "-n", str(count), "-o", out, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out, done.stderr

    def test_a_mesh_becomes_about_as_many_panels(self):
        out, said = self.panelled(224)
        self.assertIn("panels a side", said)
        self.assertEqual(said.count("\n"), 1)  # a sound hull: nothing repaired
        ship = self.path("s.toml", SHIP.replace(f"{MESHES}/frigate/frigate_224.obj", out))
        values = {row["name"]: float(row["value"]) for row in table("hydrostatics", ship)}
        # Rows and stations are whole numbers; the volume is that of so many inscribed panels: 1.5 %
        # off.
        self.assertAlmostEqual(values["panels"] / 224, 1, delta=0.06)
        self.assertEqual(values["symmetric"], 1)
        self.assertAlmostEqual(values["volume"] / 4509.0, 1, delta=0.015)

    def test_a_count_in_the_ship_file_is_the_same(self):
        self.panelled(224)
        ship = self.path("s.toml", SHIP.replace("frigate_224.obj\"",
                                                "frigate_1040.obj\"\npanels = 224"))
        values = {row["name"]: float(row["value"]) for row in table("hydrostatics", ship)}
        out = self.path("q.obj")
        self.assertEqual(call("panel", ship, "-n", "224", "-o", out).returncode, 0)
        faces, others = ([line for line in read(path).splitlines() if line.startswith("f")]
                         for path in (out, self.path("p.obj")))
        self.assertEqual(faces, others)
        self.assertEqual(values["panels"], len(faces) / 2)
        solve = self.path("t.toml", read(ship) + "[solve]\nomega = [0.5, 1.0]\nwave_omega = 0.5\n"
                          "lid = false\n")
        done = call("solve", solve, "-o", self.path("t.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{len(faces) // 2} panels a side", done.stderr)

    def test_what_cannot_be_panelled_is_refused_and_nothing_written(self):
        lines = read(self.FRIGATE).splitlines()
        heights = [float(line.split()[3]) for line in lines if line.startswith("v ")]
        bottomless = [line for line in lines if not line.startswith("f ")
                      or max(heights[int(word) - 1] for word in line.split()[1:]) > -4.5]
        hull = self.path("hull.obj", "\n".join(bottomless) + "\n")
        out = self.path("p.obj")
        self.refused(["panel", hull, "-n", "224", "-o", out], "hull.obj", "hole", "m wide", "at (")
        self.refused(["panel", self.path("none.obj"), "-n", "224", "-o", out], "none.obj")
        self.refused(["panel", self.FRIGATE, "-n", "224", "-o", self.FRIGATE],
                     "is the file that is read")
        axes = ["--up", "y", "--forward", "-y"]
        self.refused(["panel", self.FRIGATE, *axes, "-n", "224", "-o", out], "forward", "up")
        self.assertFalse(os.path.exists(out))
        for bad in ("5", "-3", "1e9", "many"):
            self.assertEqual(call("panel", self.FRIGATE, "-n", bad, "-o", out).returncode, 2)
        for bad in ("3", "0.5", "-7", "1000000"):
            text = SHIP.replace("frigate_224.obj\"", f"frigate_224.obj\"\npanels = {bad}")
            self.refused(["hydrostatics", self.path("s.toml", text)], "s.toml", "[hull] panels",
                         bad)


class Outputs(Files):
    """Nothing that is read is written over; what is written is whole, or not there."""

    def unharmed(self, path, arguments, *words):
        before = read(path, "rb")
        self.refused([*arguments, "-o", path], *words)
        self.assertEqual(read(path, "rb"), before)

    def test_inputs_that_a_toml_names_are_not_outputs(self):
        mesh, database, waves = (self.path(name) for name in ("hull.obj", "d.h5", "s.h5"))
        shutil.copy(f"{MESHES}/frigate/frigate_224.obj", mesh)
        shutil.copy(DATABASE, database)
        ship = self.path("s.toml", SHIP.replace(f"{MESHES}/frigate/frigate_224.obj", "hull.obj"))
        text = RUN.replace(DATABASE, "d.h5")
        run = self.path("r.toml", text)
        both = self.path("b.toml", 'ship = "s.toml"\n' + text)
        sweep = self.path("w.toml", 'ship = "s.toml"\n' + text.replace("0.8", "[0.8]"))
        for command in ("hydrostatics", "solve"):
            self.unharmed(mesh, [command, ship], "s.toml: [hull] mesh", "hull.obj", "-o")
            self.unharmed(ship, [command, ship], "s.toml", "file that is read")
        self.unharmed(mesh, ["panel", ship, "-n", "100"], "[hull] mesh")
        self.unharmed(database, ["simulate", run], "r.toml: database", "d.h5")
        self.unharmed(run, ["simulate", run], "r.toml")
        for command, path in (("simulate", both), ("sweep", sweep)):
            for other in (database, ship, mesh):
                self.unharmed(other, [command, path], os.path.basename(other))
        # Under another name: a link, and a second name of the same file.
        os.symlink("d.h5", self.path("link.h5"))
        os.link(database, self.path("second.h5"))
        for name in ("link.h5", "second.h5"):
            self.unharmed(self.path(name), ["simulate", run], "d.h5")
            self.unharmed(self.path(name), ["rao", database, "--heading", "0"], name)
        self.assertFalse(os.path.exists(waves))

    def rao(self, out, **more):
        return subprocess.run([COMMAND, "rao", DATABASE, "--heading", "30", "-o", out],
                              capture_output=True, text=True, check=False, **more)

    def test_an_output_keeps_its_mode_and_links_stay_links(self):
        ship = self.path("s.toml", SHIP + "[solve]\nomega = [0.5, 1.0]\nlid = false\n")
        for name, arguments in (("o.csv", ["rao", DATABASE, "--heading", "30"]),
                                ("o.h5", ["solve", ship])):
            target, link = self.path(name, "old"), self.path("link_" + name)
            os.chmod(target, 0o640)
            os.symlink(name, link)
            done = call(*arguments, "-o", link)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(os.path.islink(link))
            self.assertEqual(os.stat(target).st_mode & 0o777, 0o640)
            self.assertNotEqual(read(target, "rb"), b"old")
            os.chmod(target, 0o444)  # root may write it; whoever set this did not want it
            before = read(target, "rb")
            self.refused([*arguments, "-o", link], "link_" + name, "read-only")
            self.assertEqual(read(target, "rb"), before)
        self.assertEqual(sorted(os.listdir(self.folder.name)),
                         ["link_o.csv", "link_o.h5", "o.csv", "o.h5", "s.toml"])

    def test_no_link_in_the_way_is_followed(self):
        victim = self.path("victim", "mine")
        target = self.path("o.csv")
        for number in range(200):  # names that older versions took
            for name in (f"{target}.part{number}", f"{target}.{number}.tmp"):
                os.symlink("victim", name)
        self.assertEqual(self.rao(target).returncode, 0)
        self.assertEqual(read(victim), "mine")
        journal = self.path("d.h5.sweep")
        os.symlink("victim", journal)
        ship = self.path("s.toml", SHIP + "[solve]\nomega = [0.5, 1.0]\n")
        self.refused(["solve", ship, "-o", self.path("d.h5")], "d.h5.sweep", "link")
        self.assertEqual(read(victim), "mine")

    def test_pipes_are_written_through_and_databases_need_files(self):
        pipe = self.path("pipe")
        os.mkfifo(pipe)
        with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
            self.assertEqual(self.rao(pipe).returncode, 0)
            self.assertEqual(reader.communicate()[0],
                             call("rao", DATABASE, "--heading", "30").stdout)
        self.assertTrue(stat.S_ISFIFO(os.stat(pipe).st_mode))
        self.assertEqual(self.rao("/dev/null").returncode, 0)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        ship = self.path("s.toml", SHIP)
        for device in (pipe, "/dev/null"):
            self.refused(["solve", ship, "-o", device], device, "not a file")
        self.assertFalse(os.path.exists("/dev/null.sweep"))

    def test_reasons_are_said(self):
        for out, reason in ((self.path("no/folder.csv"), "no folder"),
                            (self.folder.name, "directory"),
                            (self.path("s.toml", SHIP) + "/x.csv", "ot a directory"),
                            ("/dev/full", "space")):
            done = self.rao(out)
            self.assertEqual(done.returncode, 1)
            self.assertIn("cannot be written", done.stderr)
            self.assertIn(reason, done.stderr)

    def test_stderr_closed_or_full_fails_no_run(self):
        ship = self.path("s.toml", SHIP + "[solve]\nomega = [0.5, 1.0]\n")
        run = self.path("r.toml", RUN)
        for command, out in ((f"solve {ship}", "o.h5"), (f"simulate --forces {run}", "o.csv")):
            out = self.path(out)
            whole = None
            for stderr in ("2>/dev/null", "2>&-", "2>/dev/full", "2> >(exit 0)"):
                done = subprocess.run(["bash", "-c", f"'{COMMAND}' {command} -o {out} {stderr}"],
                                      check=False)
                self.assertEqual(done.returncode, 0, (command, stderr))
                # No message has strayed into it. HDF5 notes the time of day, so not its bytes.
                found = table("coefficients", out) if out.endswith("h5") else read(out)
                self.assertEqual(found, whole or found, (command, stderr))
                whole = found
        for stdout in (">&-", ">/dev/full"):
            line = f"'{COMMAND}' rao '{DATABASE}' --heading 30 {stdout}"
            done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertIn("stdout: cannot be written: ", done.stderr)
        line = f"'{COMMAND}' rao '{DATABASE}' --heading 30 | head -n 1"
        done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout[:5], done.stderr), ("omega", ""))


class Values(Files):
    def test_files_that_are_none(self):
        for mesh, word in (("", "must name a file"), (self.folder.name, "is a folder"),
                           ("none.obj", "none.obj")):
            text = SHIP.replace(f"{MESHES}/frigate/frigate_224.obj", mesh)
            self.refused(["hydrostatics", self.path("s.toml", text)], "s.toml: [hull] mesh", word)
        run = self.path("r.toml", RUN.replace(DATABASE, ""))
        self.refused(["simulate", run], "r.toml: database", "must name a file")
        self.refused(["hydrostatics", self.folder.name], self.folder.name, "is a folder")

    def test_a_hull_on_its_side(self):
        for degrees in (90, -90, 180, "nan"):
            text = SHIP.replace("[mass]", f"heel_deg = {degrees}\n[mass]")
            self.refused(["hydrostatics", self.path("s.toml", text)],
                         f"s.toml: [hull] heel_deg = {degrees}", "89.9")

    def test_a_run_that_memory_cannot_hold(self):
        for command, omega in (("simulate", "0.8"), ("sweep", "[0.8]")):
            text = RUN.replace("duration = 4.0", "duration = 1e6\ndt = 1e-4")
            run = self.path("r.toml", text.replace("0.8", omega))
            self.refused([command, run], "r.toml: [bullet] duration = 1", "dt = 0.0001", "GB")

    def test_numbers_of_options(self):
        rao = ["rao", DATABASE, "--heading", "180"]
        for arguments, words in (
                (["retardation", DATABASE, "--dt", "0.1", "--duration", "inf"], ["duration inf"]),
                (["retardation", DATABASE, "--dt", "inf", "--duration", "inf"], ["dt inf"]),
                (["retardation", DATABASE, "--dt", "nan", "--duration", "3"], ["dt nan"]),
                (["rao", DATABASE, "--heading", ""], ["--heading", "value is missing"]),
                (["rao", DATABASE, "--heading="], ["--heading", "value is missing"]),
                ([*rao, "--cog", "0,0,1e308"], ["--cog 0,0,1e308", "1000000"]),
                ([*rao, "--gyradii", "1e308,1,1"], ["--gyradii 1e308,1,1"]),
                ([*rao, "--cog", "0,0,nan"], ["--cog 0,0,nan"]),
                ([*rao, "--mass", "inf"], ["--mass inf"]),
                ([*rao, "--speed", "inf"], ["--speed inf"]),
                (["rao", DATABASE, "--heading", "inf"], ["--heading inf"])):
            self.refused(arguments, *words, code=2)

    def test_cut_offs_of_spectra(self):
        text = RUN.replace('"regular"', '"jonswap"').replace("omega = 0.8", "tp = 9.0")
        # 4 omega_p of 9 s is 2.793 rad/s, half of omega_p 0.3491.
        for cut, words in (("omega_min = 5.0", ["omega_min = 5", "2.793"]),
                           ("omega_max = 0.3", ["omega_max = 0.3", "0.3491"]),
                           ("omega_min = 2.0\nomega_max = 1.0",
                            ["omega_max = 1", "omega_min", "2"])):
            run = self.path("r.toml", text.replace("ramp", cut + "\nramp"))
            self.refused(["simulate", run], "r.toml: [waves]", *words)
        # A sea of 3 s ends at 8.4 rad/s, the database at 6: waves beyond have no loads, as is said.
        run = self.path("r.toml", text.replace("9.0", "3.0"))
        done = call("simulate", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = re.search(r"omega_max = 6 rad/s of the database: (\d+) of 200 waves are beyond it, "
                         r"([\d.]+) % of m0", done.stderr)
        self.assertTrue(said, done.stderr)
        # Bins of equal width from 1.047 to 8.378 rad/s: 65 of 200 lie beyond 6, one more or less.
        self.assertAlmostEqual(int(said.group(1)), 65, delta=1)
        # Below r = omega/omega_p Bretschneider's sea has exp(-1.25 r^-4) of its energy; JONSWAP's
        # peak leaves the rest 1 - 0.287 ln(gamma) of that (a fit of the literature, good to 1 %);
        # a bin's share may fall to either side: 2 %.
        omega_p = 2 * math.pi / 3
        below = [math.exp(-1.25 * (omega / omega_p) ** -4) for omega in (6.0, 4 * omega_p)]
        expected = 100 * (below[1] - below[0]) * (1 - 0.287 * math.log(3.3))
        self.assertAlmostEqual(float(said.group(2)) / expected, 1, delta=0.03)
        # All of a sea may be beyond, and what was asked for by name; one regular wave may not.
        for cut in (text.replace("9.0", "0.4"), text.replace("9.0", "9.0\nomega_max = 8.0")):
            done = call("simulate", self.path("s.toml", cut))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("omega_max = 6 rad/s of the database", done.stderr)
        self.refused(["simulate", self.path("o.toml", RUN.replace("omega = 0.8", "omega = 6.5"))],
                     "6.5", "6")

    def test_ranges_name_the_nearest_right_value(self):
        for omega, words in (
                ("{ from = 0.1, to = 6.03, step = 0.1 }", ["to = 6.03", "6", "0.1005"]),
                ("{ from = 0.1, to = 0.99, step = 0.1 }", ["to = 0.99", "1,", "0.0988889"]),
                ("{ from = 0.1, to = 6.0, step = 1e-6 }", ["step = 1e-06", "5.9001e-05"]),
                ("{ from = 0.1, to = 6.0, step = 0.0 }", ["step = 0", "above 0"]),
                ("{ from = 0.1, to = 6.0, step = -0.1 }", ["step = -0.1", "above 0"]),
                ("{ from = 2.0, to = 1.0, step = 0.1 }", ["to = 1", "from = 2"])):
            ship = self.path("s.toml", SHIP + f"[solve]\nomega = {omega}\n")
            self.refused(["hydrostatics", ship], "s.toml: [solve.omega]", *words)

    def test_a_drag_engine_or_rudder_that_no_ship_has_is_refused(self):
        for text, words in (
                ("[resistance]\ncross_flow_drag = -1.0\n", ["[resistance] cross_flow_drag = -1"]),
                ("[engine]\nastern = 2.0\n", ["[engine] astern = 2", "0..1"]),
                ("[engine]\nmax_thrust = \"lots\"\n", ["[engine] max_thrust", "auto"]),
                ("[engine]\npower = 1.0\n", ["[engine] power", "unknown key"]),
                ("[engine]\nplace = 3.0\n", ["[engine] place"]),
                ("[rudder]\nlimit_deg = 120.0\n", ["[rudder] limit_deg = 120", "90"]),
                ("[rudder]\nrate_deg = 0.0\n", ["[rudder] rate_deg = 0"])):
            self.refused(["hydrostatics", self.path("s.toml", SHIP + text)], "s.toml: ", *words)
        for text in ("[engine]\n[rudder]\n", "[engine]\nplace = [-50.0, 0.0, -3.0]\n",
                     "[rudder]\narea = \"auto\"\nplace = \"auto\"\nrate_deg = 2.5\n"):
            done = call("hydrostatics", self.path("s.toml", SHIP + text))
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_control_characters_and_long_values_are_not_echoed(self):
        long = "x" * 5000
        for text in (SHIP + f'[water]\ndensity = "\\u001b[31m\\u0007{long}"\n',
                     SHIP + f'["\\u001b]0;{long}"]\nx = 1\n',
                     SHIP.replace("frigate_224", f"\\u001b[2J{long}")):
            done = call("hydrostatics", self.path("s.toml", text))
            self.assertEqual(done.returncode, 1)
            self.assertLess(len(done.stderr), 600)
            self.assertFalse([c for c in done.stderr if ord(c) < 32 and c != "\n"], done.stderr)
        for arguments in (["rao", DATABASE, "--heading", "\x1b[31m" + long],
                          ["rao", DATABASE, "--heading", "0", "--omega", "\x1b" + long],
                          ["rao", DATABASE, "--heading", "0", "--cog", "\x1b" + long],
                          ["\x1b[31m" + long], ["info", "\x1b[31m.h5"]):
            done = call(*arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertLess(len(done.stderr), 2500)
            self.assertFalse([c for c in done.stderr if ord(c) < 32 and c != "\n"], done.stderr)

    def test_names_of_many_parts_do_not_crash(self):
        deep = ".".join(["a"] * 100000)
        for text in (SHIP + deep + " = 1\n", f"[{deep}]\n" + SHIP,
                     SHIP + ".".join(['"a/"', "'='"] * 50000) + " = 1\n",
                     SHIP + f"x = {{ {deep} = 1 }}\n", SHIP + "x = " + "[" * 100000):
            self.refused(["hydrostatics", self.path("s.toml", text)], "s.toml")
        dots = "." * 1000  # in a text and in a comment they are no parts of a name
        text = SHIP.replace("[mass]", f"# {dots}\n[mass]") + f'x = "{dots}"\n'
        self.refused(["hydrostatics", self.path("s.toml", text)], "unknown key")


class Foreign(Files):
    """Plain BEMIO files with one thing wrong, as other writers leave them.

    Heave of the frigate at 0.6 rad/s in head seas, all other modes held: 0.484 m/m by the frequency
    domain of the file itself.
    """

    HYDRO = "body1/hydro_coeffs/"
    BODY = "[body]\ngyradii = [5.82, 28.8, 28.8]\nsize = [124.0, 14.8, 9.0]\n"

    def setUp(self):
        super().setUp()
        import h5py  # pylint: disable=import-outside-toplevel
        self.h5py = h5py

    def plain(self, change=None):
        path = self.path("plain.h5")
        with self.h5py.File(DATABASE, "r") as own, self.h5py.File(path, "w") as file:
            for name in own:
                if name != "cutwater":
                    own.copy(name, file)
            if change:
                change(file)
        return path

    def put(self, file, name, values):
        del file[name]
        file.create_dataset(name, data=values)

    def run_file(self, body=BODY, waves="omega = [0.6]"):
        text = RUN.replace(DATABASE, "plain.h5").replace("omega = 0.8", waves)
        return self.path("r.toml", text.replace("4.0", "300.0").replace("ramp = 1.0", "ramp = 30.0")
                         + "[motion]\nrestrain = [1, 2, 4, 5, 6]\n" + body)

    def heave(self, run):
        done = call("sweep", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        row = list(csv.DictReader(io.StringIO(done.stdout)))[2]
        # Bullet on the frequency domain within 0.1 % (60 ticks a wave, fitted over 14 waves).
        self.assertAlmostEqual(float(row["time_amplitude"]) / float(row["freq_amplitude"]), 1,
                               delta=1e-3)
        self.assertAlmostEqual(float(row["freq_amplitude"]), 0.484, delta=0.002)
        return done.stderr

    def test_a_sound_file_sails_with_a_body_or_a_hull(self):
        self.plain()
        self.heave(self.run_file())
        ship = self.path("s.toml", SHIP + "gyradii = [5.82, 28.8, 28.8]\n")
        run = self.run_file(body="")
        with open(run, encoding="utf-8") as file:
            text = f'ship = "{ship}"\n' + file.read()
        self.heave(self.path("h.toml", text))
        fixed = 'mean = "fixed"\n'
        self.assertEqual(call("simulate", self.run_file(fixed + self.BODY, "omega = 0.6")
                              ).returncode, 0)
        # Its wave forces are for a few headings, and a free ship may come to any.
        self.refused(["simulate", self.run_file(waves="omega = 0.6")], "r.toml: ", "gap of 90 deg",
                     'mean = "fixed"')
        self.assertIn("diffraction forces are those at rest",
                      call("simulate", self.run_file(waves="omega = 0.6")).stderr)
        self.refused(["simulate", self.run_file("", "omega = 0.6")], "r.toml: ", "plain.h5",
                     "[body] gyradii", "size")
        both = self.path("both.toml", text + self.BODY)
        self.refused(["sweep", both], "both.toml: [body]", "one of the two")
        other = self.path("s.toml", SHIP.replace("1.29]", "2.29]"))
        self.assertTrue(other)
        self.refused(["sweep", self.path("h.toml", text)], "s.toml: [mass] cog: 2.29", "1.29")
        self.refused(["sweep", self.run_file(self.BODY.replace("9.0", "2.0"))], "[body] size")
        self.refused(["sweep", self.run_file(self.BODY.replace("5.82", "-1"))], "[body] gyradii")
        own = self.path("own.toml", RUN + self.BODY)
        self.refused(["simulate", own], "own.toml: [body]", "of its own")

    def test_a_limit_of_zero_is_taken_from_a_and_b(self):
        def change(file):
            self.put(file, self.HYDRO + "added_mass/inf_freq", [[0.0] * 6] * 6)
        self.plain(change)
        said = self.heave(self.run_file())
        self.assertIn("added_mass/inf_freq is 0: A(inf) is taken from", said)

    def test_a_wrong_limit_is_refused(self):
        def change(file):
            name = self.HYDRO + "added_mass/inf_freq"
            self.put(file, name, 3 * file[name][()])
        self.plain(change)
        self.refused(["sweep", self.run_file()], "plain.h5", "added_mass/inf_freq", "A_",
                     "(inf) = ")

    def test_negative_damping_is_refused_in_time_and_warned_of_elsewhere(self):
        def change(file):
            name = self.HYDRO + "radiation_damping/all"
            values = file[name][()]
            values[2, 2, 10:14] *= -1
            self.put(file, name, values)
        database = self.plain(change)
        words = ("plain.h5", "radiation_damping/all", "B_33 < 0", "1.1, 1.2, 1.3, 1.4 rad/s")
        self.refused(["sweep", self.run_file()], *words)
        self.refused(["simulate", self.run_file(waves="omega = 0.6")], *words)
        self.refused(["retardation", database, "--dt", "0.1", "--duration", "9"], *words)
        self.refused(["rao", database, "--heading", "180"], "plain.h5", "gyration", "--gyradii")
        done = call("rao", database, "--heading", "180", "--gyradii", "5.82,28.8,28.8")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_numbers_that_are_none_and_orders_name_their_place(self):
        def nan(file):
            for name in ("added_mass/all", "radiation_damping/all", "excitation/re"):
                values = file[self.HYDRO + name][()]
                values[:, :, 0] = math.nan
                self.put(file, self.HYDRO + name, values)

        def late(file):
            name = self.HYDRO + "radiation_damping/all"
            values = file[name][()]
            values[4, 2, 7] = math.inf
            self.put(file, name, values)

        def turned(file):
            name = "simulation_parameters/w"
            self.put(file, name, file[name][()][::-1])
        for change, words in (
                (nan, ["added_mass/all", "j = 1, k = 1", "omega = 0.1 rad/s"]),
                (late, ["radiation_damping/all", "j = 5, k = 3", "omega = 0.8 rad/s"]),
                (turned, ["simulation_parameters/w[1] = 5.9", "above the one before, 6",
                          "increase"])):
            self.refused(["rao", self.plain(change), "--heading", "180"], "plain.h5", *words)

    def every(self, count):
        def change(file):
            names = ["simulation_parameters/w"]
            file.visititems(lambda name, node: names.append(name)
                            if getattr(node, "ndim", 0) == 3 and node.shape[2] == 60 else None)
            for name in names:
                values = file[name][()]
                self.put(file, name, values[count - 1::count] if values.ndim < 3
                         else values[:, :, count - 1::count])
        return change

    def test_steps_too_coarse_for_the_ship(self):
        self.plain(self.every(2))
        done = call("sweep", self.run_file())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("steps of 0.2 rad/s are too coarse, 0.12", done.stderr)
        self.plain(self.every(5))  # there phases were 180 degrees off
        self.refused(["sweep", self.run_file(waves="omega = [0.8]")], "plain.h5", "contradict",
                     "(inf) from omega = ", "steps of 0.5 rad/s are too coarse, 0.12")


class Errors(Files):
    def test_usage_exits_two(self):
        for arguments in ([], ["nonsense"], ["solve"], ["rao", DATABASE],
                          ["sweep", "--threads", "-3", "x"], ["sweep", "--threads", "x", "x"],
                          ["rao", DATABASE, "--heading", "north"],
                          ["coefficients", DATABASE, "--form", "strip"]):
            self.assertEqual(call(*arguments).returncode, 2, arguments)

    def test_help_and_version_exit_zero(self):
        self.assertEqual(call("--version").returncode, 0)
        for name in ("new hydrostatics righting buoyancy panel solve info coefficients excitation "
                     "rao retardation simulate sweep").split():
            done = call(name, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("Example", done.stdout)

    def test_unknown_keys_are_named(self):
        for command, name, text, *words in (
                ("hydrostatics", "a.toml", SHIP + "gyradius = 3\n", "[mass] gyradius", "3"),
                ("hydrostatics", "b.toml", SHIP + "[solver]\nx = 1\n", "solver"),
                ("simulate", "c.toml", RUN + "[motion]\nspeeed = 3\n", "speeed")):
            self.refused([command, self.path(name, text)], name, *words)

    def test_bad_values_are_named(self):
        for text, words in (
            (SHIP + "gyradii = [1, 2]\n", ["gyradii", "three"]),
            (SHIP + "mass = -5\n", ["mass", "-5"]),
            (SHIP + "mass = nan\n", ["mass", "nan"]),
            (SHIP + "[water]\ndensity = \"salt\"\n", ["density", "salt", "number"]),
            (SHIP + "[solve]\nomega = [0.2, 0.1]\n", ["[solve] omega = [0.2, 0.1]: ", "increase"]),
            (SHIP + "[solve]\nomega = { from = 0.2, to = 0.1, step = 0.1 }\n", ["to = 0.1: "]),
            (SHIP + "[solve]\nomega = [0.5, 1.5]\nwave_omega = [0.5, 1.75]\n",
             ["wave_omega", "1.75", "1.5"]),
            (SHIP + "[solve]\nspeeds = [-5.0]\n", ["speeds", "-5"]),
            (SHIP + "[solve]\nsource_points = 3\n", ["source_points", "3", "auto"]),
            (SHIP + "[solve]\ngalerkin_points = \"auto\"\n", ["galerkin_points", "auto"]),
            (SHIP + "[solve]\ninfluence = \"matrix\"\n", ["influence", "matrix", "interpolated"]),
            (SHIP + "[solve]\nderivatives = \"source\"\n", ["derivatives", "formulation"]),
            (SHIP + "[solve]\nforward_speed = \"strip\"\n", ["forward_speed", "strip", "tuck"]),
            (SHIP + "[solve]\ncondition_limit_odd = [1, 2]\n", ["condition_limit_odd", "pairs"]),
            (SHIP + "[solve]\ncondition_limit_even = [[1, 9], [1, 9]]\n",
             ["condition_limit_even", "increase"]),
            (SHIP.replace("[mass]", "unit = \"mile\"\n[mass]"), ["unit", "mile"]),
            (SHIP.replace("frigate_224.obj", "missing.obj"), ["missing.obj"]),
            ("[hull\n", ["line"]),
        ):
            self.refused(["hydrostatics", self.path("s.toml", text)], *words)
        for text, words in (
            (RUN.replace("0.8", "-0.8"), ["omega", "-0.8"]),
            (RUN.replace("regular", "tsunami"), ["type", "tsunami"]),
            (RUN.replace("duration = 4.0", "dt = 0"), ["dt", "0"]),
            (RUN.replace("database", "data"), ["database", "missing"]),
            (RUN.replace("0.8", "9.0"), ["omega = 9 rad/s"]),
            (RUN.replace("0.8", "9.0") + "[motion]\nmean = \"fixed\"\n", ["omega = 9 rad/s"]),
            (RUN + "[motion]\nmean = \"filtered\"\n",
             ["r.toml: [motion] mean", "filtered", "free", "fixed"]),
            (RUN + "[motion]\nfollow_time = 15.0\n", ["r.toml: [motion] follow_time", "no more"]),
            (RUN + "[motion]\nmean = \"loose\"\n", ["r.toml: [motion] mean", "loose"]),
            (RUN + "[motion]\nresistance = 0.1\n", ["r.toml: [motion] resistance", "0.1"]),
            (RUN + "[motion]\nhull_lift = \"on\"\n", ["r.toml: [motion] hull_lift", "on"]),
        ):
            self.refused(["simulate", self.path("r.toml", text)], *words)

    def test_default_frequencies_follow_from_the_length(self):
        """Waves are multiples of 0.18 sqrt(g/L), those within omega; without omega 60 of 0.36."""
        ship = self.path("s.toml", SHIP)
        found = {row["name"]: float(row["value"]) for row in table("hydrostatics", ship)}
        unit = math.sqrt(9.80665 / found["length"])
        for omega, expected in (("[0.5, 0.75, 1.0]", (10, 0.18 * 10 * unit, 0.18 * 19 * unit)),
                                ("[3.0, 4.0]", (2, 3.0, 4.0))):
            ship = self.path("s.toml", SHIP + f"[solve]\nomega = {omega}\nlid = false\n")
            database = self.path("s.h5")
            done = call("solve", ship, "-o", database)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = table("excitation", database, "--heading", "180")
            waves = sorted({float(row["omega"]) for row in rows})
            self.assertEqual(len(waves), expected[0])
            self.assertAlmostEqual(waves[0], expected[1], delta=1e-6)
            self.assertAlmostEqual(waves[-1], expected[2], delta=1e-6)
        ship = self.path("s.toml", SHIP)
        done = call("solve", ship, "-o", self.path("s.h5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        told = {row["name"]: row["value"] for row in table("info", self.path("s.h5"))}
        self.assertEqual(float(told["frequencies"]), 60)
        self.assertAlmostEqual(float(told["omega_first"]), 0.36 * unit, delta=1e-6)
        self.assertAlmostEqual(float(told["omega_last"]), 60 * 0.36 * unit, delta=1e-6)
        self.assertTrue(told["verdict"].startswith("good for the frequency and the time domain"))

    def test_missing_and_damaged_files_are_named(self):
        self.refused(["info", self.path("none.h5")], "none.h5")
        with open(DATABASE, "rb") as file:
            content = bytearray(file.read())
        content[len(content) // 2] ^= 4
        damaged = self.path("damaged.h5")
        with open(damaged, "wb") as file:
            file.write(content)
        self.refused(["info", damaged], "damaged.h5")
        self.refused(["info", self.path("text.h5", "hello")], "text.h5")

    def test_nothing_is_left_behind_where_one_may_not_write(self):
        self.refused(["rao", DATABASE, "--heading", "0", "-o", self.path("no/such/folder.csv")],
                     "folder.csv")
        ship = self.path("s.toml", SHIP)
        self.refused(["solve", ship, "-o", self.path("no/such.h5")], "such.h5")
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["s.toml"])

    def test_bad_ranges_are_named(self):
        for bad in ("1", "1:2", "a:b:c", "2:1:5", "0:1:5", "0.1:1:0", "0.1:1:2.5"):
            self.refused(["rao", DATABASE, "--heading", "0", "--omega", bad], "--omega", bad,
                         code=2)
        self.refused(["rao", DATABASE, "--heading", "0", "--speed", "-300"], "speed", "-300",
                     code=2)
        self.refused(["rao", DATABASE, "--heading", "0", "--speed", "-3", "--form", "report"],
                     "speed -3", "tuck", code=2)
        self.refused(["rao", DATABASE, "--heading", "800"], "--heading 800", code=2)
        self.refused(["coefficients", DATABASE, "--speed", "nan"], "speed", "nan", code=2)
        self.refused(["retardation", DATABASE, "--dt", "2", "--duration", "1"], "--dt 2", code=2)
        # Well formed; that the database ends below is no fault of the line.
        self.refused(["rao", DATABASE, "--heading", "0", "--omega", "5:9:2"], "9")


unittest.main(argv=sys.argv[:1])
