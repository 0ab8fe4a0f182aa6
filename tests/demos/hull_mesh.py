"""Meshes of solids, made of boxes, bodies of revolution, lofts and tubes; OBJ files of them.

Axes as the command's: x forward, y to port, z up from calm water, metres. Every solid is closed and
its faces are counter-clockwise seen from the water, so that one rule gives the volume of a union of
solids that overlap (hull_volume.py).
"""
import math

import numpy as np


class Mesh:
    """`points` are (x, y, z), `faces` lists of their indices from 0."""

    def __init__(self):
        self.points = []
        self.faces = []

    def add(self, points, faces):
        first = len(self.points)
        self.points += [tuple(point) for point in points]
        self.faces += [[first + i for i in face] for face in faces]
        return self

    def join(self, other):
        return self.add(other.points, other.faces)

    def box(self, x, y, z):
        """Between two limits along each axis."""
        corners = [(a, b, c) for a in x for b in y for c in z]
        return self.add(corners, [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6],
                                  [0, 2, 6, 4], [1, 5, 7, 3]])

    def prism(self, outline, low, high):
        """`outline` (x, y), counter-clockwise from above, between two heights."""
        n = len(outline)
        points = [(x, y, z) for z in (low, high) for x, y in outline]
        sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
        return self.add(points, [list(range(n))[::-1], list(range(n, 2 * n))] + sides)

    def revolve(self, profile, sides, centre=(0.0, 0.0), loop=False):
        """`profile` (r, z) from the lower end on the axis to the upper one, or with `loop` a closed
        curve, counter-clockwise in (r, z), which makes a ring."""
        points, rings = [], []
        for r, z in profile:
            corners = 1 if r == 0 else sides
            rings.append([len(points) + (i if corners > 1 else 0) for i in range(sides)])
            for i in range(corners):
                angle = 2 * math.pi * i / sides
                points.append((centre[0] + r * math.cos(angle), centre[1] + r * math.sin(angle), z))
        faces = []
        for low, high in zip(rings, rings[1:] + rings[:1] if loop else rings[1:]):
            for i in range(sides):
                j = (i + 1) % sides
                face = list(dict.fromkeys([low[i], low[j], high[j], high[i]]))
                faces += [face] if len(face) > 2 else []
        return self.add(points, faces)

    def loft(self, rows, ends=True, top=True):
        """Open rows of equally many points, from aft to fore, each from starboard round the keel to
        port; `ends` closes the first and the last row, `top` what lies between the rows' ends.
        Split from their first points, quadrilaterals to port are images of those to starboard."""
        n, m = len(rows[0]), len(rows)
        faces = [[a * n + i, (a + 1) * n + i, (a + 1) * n + i + 1, a * n + i + 1]
                 for a in range(m - 1) for i in range(n - 1)]
        faces = [face[1:] + face[:1] if 2 * (face[0] % n) >= n - 1 else face for face in faces]
        if ends:
            faces += [list(range(n)), [(m - 1) * n + i for i in range(n)][::-1]]
        if top:
            faces += [[a * n, a * n + n - 1, (a + 1) * n + n - 1, (a + 1) * n]
                      for a in range(m - 1)]
        return self.add([point for row in rows for point in row], [face[::-1] for face in faces])

    def tube(self, start, end, radius, sides):
        """A cylinder between two points, closed at both ends."""
        start, end = np.array(start, float), np.array(end, float)
        along = (end - start) / np.linalg.norm(end - start)
        first = np.cross(along, [0.0, 0.0, 1.0] if abs(along[2]) < 0.9 else [0.0, 1.0, 0.0])
        first /= np.linalg.norm(first)
        second = np.cross(along, first)
        turns = [2 * math.pi * i / sides for i in range(sides)]
        points = [base + radius * (math.cos(a) * first + math.sin(a) * second)
                  for base in (start, end) for a in turns]
        faces = [[i, (i + 1) % sides, sides + (i + 1) % sides, sides + i] for i in range(sides)]
        return self.add(points, faces + [list(range(sides))[::-1],
                                         list(range(sides, 2 * sides))])

    def moved(self, matrix=None, shift=(0.0, 0.0, 0.0)):
        points = np.array(self.points) @ (np.eye(3) if matrix is None else np.array(matrix)).T
        return Mesh().add((points + shift).tolist(), self.faces)

    def mirrored(self):
        """The image beyond y = 0."""
        return Mesh().add([(x, -y, z) for x, y, z in self.points],
                          [face[:1] + face[:0:-1] for face in self.faces])

    def triangles(self):
        """All faces split from their first point, as an array (triangles, corners, axes)."""
        split = [(face[0], face[i], face[i + 1])
                 for face in self.faces for i in range(1, len(face) - 1)]
        return np.array(self.points)[np.array(split)]

    def write(self, path):
        write_obj(path, self.points, self.faces)


def turned(heel_deg, trim_deg):
    """The matrix of a heel to starboard and, after it, a trim by the bow."""
    heel, trim = math.radians(heel_deg), math.radians(trim_deg)
    c, s = math.cos(heel), math.sin(heel)
    roll = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    c, s = math.cos(trim), math.sin(trim)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) @ roll


def write_obj(path, points, faces):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines("v %.10g %.10g %.10g\n" % tuple(point) for point in points)
        file.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def read_obj(path):
    """(points as an array, faces) of an OBJ file of nothing but these."""
    points, faces = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            word, *rest = line.split() or [""]
            if word == "v":
                points.append([float(number) for number in rest])
            elif word == "f":
                faces.append([int(corner.split("/")[0]) - 1 for corner in rest])
    return np.array(points), faces
