"""any_hull_test.py CUTWATER: panels on hulls of every kind, checked by readers and sums of our own.

Each shape of hull_shapes.py is written as a file, `cutwater panel` divides it into 433 panels a
side, and the file of panels is judged alone (panel_checks.py): closed below water, facing it, no
slivers, the volume by x, y and z, and this volume against the true one. With CUTWATER_FULL all
shapes are tried, and with 1040 panels as well.
"""
import re
import sys
import unittest

from command import InFolder, call
from hull_shapes import shapes
from panel_checks import Panels
from results import FULL, record

# The acceptance lines: what panels of this number may differ from the true volume.
BOUNDS = {433: 0.01, 1040: 0.005}
# Panels a side that are laid where `count` are asked for: less by a fifth where the surface leaves
# no choice; more by a fifth, and by half where stderr says so.
FEWEST, MOST, MOST_SAID = 0.8, 1.2, 1.5
LINES_AT_MOST = 5  # on stderr, beside the one that sums up what was written


def numbers_of_m3(text):
    return [float(number) for number in re.findall(r"([-+.\de]+) m3", text)]


def slenderest(shape, panels):
    """The worst panel allowed: 20 times as long as wide, as a triangle of a tenth of the usual
    area is. Along a part thinner than a panel, panels are as wide as the part and twice as long as
    the rest."""
    length = (panels.areas().sum() / len(panels.faces)) ** 0.5
    return 20.0 + (4.0 * length / shape.thinnest if shape.thinnest else 0.0)


def wrong_volume(shape, panels, count, done):
    """A line for a volume that is wrong, or lacks a part without a word."""
    volume = panels.volumes()[2]
    error = volume / shape.volume - 1
    if abs(error) > BOUNDS[count] and shape.without and "left out" in done.stderr:
        error = volume / shape.without - 1
    lines = [] if abs(error) <= BOUNDS[count] else [
        f"volume {volume:.6g} instead of {shape.volume:.6g} m3 ({100 * error:+.2f} %)"]
    # What is printed is what is in the file: twisted quadrilaterals may be split along the other
    # diagonal there, a few 1e-4 of V.
    if not any(abs(said / volume - 1) < 1e-3 for said in numbers_of_m3(done.stdout + done.stderr)):
        lines.append(f"the volume of the panels, {volume:.6g} m3, is not printed")
    return lines


def wrong_words(shape, panels, count, done):
    lines = []
    each = len(panels.faces) / count / 2
    most = MOST_SAID if re.search(r"\d panels", done.stderr) else MOST
    if not FEWEST <= each <= most:
        lines.append(f"{len(panels.faces)} panels on both sides, asked for {count} a side")
    if not re.search(shape.said, done.stderr):
        lines.append(f"nothing said of '{shape.said}': {done.stderr}")
    said = [line for line in done.stderr.splitlines() if "panels.obj: " not in line]
    if len(said) > LINES_AT_MOST:
        lines.append("\n  ".join([f"{len(said)} lines said:", *said]))
    return lines


class AnyHull(InFolder):
    """One test for each number of panels; a shape that fails does not stop the others."""

    def wrong(self, shape, count):
        mesh, out = self.path(f"{shape.name}.obj"), self.path("panels.obj")
        shape.mesh.write(mesh)
        done = call("panel", mesh, "-n", str(count), "-o", out, *shape.options)
        if done.returncode != 0:
            return [f"refused ({done.returncode}): {done.stderr}"]
        panels = Panels(out)
        lines = panels.faults(slenderest(shape, panels)) + wrong_volume(shape, panels, count, done)
        if panels.mirrored() != shape.symmetric:
            lines.append(f"symmetric: {not shape.symmetric}")
        self.worst = max(self.worst, abs(panels.volumes()[2] / shape.volume - 1))
        return lines + wrong_words(shape, panels, count, done)

    def try_all(self, count):
        self.worst = 0.0
        chosen = [shape for shape in shapes() if FULL or shape.quick]
        for shape in chosen:
            with self.subTest(shape=shape.name, panels=count):
                wrong = self.wrong(shape, count)
                if wrong:
                    self.fail("\n".join([shape.name, *wrong]))
        record("Any hull", f"volume of {len(chosen)} shapes, {count} panels a side, worst error",
               "closed forms, lines through the solids", self.worst, f"< {BOUNDS[count]}")

    def test_every_shape_gets_433_panels_of_its_volume(self):
        self.try_all(433)

    @unittest.skipUnless(FULL, "the full size")
    def test_every_shape_gets_1040_panels_of_its_volume(self):
        self.try_all(1040)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
