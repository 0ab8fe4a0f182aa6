// The hull's faces as they are drawn: smooth where they bend little and sharp at edges; its
// connected parts; which paint each face has. Pure numbers; hull.js draws them.

/// Normals for triangles: of neighbours at a vertex, those that differ by less than `crease` [rad]
/// are averaged, weighted by area. points 3 per point, faces 3 per triangle; one normal per corner.
export function creasedNormals(points, faces, crease) {
  const n = faces.length / 3;
  const area = new Float64Array(3 * n);
  const unit = new Float64Array(3 * n);
  const at = (v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
  const byPlace = new Map();
  for (let f = 0; f < n; ++f) {
    const [a, b, c] = [0, 1, 2].map((k) => at(faces[3 * f + k]));
    const u = b.map((v, i) => v - a[i]);
    const w = c.map((v, i) => v - a[i]);
    const cross = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
    const length = Math.hypot(...cross) || 1;
    cross.forEach((v, i) => {
      area[3 * f + i] = v;
      unit[3 * f + i] = v / length;
    });
    [a, b, c].forEach((p, k) => {
      const key = p.map((v) => Math.round(v * 1e4)).join(",");
      if (!byPlace.has(key)) byPlace.set(key, []);
      byPlace.get(key).push(3 * f + k);
    });
  }
  const limit = Math.cos(crease);
  const out = new Float32Array(9 * n);
  for (const corners of byPlace.values()) {
    for (const corner of corners) {
      const f = Math.floor(corner / 3);
      const sum = [0, 0, 0];
      for (const other of corners) {
        const g = Math.floor(other / 3);
        let dot = 0;
        for (let i = 0; i < 3; ++i) dot += unit[3 * f + i] * unit[3 * g + i];
        if (dot < limit) continue;
        for (let i = 0; i < 3; ++i) sum[i] += area[3 * g + i];
      }
      const length = Math.hypot(...sum) || 1;
      for (let i = 0; i < 3; ++i) out[3 * corner + i] = sum[i] / length;
    }
  }
  return out;
}

/// Which connected part of the mesh each triangle belongs to, the largest box first.
export function connectedParts(points, faces) {
  const root = new Map();
  const find = (a) => {
    while (root.get(a) !== a) {
      root.set(a, root.get(root.get(a)));
      a = root.get(a);
    }
    return a;
  };
  const keys = [];
  for (let v = 0; v < points.length / 3; ++v) {
    keys.push([0, 1, 2].map((i) => Math.round(points[3 * v + i] * 1e4)).join(","));
    if (!root.has(keys[v])) root.set(keys[v], keys[v]);
  }
  for (let f = 0; f < faces.length; f += 3) {
    const a = find(keys[faces[f]]);
    for (let k = 1; k < 3; ++k) root.set(find(keys[faces[f + k]]), a);
  }
  const parts = new Map();
  for (let f = 0; f < faces.length; f += 3) {
    const key = find(keys[faces[f]]);
    if (!parts.has(key)) {
      parts.set(key, { faces: [], low: [1e9, 1e9, 1e9], high: [-1e9, -1e9, -1e9] });
    }
    const part = parts.get(key);
    part.faces.push(f / 3);
    for (let k = 0; k < 3; ++k) {
      for (let i = 0; i < 3; ++i) {
        const v = points[3 * faces[f + k] + i];
        part.low[i] = Math.min(part.low[i], v);
        part.high[i] = Math.max(part.high[i], v);
      }
    }
  }
  const bulk = (p) => p.high.reduce((product, v, i) => product * (v - p.low[i] + 1e-3), 1);
  return Array.from(parts.values()).sort((a, b) => bulk(b) - bulk(a));
}

/// Paint of the surface, as numbers in the vertex attribute `paint`.
export const PAINT = { hull: 0, house: 1, glass: 2, dark: 3, deck: 4, box: 5, metal: 6, orange: 7 };

/// Triangles of a closed hull: {position, normal, paint, calm} per corner, and the main part's box.
export function hullArrays(points, faces) {
  const parts = connectedParts(points, faces);
  const normal = creasedNormals(points, faces, (38 * Math.PI) / 180);
  const n = faces.length;
  const position = new Float32Array(3 * n);
  const paint = new Float32Array(n);
  const band = new Float32Array(2 * n); // height and range of the windows of a part above the hull
  for (let c = 0; c < n; ++c) {
    for (let i = 0; i < 3; ++i) position[3 * c + i] = points[3 * faces[c] + i];
  }
  parts.slice(1).forEach((part) => {
    const size = part.high.map((v, i) => v - part.low[i]);
    const slender = size[2] > 1.5 * Math.max(size[0], size[1]) || size[0] < 0.02 * size[1];
    for (const f of part.faces) {
      for (let k = 0; k < 3; ++k) {
        paint[3 * f + k] = slender ? PAINT.metal : PAINT.house;
        band[6 * f + 2 * k] = part.low[2];
        band[6 * f + 2 * k + 1] = size[2];
      }
    }
  });
  return { position, normal, paint, band, parts };
}
