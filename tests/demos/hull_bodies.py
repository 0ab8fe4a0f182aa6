"""Random bodies: a ship with parts put through it, solids of known volume, and spoiled meshes.

`body(seed)` is the same for the same seed. The length is 1 until the body is scaled.
"""
import math
from dataclasses import dataclass

import numpy as np

from hull_mesh import Mesh, turned
from hull_volume import union_volume, upright_breaks

PARTS = ("skeg", "strakes", "bilge keels", "rudder", "tunnel", "stepped boxes", "inner skin",
         "bulb")
SPOILS = ("windings", "doubles", "holes", "slivers", "unwelded", "T-junctions")


@dataclass
class Body:
    """`mesh` as written, spoiled, in metres, z = 0 calm water; `volume` [m³] before it was spoiled,
    by lines, and the difference of their two grids as a share of it."""

    mesh: Mesh
    volume: float
    error: float
    what: str


class Ship:
    """Rows of a ship of length 1, from the transom or stern to the stem."""

    def __init__(self, random):
        self.random = random
        self.breadth = 1 / random.uniform(2.5, 9)
        self.draught = self.breadth / random.uniform(1.8, 5)
        self.deck = self.draught * random.uniform(0.5, 1.2)
        self.chine = random.random() < 0.4
        self.deadrise = math.radians(random.uniform(3, 25))
        self.power = random.uniform(1.5, 3.5)
        self.transom = random.uniform(0.4, 1.0) if random.random() < 0.6 else 0.0
        self.stations = int(random.choice([12, 24, 48]))
        self.girth = int(random.choice([4, 8, 14]))

    def half(self, x):
        """Half the breadth at a station."""
        fore, aft = max(0.0, (x - 0.1) / 0.4), max(0.0, (-0.1 - x) / 0.4)
        return self.breadth / 2 * (1 - fore ** self.power) * (1 - (1 - self.transom) * aft ** 2)

    def section(self, half):
        """(y, z) from the keel to the port edge of the deck."""
        depth = self.draught + self.deck
        if self.chine:
            rise = min(0.6 * depth, half * 0.95 * math.tan(self.deadrise))
            corners = [(0, 0), (0.95 * half, rise), (half, depth)]
            lower = self.girth // 2
            marks = [(0, i / lower) for i in range(lower)] + [
                (1, i / (self.girth - lower)) for i in range(self.girth - lower)] + [(1, 1.0)]
            return [tuple((1 - t) * a + t * b for a, b in zip(corners[k], corners[k + 1]))
                    for k, t in marks]
        turns = [math.pi / 2 * i / self.girth for i in range(self.girth + 1)]
        return [(half * math.sin(a) ** 0.7, depth * (1 - math.cos(a)) ** 1.4) for a in turns]

    def rows(self, inwards=0.0):
        """The outer skin, or one inside it by `inwards` times the breadth; both end at the deck."""
        wall, found = inwards * self.breadth, []
        for a in range(self.stations + 1):
            x = a / self.stations - 0.5
            half = max(0.0, self.half(x) - wall)
            port = [(y, -self.draught + wall + z * (1 - wall / (self.draught + self.deck)))
                    for y, z in self.section(half)]
            found.append([(x * (1 - 2 * wall), -y, z) for y, z in port[:0:-1]]
                         + [(x * (1 - 2 * wall), y, z) for y, z in port])
        return found

    def side(self, z):
        """Half the breadth amidships at a height."""
        y, heights = zip(*self.section(self.breadth / 2))
        return float(np.interp(z + self.draught, heights, y))


def both_sides(mesh, part):
    mesh.join(part).join(part.mirrored())


def add_part(ship, name, mesh):
    """Puts a closed part through the hull; a part of the union of solids."""
    pick, b, t = ship.random.uniform, ship.breadth, ship.draught
    thick = pick(0.004, 0.02)
    if name == "skeg":
        mesh.box((-0.4, pick(-0.2, 0.1)), (-thick / 2, thick / 2), (-t * pick(1.1, 1.4), -0.6 * t))
    elif name == "strakes":
        z = -t * pick(0.15, 0.5)
        y = ship.side(z)
        both_sides(mesh, Mesh().box((-0.3, 0.1), (y - 0.1 * b, y + pick(0.02, 0.06) * b),
                                    (z - thick, z)))
    elif name == "bilge keels":
        keel = Mesh().box((-0.2, 0.15), (0, pick(0.05, 0.12) * b), (-thick / 4, thick / 4))
        z = -0.8 * t
        keel = keel.moved(turned(-45, 0), (0, ship.side(z) - 0.03 * b, z))
        both_sides(mesh, keel)
    elif name == "rudder":
        mesh.box((-0.49, -0.46), (-thick / 2, thick / 2), (-t, -0.3 * t))
    elif name == "stepped boxes":
        for k in range(3):
            y = b / 2 * pick(0.7, 1.0)
            mesh.box((0.1 * k - 0.3, 0.1 * k - 0.2), (-y, y),
                     (-t * pick(0.8, 1.1), 0.5 * ship.deck))
    elif name == "bulb":
        r = pick(0.1, 0.2) * b
        profile = [(r * math.sin(a), 3 * r * math.cos(a)) for a in np.linspace(math.pi, 0, 11)]
        profile[0], profile[-1] = (0, -3 * r), (0, 3 * r)
        bulb = Mesh().revolve(profile, 12)
        mesh.join(bulb.moved([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], (0.48, 0, -0.7 * t)))


def open_pipe(ship):
    """A bow thruster's tunnel as games draw it: a pipe without ends from side to side, the hull not
    cut out. It ends inside the skin, and so has no volume."""
    pipe = Mesh().tube((0.2, -0.5 * ship.half(0.2), -0.5 * ship.draught),
                       (0.2, 0.5 * ship.half(0.2), -0.5 * ship.draught), 0.15 * ship.draught, 12)
    pipe.faces = pipe.faces[:-2]
    return pipe


def spoil(triangles, names, random):
    """The same surface as a worse mesh: an array of triangles of length 1."""
    pieces = [triangles]
    def some(share):
        return random.random(len(pieces[0])) < share
    if "T-junctions" in names:
        chosen = some(0.05)
        t, middle = pieces[0][chosen], pieces[0][chosen][:, :2].mean(1)
        pieces[0] = np.concatenate([pieces[0][~chosen], np.stack([t[:, 0], middle, t[:, 2]], 1),
                                    np.stack([middle, t[:, 1], t[:, 2]], 1)])
    if "slivers" in names:
        chosen = some(0.03)
        t = pieces[0][chosen]
        inner = 0.4999 * t[:, 0] + 0.4999 * t[:, 1] + 2e-4 * t[:, 2]
        pieces[0] = np.concatenate([pieces[0][~chosen]] + [
            np.stack([t[:, k], t[:, (k + 1) % 3], inner], 1) for k in range(3)])
    if "holes" in names:
        pieces[0] = with_holes(pieces[0], random)
    if "doubles" in names:
        pieces[0] = np.concatenate([pieces[0], pieces[0][some(0.1)]])
    if "windings" in names:
        chosen = some(0.3)
        pieces[0][chosen] = pieces[0][chosen][:, ::-1]
    if "unwelded" in names:
        pieces[0] = pieces[0] + random.uniform(-1e-6, 1e-6, pieces[0].shape)
    return pieces[0]


def with_holes(triangles, random):
    """Triangular holes, each at most a hundredth of the length wide, in up to three triangles."""
    kept = np.ones(len(triangles), bool)
    kept[random.choice(len(triangles), random.integers(1, 4), replace=False)] = False
    frames = [triangles[kept]]
    for t in triangles[~kept]:
        longest = max(np.linalg.norm(t - np.roll(t, 1, 0), axis=1))
        share = min(0.8, random.uniform(0.002, 0.01) / max(longest, 1e-9))
        hole = t.mean(0) + share * (t - t.mean(0))
        for k in range(3):
            j = (k + 1) % 3
            frames.append(np.array([[t[k], t[j], hole[j]], [t[k], hole[j], hole[k]]]))
    return np.concatenate(frames)


def pose(ship, random):
    """(matrix, height) that leave the deck dry: heel and trim move its edge by less than half of
    the freeboard."""
    room = 0.5 * ship.deck
    most = math.degrees(room / ship.breadth)
    heel = 0.0 if random.random() < 0.6 else most * random.uniform(-1, 1)
    trim = math.degrees(room) * random.uniform(-0.9, 0.9) if random.random() < 0.6 else 0.0
    return (turned(max(-5, min(5, heel)), max(-3, min(3, trim))),
            random.uniform(-0.2, 0.2) * ship.draught)


def body(seed):
    random = np.random.default_rng(seed)
    ship = Ship(random)
    parts = [name for name in PARTS if random.random() < 0.25]
    spoils = [name for name in SPOILS if random.random() < 0.3]
    solids = Mesh().loft(ship.rows())
    for name in parts:
        add_part(ship, name, solids)
    matrix, height = pose(ship, random)
    plane = (*matrix[2], height)
    volume, error = union_volume(solids.triangles(), plane, upright_breaks(solids))
    written = solids.triangles()
    if "inner skin" in parts:
        # Open boats: the deck, the last faces of the loft, is not there.
        loft = Mesh().loft(ship.rows(), top=False)
        rest = Mesh().add(solids.points, [face for face in solids.faces
                                          if min(face) >= len(loft.points)])
        inner = Mesh().loft(ship.rows(0.04), top=False)
        written = np.concatenate([m.triangles() for m in (loft, inner, rest) if m.faces])
    if "tunnel" in parts:
        written = np.concatenate([written, open_pipe(ship).triangles()])
    length = 10 ** random.uniform(-1, math.log10(400))
    written = (spoil(written, spoils, random) @ matrix.T + (0, 0, height)) * length
    points, index = np.unique(written.reshape(-1, 3), axis=0, return_inverse=True)
    what = f"{length:.3g} m, {len(written)} triangles: {', '.join(parts + spoils) or 'plain'}"
    return Body(Mesh().add(points.tolist(), index.reshape(-1, 3).tolist()),
                volume * length ** 3, error / volume, what)
