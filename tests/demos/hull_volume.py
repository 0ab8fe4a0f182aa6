"""The wet volume of a union of closed solids that may overlap, without any mesh of their union.

Lines parallel to z cross the solids' faces. Along a line each face met from outside counts +1 and
each one met from inside -1; where the sum is above 0 the line is inside at least one solid. The
lengths of these parts below water, times each line's share of the plane, add up to the volume. Each
line is exact, so the only error is that of the grid of lines. It is told by a second grid.
"""
import numpy as np


def middles(low, high, spacing, breaks, random):
    """Places near the middle of cells between `breaks` (where the solids jump) and their widths.
    They keep off the middle by a thousandth of a cell, as diagonals of faces pass through it."""
    inner = [value for value in breaks if low < value < high]
    edges = np.unique(np.round([low, *inner, high], 12))
    lefts, widths = [], []
    for left, right in zip(edges, edges[1:]):
        count = max(1, int(np.ceil((right - left) / spacing)))
        width = (right - left) / count
        lefts.append(left + width * np.arange(count))
        widths.append(np.full(count, width))
    lefts, widths = np.concatenate(lefts), np.concatenate(widths)
    return lefts + widths * (0.5 + 1e-3 * random.uniform(-1, 1, len(lefts))), widths


def cross(first, second):
    return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]


def crossings(triangles, xs, ys):
    """(line, z, +1 entering or -1 leaving) of all lines through (xs[i], ys[j]).

    Line number i len(ys) + j."""
    flat = triangles[..., :2]
    area = cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0])
    triangles, flat, area = (part[area != 0] for part in (triangles, flat, area))
    i, j = (np.searchsorted(axis, flat[..., k].min(1)) for k, axis in enumerate((xs, ys)))
    rows, columns = (np.searchsorted(axis, flat[..., k].max(1)) - start
                     for k, (axis, start) in enumerate(((xs, i), (ys, j))))
    count = rows * columns
    of = np.repeat(np.arange(len(count)), count)
    number = np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)
    i, j = i[of] + number // columns[of], j[of] + number % columns[of]
    place = np.stack([xs[i], ys[j]], axis=1)
    corners = flat[of]
    shares = np.stack([cross(corners[:, (k + 2) % 3] - corners[:, (k + 1) % 3],
                             place - corners[:, (k + 1) % 3]) for k in range(3)], axis=1)
    shares /= area[of][:, None]
    hit = (shares > 0).all(1)
    heights = (shares * triangles[of][..., 2]).sum(1)
    return (i * len(ys) + j)[hit], heights[hit], np.where(area[of] < 0, 1, -1)[hit]


def grid_volume(triangles, plane, spacing, breaks, seed):
    """By one grid. The water is where plane · (x, y, z, 1) < 0; plane[2] > 0."""
    random = np.random.default_rng(seed)
    low, high = triangles.min((0, 1)), triangles.max((0, 1))
    xs, x_widths = middles(low[0], high[0], spacing, breaks[0], random)
    ys, y_widths = middles(low[1], high[1], spacing, breaks[1], random)
    line, z, sign = crossings(triangles, xs, ys)
    order = np.lexsort((z, line))
    line, z, sign = line[order], z[order], sign[order]
    assert not np.bincount(line, sign).any(), "a solid is not closed"
    inside = np.cumsum(sign)[:-1] > 0
    i, j = line // len(ys), line % len(ys)
    surface = -(plane[0] * xs[i] + plane[1] * ys[j] + plane[3]) / plane[2]
    length = np.minimum(z[1:], surface[:-1]) - np.minimum(z[:-1], surface[:-1])
    return float((length * x_widths[i[:-1]] * y_widths[j[:-1]])[inside].sum())


def union_volume(triangles, plane=(0.0, 0.0, 1.0, 0.0), breaks=((), ()), lines=60000):
    """(volume, difference from that of half as many lines) of the solids' union below water.
    @param triangles  of all solids, each closed and with its faces outwards
    @param breaks     x and y where vertical faces stand that lie along the axes: exact then"""
    size = np.ptp(triangles[..., :2], axis=(0, 1))
    spacing = np.sqrt(size[0] * size[1] / lines)
    fine = grid_volume(triangles, plane, spacing, breaks, 1)
    return fine, abs(fine - grid_volume(triangles, plane, 1.41 * spacing, breaks, 2))


def upright_breaks(mesh):
    """x and y of a mesh's vertical faces across and along, for `breaks`."""
    triangles = mesh.triangles()
    return tuple({round(float(t[0, axis]), 9) for t in triangles
                  if np.ptp(t[:, axis]) < 1e-9} for axis in (0, 1))
