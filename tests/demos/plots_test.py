"""plots_test.py COMMAND ROOT: gnuplot draws plot_righting.gp and plot_steep.gp without a word."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

COMMAND, ROOT = (os.path.abspath(argument) for argument in sys.argv[1:3])
STEEP = ("froude,surge_free,omega_scaled,lambda_over_length,steepness,heave_nonlinear,"
         "pitch_nonlinear,heave_linear,pitch_linear,heave_frequency,pitch_frequency,"
         "mean_surge_force\n")


@unittest.skipIf(shutil.which("gnuplot") is None, "no gnuplot here")
class Plots(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def draw(self, script, **files):
        settings = "; ".join(f"{name}='{path}'" for name, path in files.items())
        done = subprocess.run(["gnuplot", "-e", settings, f"{ROOT}/demos/{script}"],
                              capture_output=True, text=True, check=False, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertGreater(os.path.getsize(os.path.join(self.folder, files["out"])), 5000)

    def test_righting_levers_of_frigate_and_boat(self):
        for ship in ("frigate", "boat"):
            subprocess.run([COMMAND, "righting", f"{ROOT}/meshes/{ship}/ship.toml", "--heel",
                            "0:180:19", "-o", f"{ship}.csv"], check=True, cwd=self.folder,
                           capture_output=True)
        self.draw("plot_righting.gp", frigate="frigate.csv", boat="boat.csv", out="righting.png")

    def test_head_seas(self):
        with open(os.path.join(self.folder, "steep.csv"), "w", encoding="utf-8") as file:
            file.write(STEEP)
            for froude in (0.12, 0.2):
                for free in (0, 1):
                    for omega in (1.5, 3.5):
                        for one in (300, 30, 20, 15):
                            values = [froude, free, omega, 1.0, 1.0 / one] + 7 * [1.0 / omega]
                            file.write(",".join(f"{value:.9g}" for value in values) + "\n")
        self.draw("plot_steep.gp", **{"in": "steep.csv"}, out="steep.png")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
