"""What every set of panels must be, found from the OBJ file alone.

Panels cover the wet part of a closed surface: all their edges are shared by two panels, but for
those at z = 0. They face the water. The volume under them, by x, by y and by z,

    V = ∫ x n_x dS = ∫ y n_y dS = ∫ z n_z dS,

is three times the same where the surface is closed, as the lid at z = 0 adds nothing to any.
"""
import numpy as np

from hull_mesh import read_obj


class Panels:
    """The panels of a file, with triangles for those of three corners or of two that coincide."""

    def __init__(self, path):
        self.points, faces = read_obj(path)
        self.size = np.ptp(self.points, axis=0).max()
        # Ten digits are written; corners that agree to 1e-8 of the hull's length are one.
        keys = {}
        same = [keys.setdefault(tuple(key), i) for i, key in
                enumerate(np.round(self.points / (1e-8 * self.size)).astype(np.int64).tolist())]
        welded = [list(dict.fromkeys(same[i] for i in face)) for face in faces]
        self.faces = [face for face in welded if len(face) > 2]
        self.triangles = self.points[np.array(
            [(face[0], face[i], face[i + 1]) for face in self.faces
             for i in range(1, len(face) - 1)])]
        self.owner = np.array([k for k, face in enumerate(self.faces)
                               for _ in range(len(face) - 2)])

    def volumes(self, triangles=None):
        """By x, by y and by z, positive where panels face outwards."""
        t = self.triangles if triangles is None else triangles
        normals = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]) / 2
        return (t.mean(1) * normals).sum(0)

    def edges(self):
        """{(i, j) with i < j: [uses from i to j, uses from j to i]}"""
        uses = {}
        for face in self.faces:
            for i, j in zip(face, face[1:] + face[:1]):
                uses.setdefault((min(i, j), max(i, j)), [0, 0])[i > j] += 1
        return uses

    def open_edges(self):
        """Edges below water that are not used once each way."""
        dry = 1e-7 * self.size
        return [edge for edge, uses in self.edges().items() if uses != [1, 1]
                and not (sum(uses) == 1 and (self.points[list(edge), 2] > -dry).all())]

    def pieces(self):
        """The triangles of each connected piece."""
        parent = list(range(len(self.points)))

        def root(i):
            while parent[i] != i:
                parent[i] = parent[parent[i]]
                i = parent[i]
            return i

        for face in self.faces:
            for i in face[1:]:
                parent[root(i)] = root(face[0])
        roots = np.array([root(self.faces[k][0]) for k in self.owner])
        return [self.triangles[roots == r] for r in np.unique(roots)]

    def areas(self):
        t = self.triangles
        each = np.linalg.norm(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]), axis=1) / 2
        return np.bincount(self.owner, each, len(self.faces))

    def slenderness(self):
        """Longest edge squared over area of each panel: the length over the width of a rectangle,
        2.3 for an equilateral triangle."""
        longest = np.array([max(((self.points[i] - self.points[j]) ** 2).sum()
                                for i, j in zip(face, face[1:] + face[:1])) for face in self.faces])
        return longest / np.maximum(self.areas(), 1e-300)

    def mirrored(self):
        """Whether each corner has its image beyond y = 0, to a hundred thousandth of the length."""
        unit = 1e-5 * self.size
        places = self.points / unit
        have = {tuple(key) for key in np.floor(places).astype(np.int64).tolist()}
        near = [(a, b, c) for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)]
        images = np.floor(places * [1, -1, 1]).astype(np.int64).tolist()
        return all(any((x + a, y + b, z + c) in have for a, b, c in near) for x, y, z in images)

    def faults(self, slenderest):
        """What is wrong with these panels, one line each."""
        found = []
        edges = self.open_edges()
        if edges:
            place = self.points[edges[0][0]]
            found.append(f"{len(edges)} edges below water are not shared by two panels, the first "
                         f"at {np.round(place, 4)}")
        if self.points[:, 2].max() > 1e-7 * self.size:
            found.append(f"panels reach above water, to {self.points[:, 2].max():.4g}")
        volumes = self.volumes()
        # Ten digits of each coordinate: 1e-9 of a volume, and the parts cancel to a hundredth.
        if np.ptp(volumes) > 1e-6 * abs(volumes).max():
            found.append(f"volumes by x, y and z differ: {volumes}")
        inward = sum(self.volumes(piece)[2] <= 0 for piece in self.pieces())
        if inward:
            found.append(f"{inward} pieces face inwards")
        worst = self.slenderness()
        if worst.max() > slenderest:
            at = self.points[self.faces[int(worst.argmax())][0]]
            found.append(f"{(worst > slenderest).sum()} slivers, the worst of {worst.max():.3g}, "
                         f"above {slenderest:.3g}, at {np.round(at, 4)}")
        return found
