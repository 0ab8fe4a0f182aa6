// Still water on a hull that is held in a pose: the part of a closed triangle net below the calm
// surface z = 0, its volume and centre, and where its waterline ends. Pure.

/** Points turned by roll, then pitch [rad], and raised by `height` [m]: x forward, z up. */
export function posed(points, { height = 0, roll = 0, pitch = 0 }) {
  const [sr, cr, sp, cp] = [Math.sin(roll), Math.cos(roll), Math.sin(pitch), Math.cos(pitch)];
  const turned = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    const up = y * sr + z * cr;
    turned[i] = x * cp + up * sp;
    turned[i + 1] = y * cr - z * sr;
    turned[i + 2] = up * cp - x * sp + height;
  }
  return turned;
}

// Where the edge from corner a to corner b meets the surface.
function crossing(p, a, b) {
  const share = p[a + 2] / (p[a + 2] - p[b + 2]);
  return [p[a] + share * (p[b] - p[a]), p[a + 1] + share * (p[b + 1] - p[a + 1]), 0];
}

/**
 * Volume below z = 0 and its centre. Each triangle's wet part and the origin, which lies in the
 * surface, make a tetrahedron with sign; the lid that closes the cut lies in the surface as well,
 * and adds nothing.
 * @param points  3 numbers a point, already posed
 * @param faces   3 indices a triangle, seen counterclockwise from outside
 * @return {volume, centre: [x, y, z] or null, waterline: [aft x, fore x] or null}
 */
export function submerged(points, faces) {
  const sum = { volume: 0, x: 0, y: 0, z: 0 };
  let aft = Infinity, fore = -Infinity;
  for (let f = 0; f < faces.length; f += 3) {
    const corners = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
    if (corners.every((c) => points[c + 2] >= 0)) continue;
    const wet = [];
    corners.forEach((from, i) => {
      const to = corners[(i + 1) % 3];
      const below = points[from + 2] < 0;
      if (below) wet.push([points[from], points[from + 1], points[from + 2]]);
      if (below === points[to + 2] < 0) return;
      const cut = crossing(points, from, to);
      wet.push(cut);
      aft = Math.min(aft, cut[0]);
      fore = Math.max(fore, cut[0]);
    });
    for (let i = 2; i < wet.length; ++i) addTetrahedron(sum, wet[0], wet[i - 1], wet[i]);
  }
  const { volume } = sum;
  return { volume, centre: volume ? [sum.x, sum.y, sum.z].map((part) => part / volume) : null,
    waterline: fore > aft ? [aft, fore] : null };
}

function addTetrahedron(sum, a, b, c) {
  const volume = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
    + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  sum.volume += volume;
  sum.x += volume * (a[0] + b[0] + c[0]) / 4;
  sum.y += volume * (a[1] + b[1] + c[1]) / 4;
  sum.z += volume * (a[2] + b[2] + c[2]) / 4;
}

/**
 * Load of still water on a hull whose points are about G: force up [m³], moments about G in roll
 * and pitch [m⁴], both over the specific weight ρg.
 * @param pose {height of G above the surface, roll, pitch}
 */
export function stillWaterLoad(points, faces, pose) {
  const { volume, centre } = submerged(posed(points, pose), faces);
  return { heave: volume, roll: centre ? volume * centre[1] : 0,
    pitch: centre ? -volume * centre[0] : 0 };
}
