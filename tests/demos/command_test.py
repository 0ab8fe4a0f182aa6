"""command_test.py COMMAND DATABASE MESHES: the contract that others script against.

Columns, conventions, exit codes.
"""
import csv
import io
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

COMMAND, DATABASE, MESHES = (os.path.abspath(a) if os.path.exists(a) else a for a in sys.argv[1:4])


def call(*arguments):
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)


def table(*arguments):
    done = call(*arguments)
    assert done.returncode == 0, done.stderr
    return list(csv.DictReader(io.StringIO(done.stdout)))


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


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        full = os.path.join(self.folder.name, name)
        if text is not None:
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)
        return full

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

    def test_simulate_columns_and_start(self):
        run = self.path("run.toml", RUN)
        rows = table("simulate", run, "--forces")
        expected = "t x y z roll_deg pitch_deg yaw_deg u v w p q r wave".split()
        for part in ("gravity restoring froude_krylov diffraction radiation added_mass "
                     "supplementary autopilots").split():
            expected += [f"{part}_F{i}" for i in range(1, 7)]
        self.assertEqual(list(rows[0]), expected)
        self.assertEqual(len(rows), 201)
        self.assertAlmostEqual(float(rows[0]["z"]), 1.29, delta=1e-9)
        self.assertAlmostEqual(float(rows[-1]["t"]), 4.0, delta=1e-9)
        # The ship is near the origin.
        self.assertAlmostEqual(float(rows[-1]["wave"]), math.cos(0.8 * 4.0), delta=0.01)

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

    def test_reports_form_where_the_database_has_it(self):
        names = {row["name"]: row["value"] for row in table("info", DATABASE)}
        self.assertEqual(names["forward_speed"], "report")
        if names["adjoint_vectors_dx"] == "1":
            rows = table("rao", DATABASE, "--speed", "8", "--heading", "180", "--omega",
                         "0.2:0.3:2")
            self.assertAlmostEqual(float(rows[2]["amplitude"]), 1, delta=0.1)
        else:
            self.refused(["rao", DATABASE, "--speed", "8", "--heading", "180"], "frigate.h5",
                         "speed = 8")

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


def read(path):
    with open(path, encoding="utf-8") as file:
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


class Errors(Files):
    def test_usage_exits_two(self):
        for arguments in ([], ["nonsense"], ["solve"], ["rao", DATABASE],
                          ["sweep", "--threads", "-3", "x"], ["sweep", "--threads", "x", "x"],
                          ["rao", DATABASE, "--heading", "north"],
                          ["coefficients", DATABASE, "--form", "strip"]):
            self.assertEqual(call(*arguments).returncode, 2, arguments)

    def test_help_and_version_exit_zero(self):
        self.assertEqual(call("--version").returncode, 0)
        for name in ("hydrostatics panel solve info coefficients excitation rao retardation "
                     "simulate sweep").split():
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
            (SHIP + "[solve]\nomega = { from = 0.2, to = 0.1, step = 0.1 }\n", ["step = 0.1: "]),
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
        ):
            self.refused(["simulate", self.path("r.toml", text)], *words)

    def test_default_wave_frequencies_stay_within_omega(self):
        for omega, expected in (("[0.5, 0.75, 1.0]", (11, 0.5, 1.0)),
                                ("[3.0, 4.0]", (2, 3.0, 4.0))):
            ship = self.path("s.toml", SHIP + f"[solve]\nomega = {omega}\nlid = false\n")
            database = self.path("s.h5")
            done = call("solve", ship, "-o", database)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = table("excitation", database, "--heading", "180")
            waves = sorted({float(row["omega"]) for row in rows})
            self.assertEqual(len(waves), expected[0])
            self.assertAlmostEqual(waves[0], expected[1])
            self.assertAlmostEqual(waves[-1], expected[2])

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
        self.refused(["rao", DATABASE, "--heading", "0", "--speed", "-3"], "speed", "-3", code=2)
        self.refused(["rao", DATABASE, "--heading", "800"], "--heading 800", code=2)
        self.refused(["coefficients", DATABASE, "--speed", "nan"], "speed", "nan", code=2)
        self.refused(["retardation", DATABASE, "--dt", "2", "--duration", "1"], "--dt 2", code=2)
        # Well formed; that the database ends below is no fault of the line.
        self.refused(["rao", DATABASE, "--heading", "0", "--omega", "5:9:2"], "9")


unittest.main(argv=sys.argv[:1])
