"""Hulls of every kind that `cutwater panel` must divide into panels, each with its true volume.

Where a shape has a formula the volume is that formula; else hull_volume.py integrates the union of
its solids. Nothing here is taken from the program.
"""
import math
from dataclasses import dataclass, field

from hull_mesh import Mesh, turned
from hull_volume import union_volume, upright_breaks


@dataclass
class Shape:
    """A mesh, the volume [m³] that its outer surface encloses below z = 0, and what is expected."""

    name: str
    mesh: Mesh
    volume: float
    symmetric: bool = True
    without: float = None       # the volume without a part that may be left out, if that is said
    thinnest: float = None      # [m] the least thickness of a part that lies along the axes
    said: str = ""              # what stderr must say, a regular expression
    options: list = field(default_factory=list)
    quick: bool = True          # also tried in the short run


def polygon(radius, sides):
    return sides / 2 * radius ** 2 * math.sin(2 * math.pi / sides)


def union(mesh):
    """By lines between the mesh's own upright faces, as many as make the error a
    thousandth: a fifth of the strictest bound on V."""
    for lines in (60000, 240000, 960000):
        volume, error = union_volume(mesh.triangles(), breaks=upright_breaks(mesh), lines=lines)
        if error < 1e-3 * volume:
            return volume
    raise ValueError(f"the grids' volumes differ by {error:.3g} of {volume:.6g} m3")


def round_bilge(length, breadth, draught, deck, stations=24, girth=8):
    """Rows of a hull with a transom aft and a stem at length / 2, round at the bilge."""
    rows = []
    for a in range(stations + 1):
        x = length * (a / stations - 0.5)
        half = breadth / 2 * (1 - max(0.0, (x / length - 0.05) / 0.45) ** 2)
        row = []
        for i in range(-girth, girth + 1):
            turn = abs(i) / girth * math.pi / 2
            y = math.copysign(half * math.sin(turn) ** 0.7, i)
            row.append((x, y, -draught + (deck + draught) * (1 - math.cos(turn)) ** 1.4))
        rows.append(row)
    return rows


def launch():
    """A hull of 20 m, the one that parts are put through below."""
    return Mesh().loft(round_bilge(20, 6.4, 2.0, 2.0))


def column(name, sides, draught, radius=6.0, quick=True):
    mesh = Mesh().revolve([(0, -draught), (radius, -draught), (radius, 5), (0, 5)], sides)
    # Corners at angles of 2πi/n from the x axis: mirrored in y = 0 for every n.
    return Shape(name, mesh, draught * polygon(radius, sides), quick=quick)


def columns():
    quick = {(3, 20), (12, 20), (20, 4), (24, 20), (60, 20)}
    return [column(f"column_{sides}_sides_{draught}_m", sides, draught,
                   quick=(sides, draught) in quick)
            for sides in (3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 32, 40, 48, 60, 72, 100, 128)
            for draught in (3, 4, 20) if draught != 3 or sides == 14]


def wedges():
    found = []
    for degrees in (5, 10, 15, 20, 30):
        bow = 3 * math.tan(math.radians(degrees))
        mesh = Mesh().prism([(-10, -3), (10, -3), (10 + bow, 0), (10, 3), (-10, 3)], -2, 2)
        found.append(Shape(f"wedge_bow_{degrees}_deg", mesh, 2 * (120 + 3 * bow),
                           quick=degrees in (5, 10)))
    return found


def heave_plate():
    profile = [(0, -30), (15, -30), (15, -29.9), (3, -29.9), (3, 8), (0, 8)]
    return Shape("heave_plate", Mesh().revolve(profile, 60),
                 polygon(15, 60) * 0.1 + polygon(3, 60) * 29.9, thinnest=0.1)


def spar():
    """A spar that narrows at the waterline, frustum between."""
    profile = [(0, -120), (9, -120), (9, -12), (5, -4), (5, 10), (0, 10)]
    areas = polygon(9, 40), polygon(5, 40)
    volume = areas[0] * 108 + areas[1] * 4 + 8 / 3 * (sum(areas) + math.sqrt(areas[0] * areas[1]))
    return Shape("spar", Mesh().revolve(profile, 40), volume)


def moonpool():
    mesh = Mesh()
    outer, inner = (17, 17), (10, 9.3)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    mesh.add([(sx * x, sy * y, z) for z in (-7, 2.5) for x, y in (outer, inner)
              for sx, sy in corners],
             [face for i in range(4) for j in [(i + 1) % 4]
              for face in ([i, j, 8 + j, 8 + i], [4 + j, 4 + i, 12 + i, 12 + j],
                           [j, i, 4 + i, 4 + j], [8 + i, 8 + j, 12 + j, 12 + i])])
    return Shape("moonpool", mesh, 7 * (34 * 34 - 20 * 18.6))


def ring():
    profile = [(8, -3), (12, -3), (12, 2), (8, 2)]
    return Shape("ring", Mesh().revolve(profile, 48, loop=True),
                 3 * (polygon(12, 48) - polygon(8, 48)))


def four_columns():
    mesh = Mesh()
    for x in (-25, 25):
        for y in (-25, 25):
            mesh.revolve([(0, -20), (6, -20), (6, 12), (0, 12)], 24, (x, y))
    return Shape("four_columns", mesh, 4 * 20 * polygon(6, 24))


def semi_submersible():
    """Columns on pontoons, braces between them, all solids that are put through one another."""
    mesh = Mesh()
    for y in (-25, 25):
        mesh.box((-40, 40), (y - 7, y + 7), (-20, -13))
        for x in (-28, 0, 28):
            mesh.revolve([(0, -14), (5, -14), (5, 12), (0, 12)], 24, (x, y))
    for x in (-28, 28):
        mesh.tube((x, -25, -10), (x, 25, -10), 1.0, 16)
    # A brace of 50 m ends within the columns, 4.95 m of it at each end; 0.02 m is 1e-5 V.
    volume = (2 * 80 * 14 * 7 + 6 * 13 * polygon(5, 24) + 2 * (50 - 2 * 4.95) * polygon(1, 16))
    return Shape("semi_submersible", mesh, volume)


def swath():
    """Two torpedoes below water with struts up to a deck above it."""
    mesh = Mesh()
    for y in (-8, 8):
        hull = Mesh().revolve([(0, -18), (1.2, -17), (1.8, -14), (1.8, 12), (1.1, 16), (0, 18)], 20)
        mesh.join(hull.moved([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], (0, y, -4)))
        mesh.prism([(-14, y - 0.05), (-8, y - 0.5), (8, y - 0.5), (14, y - 0.05), (14, y + 0.05),
                    (8, y + 0.5), (-8, y + 0.5), (-14, y + 0.05)], -3.5, 3)
    mesh.box((-15, 15), (-9, 9), (2.5, 4))
    return Shape("swath", mesh, union(mesh), thinnest=0.1)


def trimaran():
    mesh = Mesh().loft(round_bilge(40, 5, 2.2, 3))
    port = Mesh().loft(round_bilge(14, 1.4, 1.0, 3, 14, 6)).moved(shift=(-6, 8, 0))
    mesh.join(port).join(port.mirrored())
    mesh.box((-10, -2), (-8, 8), (2, 3))
    return Shape("trimaran", mesh, union(mesh))


def submarine():
    """Just below the surface, with a sail through it."""
    profile = [(3 * math.sqrt(max(0.0, 1 - (z / 20) ** 2)) if abs(z) < 20 else 0, z)
               for z in (20 * math.cos(math.pi * i / 24) for i in range(24, -1, -1))]
    mesh = Mesh().revolve(profile, 24).moved([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], (0, 0, -4))
    mesh.box((-2, 4), (-0.5, 0.5), (-2, 1.5))
    return Shape("submarine", mesh, union(mesh), thinnest=1.0)


def tilted_box():
    """A box about the origin is halved by any plane through it."""
    mesh = Mesh().box((-6, 6), (-2, 2), (-1.5, 1.5)).moved(turned(20, 5))
    return Shape("tilted_box", mesh, 12 * 4 * 3 / 2, symmetric=False)


def skeg_through(scale=1.0):
    mesh = launch()
    bare = union(mesh)
    mesh.box((-8, 2), (-0.15, 0.15), (-2.6, -1.6))
    name = "skeg_through" if scale == 1 else f"skeg_through_of_{20 * scale:g}_m"
    return Shape(name, mesh.moved([[scale, 0, 0], [0, scale, 0], [0, 0, scale]]),
                 union(mesh) * scale ** 3, without=bare * scale ** 3, thinnest=0.3 * scale,
                 quick=scale in (1.0, 0.005))


def rubbing_strakes():
    mesh = launch()
    bare = union(mesh)
    for side in (-1, 1):
        for top in (-0.3, -0.7):
            mesh.box((-9, 6), sorted((side * 2.9, side * 3.35)), (top - 0.2, top))
    return Shape("rubbing_strakes", mesh, union(mesh), without=bare, thinnest=0.2)


def rowing_boat():
    """Outer and inner skin, both open at the gunwale; floor boards are put into the bottom. The
    outer one with its sheer closed is what the water sees."""
    rows = round_bilge(4, 1.4, 0.25, 0.35, 16, 6)
    mesh = Mesh().loft(rows, top=False)
    inner = Mesh().loft(round_bilge(3.92, 1.34, 0.21, 0.35, 16, 6), ends=False, top=False)
    mesh.join(inner)
    for k in range(6):
        x = -1.4 + 0.45 * k
        mesh.box((x, x + 0.05), (-0.45, 0.45), (-0.235, -0.13))
    return Shape("rowing_boat", mesh, union(Mesh().loft(rows)))


def boxes(name, narrower):
    mesh = Mesh()
    for k in range(3):
        half = 3 - narrower * k
        mesh.box((10 * k - 15, 10 * k - 5), (-half, half), (-2, 2))
    return Shape(name, mesh, sum(2 * 10 * 2 * (3 - narrower * k) for k in range(3)))


def hanging_nodes():
    """A box whose bottom is four quadrilaterals and whose sides are one each."""
    mesh = Mesh().box((-5, 5), (-2, 2), (-2, 1))
    mesh.faces = [face for face in mesh.faces if face != [0, 2, 6, 4]]
    mesh.points += [(-5, 0, -2), (5, 0, -2), (0, -2, -2), (0, 0, -2), (0, 2, -2)]
    mesh.faces += [[0, 8, 11, 10], [8, 2, 12, 11], [10, 11, 9, 4], [11, 12, 6, 9]]
    return Shape("hanging_nodes", mesh, 80.0)


def plank(side, strake):
    """One plank: a loft of three quadrilaterals, its long edges inside its neighbours."""
    y, z = 0.03 + 0.25 * strake, 0.2 * strake - 0.4
    section = [(y, z), (y + 0.27, z + 0.216), (y + 0.254, z + 0.236), (y - 0.016, z + 0.02)]
    points = [(x, side * width * a, b) for x, width in ((-2, 0.8), (0, 1.0), (2, 0.3))
              for a, b in section]
    faces = [[4 * row + i, 4 * row + (i + 1) % 4, 4 * row + 4 + (i + 1) % 4, 4 * row + 4 + i]
             for row in range(2) for i in range(4)]
    faces = [face[::-side] for face in faces] + [[0, 1, 2, 3][::side], [8, 9, 10, 11][::-side]]
    return points, [face[::-1] for face in faces]


def planked_boat():
    """A bowl of closed planks that only touch. Its cockpit is no solid: the number is that of
    voxels of 4 mm from which the water outside was kept."""
    mesh = Mesh()
    for side in (-1, 1):
        for strake in range(3):
            mesh.add(*plank(side, strake))
    mesh.box((-2, 2), (-0.04, 0.04), (-0.48, -0.38))
    for x, half in ((-2, 0.45), (1.96, 0.25)):
        mesh.box((x, x + 0.04), (-half, half), (-0.45, 0.15))
    return Shape("planked_boat", mesh, 0.747, symmetric=False, thinnest=0.026)


def one_sided_part():
    """A hull with a twisted ring, a Möbius strip, under its stern."""
    mesh = launch()
    volume, n, points = union(mesh), 12, []
    for i in range(n):
        angle = 2 * math.pi * i / n
        for side in (-0.1, 0.1):
            radius = 0.5 + side * math.sin(angle / 2)
            points.append((-10.6 + side * math.cos(angle / 2), radius * math.cos(angle),
                           -1.2 + radius * math.sin(angle)))
    strip = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(n - 1)]
    mesh.add(points, strip + [[2 * n - 2, 1, 0, 2 * n - 1]])
    return Shape("one_sided_part", mesh, volume, said="left out")


def half_file():
    """The port half of the launch with half its deck, open at y = 0, with `--symmetric half`."""
    rows = [[point for point in row if point[1] >= 0] + [(row[0][0], 0.0, 2.0)]
            for row in round_bilge(20, 6.4, 2.0, 2.0)]
    mesh = Mesh().loft(rows, top=False)
    return Shape("half_file", mesh, union(launch()), options=["--symmetric", "half"])


def transom_launch():
    """A straight V bottom to a transom as deep as the keel."""
    points = [(-10, 0, -1.5), (6, 0, -1.5), (10, 0, 1.5), (-10, -3, 0), (4, -3, 0), (-10, 3, 0),
              (4, 3, 0), (-10, -3, 1.5), (5, -3, 1.5), (-10, 3, 1.5), (5, 3, 1.5), (8, 0, 0)]
    faces = [[0, 3, 7, 9, 5], [0, 1, 4, 3], [1, 0, 5, 6], [3, 4, 8, 7], [6, 5, 9, 10], [1, 11, 4],
             [4, 11, 2, 8], [11, 1, 6], [11, 6, 10, 2], [7, 8, 2, 10, 9]]
    mesh = Mesh().add(points, faces)
    return Shape("transom_launch", mesh, union(mesh))


def shapes():
    return [heave_plate(), skeg_through(), moonpool(), four_columns(), rowing_boat(),
            boxes("three_boxes", 0.0), boxes("three_boxes_stepped", 0.2), rubbing_strakes(),
            hanging_nodes(), planked_boat(), one_sided_part(), transom_launch(), spar(),
            semi_submersible(), swath(), ring(), trimaran(), submarine(), tilted_box(),
            half_file(), *(skeg_through(scale) for scale in (0.005, 0.2, 20)), *wedges(),
            *columns()]
