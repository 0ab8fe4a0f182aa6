// The vertices at which the sea is drawn: a fine square around the ship and rings about it, each of
// twice the cell of the one inside, to the horizon. Pure numbers; surface.js draws them.
//
// Where two cell sizes meet, the finer side leaves out every second vertex of its edge, so that
// both sides have the same edges and no crack can open. All vertices lie on the formula itself.

/// Half the number of cells of the fine square, and its cell [m]: it reaches 0.62 lengths ahead and
/// astern of the ship, and its cells are at most 0.5 m.
export function fineSquare(length) {
  const cell = Math.min(0.5, Math.max(0.05, length / 250));
  const half = 2 * Math.ceil((0.62 * length) / cell / 2);
  return { cell, half };
}

/// Levels {cell, inner, outer}: inner and outer in cells from the middle; inner of the first is 0.
export function gridLevels(cell, half, ring, reach) {
  const levels = [{ cell, inner: 0, outer: half }];
  let last = levels[0];
  while (last.cell * last.outer < reach) {
    const inner = last.outer / 2;
    const outer = inner + ring + ((inner + ring) % 2);
    last = { cell: 2 * last.cell, inner, outer };
    levels.push(last);
  }
  return levels;
}

/// {places: Float32Array [x, y, filter] per vertex, indices: Uint32Array, row: vertices in a row of
/// the fine square, levels}. `filter` [m] is the cell that waves are faded by: 0 where every wave
/// of the run is drawn, growing steadily outwards, so that nothing jumps where two levels meet.
export function makeGrid({ cell, half, ring, reach, skirt }) {
  const levels = gridLevels(cell, half, ring, reach);
  const places = [];
  const indices = [];
  const shared = new Map(); // vertices of the outer edge of the level inside
  levels.forEach((level, l) => {
    const next = new Map();
    const own = addVertices(levels, l, shared, next, places);
    addCells(level, own, indices);
    shared.clear();
    next.forEach((index, key) => shared.set(key, index));
  });
  addSkirt(levels[levels.length - 1], skirt, shared, places, indices);
  return {
    places: Float32Array.from(places), indices: Uint32Array.from(indices),
    row: 2 * half + 1, levels,
  };
}

/// The cell that fades waves at a distance r [m], the larger of |x| and |y|.
export function filterCell(levels, r) {
  const edge = (l) => levels[l].cell * levels[l].outer;
  if (r <= edge(0)) return 0;
  for (let l = 1; l < levels.length; ++l) {
    if (r > edge(l)) continue;
    const from = l === 1 ? 0 : levels[l].cell;
    return from + ((r - edge(l - 1)) / (edge(l) - edge(l - 1))) * (2 * levels[l].cell - from);
  }
  return 2 * levels[levels.length - 1].cell;
}

const keyOf = (i, j) => i * 65536 + j;

/// Vertices of a level that the level inside has not made; returns index by (i, j) in its cells.
function addVertices(levels, l, shared, next, places) {
  const { cell, inner, outer } = levels[l];
  const own = new Map();
  for (let j = -outer; j <= outer; ++j) {
    for (let i = -outer; i <= outer; ++i) {
      const r = Math.max(Math.abs(i), Math.abs(j));
      if (l > 0 && r < inner) continue;
      let index;
      if (l > 0 && r === inner) {
        index = shared.get(keyOf(2 * i, 2 * j));
      } else {
        index = places.length / 3;
        places.push(i * cell, j * cell, filterCell(levels, r * cell));
      }
      own.set(keyOf(i, j), index);
      if (r === outer) next.set(keyOf(i, j), index);
    }
  }
  return own;
}

/// Two triangles a cell; odd vertices of the outer edge move to their even neighbour.
function addCells({ inner, outer }, own, indices) {
  const even = (a) => a - (Math.abs(a) % 2) * Math.sign(a);
  const vertex = (i, j) => {
    const a = Math.abs(j) === outer ? even(i) : i;
    const b = Math.abs(i) === outer ? even(j) : j;
    return own.get(keyOf(a, b));
  };
  const triangle = (a, b, c) => {
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  };
  for (let j = -outer; j < outer; ++j) {
    for (let i = -outer; i < outer; ++i) {
      const hole = i >= -inner && i < inner && j >= -inner && j < inner;
      if (inner > 0 && hole) continue;
      const [a, b, c, d] =
        [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
      if ((i + j) % 2 === 0) {
        triangle(a, b, c);
        triangle(a, c, d);
      } else {
        triangle(a, b, d);
        triangle(b, c, d);
      }
    }
  }
}

/// Calm water from the last level's edge to the horizon.
function addSkirt({ outer, cell }, skirt, shared, places, indices) {
  const rim = [];
  for (let i = -outer; i < outer; i += 2) rim.push([i, -outer]);
  for (let j = -outer; j < outer; j += 2) rim.push([outer, j]);
  for (let i = outer; i > -outer; i -= 2) rim.push([i, outer]);
  for (let j = outer; j > -outer; j -= 2) rim.push([-outer, j]);
  const first = places.length / 3;
  const scale = skirt / (outer * cell);
  for (const [i, j] of rim) places.push(i * cell * scale, j * cell * scale, 1e6);
  rim.forEach(([i, j], n) => {
    const m = (n + 1) % rim.length;
    const [a, b] = [shared.get(keyOf(i, j)), shared.get(keyOf(...rim[m]))];
    indices.push(a, first + n, first + m, a, first + m, b);
  });
}
