// What stands on a bare hull: bridge, mast, funnel, boats of simple blocks, scaled to the ship.
// Decoration only: nothing of it is in the run. A hull file that has its own houses gets none.
import { PAINT } from "./mesh.js";

/// Heights of a hull: the top of its deck at x, y by the faces above that point, and how far the
/// deck reaches to port at x. In ship axes [m].
export function makeDeck(points, faces) {
  const at = (v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
  const heightAt = (x, y) => {
    let top = -Infinity;
    for (let f = 0; f < faces.length; f += 3) {
      const [a, b, c] = [at(faces[f]), at(faces[f + 1]), at(faces[f + 2])];
      const d = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      if (Math.abs(d) < 1e-9) continue;
      const u = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / d;
      const v = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / d;
      if (u < -1e-6 || v < -1e-6 || u + v > 1 + 1e-6) continue;
      top = Math.max(top, a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
    }
    return top;
  };
  const halfBreadth = (x) => {
    const deck = heightAt(x, 0);
    if (!Number.isFinite(deck)) return 0;
    let low = 0;
    let high = 1;
    while (heightAt(x, high) > deck - 0.25 * Math.abs(high) - 0.3 && high < 200) high *= 2;
    for (let i = 0; i < 24; ++i) {
      const middle = 0.5 * (low + high);
      if (heightAt(x, middle) > deck - 0.1 * middle - 0.1) low = middle;
      else high = middle;
    }
    return low;
  };
  return { heightAt, halfBreadth };
}

/// Collects flat faces.
class Blocks {
  constructor() {
    this.position = [];
    this.normal = [];
    this.paint = [];
    this.band = [];
    this.base = [0, 0]; // height of the block in work, and its range
  }
  quad(a, b, c, d, paint) {
    const u = b.map((v, i) => v - a[i]);
    const w = d.map((v, i) => v - a[i]);
    const w2 = c.map((v, i) => v - a[i]);
    let n = [u[1] * w2[2] - u[2] * w2[1], u[2] * w2[0] - u[0] * w2[2], u[0] * w2[1] - u[1] * w2[0]];
    if (Math.hypot(...n) < 1e-9) {
      n = [w2[1] * w[2] - w2[2] * w[1], w2[2] * w[0] - w2[0] * w[2], w2[0] * w[1] - w2[1] * w[0]];
    }
    const length = Math.hypot(...n) || 1;
    for (const p of [a, b, c, a, c, d]) {
      this.position.push(...p);
      this.normal.push(...n.map((v) => v / length));
      this.paint.push(paint);
      this.band.push(...this.base);
    }
  }
  /// Between two level rectangles {x0, x1, h0, h1, z}: ends in x with their half breadths, y
  /// middle.
  frustum(low, high, paint, { roof = paint, y = 0 } = {}) {
    const corners = ({ x0, x1, h0, h1 = h0, z, z1 = z }) => [
      [x0, y - h0, z],
      [x1, y - h1, z1],
      [x1, y + h1, z1],
      [x0, y + h0, z],
    ];
    const a = corners(low);
    const b = corners(high);
    this.base = [low.z, high.z - low.z];
    for (let i = 0; i < 4; ++i) {
      const j = (i + 1) % 4;
      this.quad(a[i], a[j], b[j], b[i], paint);
    }
    this.quad(b[0], b[1], b[2], b[3], roof);
    this.quad(a[3], a[2], a[1], a[0], paint);
  }
  /// A wall, a band of windows and a brow, all leaning alike.
  bridge(low, high, [sill, head], paint) {
    const mix = (f) =>
      Object.fromEntries(
        Object.keys(high).map((k) => [
          k,
          (low[k] ?? high[k]) + f * (high[k] - (low[k] ?? high[k])),
        ]),
      );
    const inset = (r, d) => ({
      ...r,
      x0: r.x0 + d,
      x1: r.x1 - d,
      h0: r.h0 - d,
      h1: (r.h1 ?? r.h0) - d,
    });
    const d = 0.02 * (high.z - low.z);
    this.frustum(low, mix(sill), paint);
    this.frustum(inset(mix(sill), d), inset(mix(head), d), PAINT.glass);
    this.frustum(mix(head), high, paint, { roof: PAINT.deck });
    // Posts between the panes.
    const [s, h] = [mix(sill), mix(head)];
    const post = 0.05 * (high.z - low.z);
    for (let i = 0; i <= 6; ++i) {
      const along = (r, f) => r.h1 * (2 * f - 1);
      const f = i / 6;
      const q = (r, e) => [r.x1, along({ ...r, h1: r.h1 ?? r.h0 }, f) + e, r.z];
      this.quad(q(s, -post), q(s, post), q(h, post), q(h, -post), paint);
    }
    for (const side of [-1, 1]) {
      for (let i = 0; i <= 5; ++i) {
        const f = i / 5;
        const q = (r, e) => {
          const x = r.x0 + f * (r.x1 - r.x0);
          return [x + e, side * (r.h0 + f * ((r.h1 ?? r.h0) - r.h0)), r.z];
        };
        this.quad(q(s, -post), q(s, post), q(h, post), q(h, -post), paint);
      }
    }
  }
  pole(x, y, z0, z1, r, paint = PAINT.metal, lean = 0, taper = 0.5) {
    const sides = 6;
    const ring = (z, radius, shift) =>
      Array.from({ length: sides }, (_, i) => {
        const a = (2 * Math.PI * i) / sides;
        return [x + shift + radius * Math.cos(a), y + radius * Math.sin(a), z];
      });
    const a = ring(z0, r, 0);
    const b = ring(z1, taper * r, lean);
    for (let i = 0; i < sides; ++i) {
      const j = (i + 1) % sides;
      this.quad(a[i], a[j], b[j], b[i], paint);
    }
  }
  /// Along the ship at y = 0 from x0 to x1, at the height height(x).
  rod(x0, x1, height, r, paint) {
    const ring = (x) =>
      Array.from({ length: 6 }, (_, i) => {
        const a = (Math.PI * i) / 3;
        return [x, r * Math.cos(a), height(x) + r * Math.sin(a)];
      });
    const [a, b] = [ring(x0), ring(x1)];
    for (let i = 0; i < 6; ++i) this.quad(a[i], b[i], b[(i + 1) % 6], a[(i + 1) % 6], paint);
    this.quad(b[0], b[1], b[2], b[3], paint);
    this.quad(b[0], b[3], b[4], b[5], paint);
  }
  dome(x, y, z, r, paint) {
    const [rings, sides] = [5, 12];
    const point = (i, j) => {
      const a = Math.PI * (i / rings) * 0.62;
      const b = (2 * Math.PI * j) / sides;
      return [
        x + r * Math.sin(a) * Math.cos(b),
        y + r * Math.sin(a) * Math.sin(b),
        z + r * Math.cos(a),
      ];
    };
    for (let i = 0; i < rings; ++i) {
      for (let j = 0; j < sides; ++j) {
        this.quad(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1), paint);
      }
    }
  }
}

/// {position, normal, paint, band, rails, eye}: faces, railing lines and the eye on the bridge; or
/// null where nothing is put on the hull.
export function decorate(box, points, faces) {
  const length = box.high[0] - box.low[0];
  const beam = box.high[1] - box.low[1];
  if (length < 2.2 * beam) return null;
  const deck = makeDeck(points, faces);
  const blocks = new Blocks();
  const x = (s) => box.low[0] + s * length;
  const eye =
    length > 45 && length > 5 * beam
      ? frigate(blocks, deck, x, length)
      : workboat(blocks, deck, x, length);
  return {
    position: Float32Array.from(blocks.position),
    normal: Float32Array.from(blocks.normal),
    paint: Float32Array.from(blocks.paint),
    band: Float32Array.from(blocks.band),
    rails: railing(deck, x, length),
    eye,
  };
}

/// A block on deck: ends s0, s1 along the ship, share of the deck's breadth, height over the deck.
function block(deck, x, s0, s1, share, height, base = 0) {
  const half = (s) => share * deck.halfBreadth(x(s));
  const z = Math.min(deck.heightAt(x(s0), 0), deck.heightAt(x(s1), 0)) + base;
  const top = Math.max(deck.heightAt(x(s0), 0), deck.heightAt(x(s1), 0)) + base + height;
  const lean = 0.11 * height;
  return {
    low: { x0: x(s0), x1: x(s1), h0: half(s0), h1: half(s1), z: z - 0.05 * height },
    high: {
      x0: x(s0) + 0.5 * lean,
      x1: x(s1) - 1.6 * lean,
      h0: half(s0) - lean,
      h1: Math.max(0.2 * half(s1), half(s1) - lean),
      z: top,
    },
  };
}

function frigate(b, deck, x, L) {
  const on = (s0, s1, share, height, base) =>
    block(deck, x, s0, s1, share, height * L, (base ?? 0) * L);
  const house = PAINT.house;
  const plain = { roof: PAINT.deck };
  // Bridge: two decks of house, then the wheelhouse.
  const lower = on(0.5, 0.715, 0.96, 0.024);
  b.frustum(lower.low, lower.high, house, plain);
  const z1 = lower.high.z;
  const second = on(0.535, 0.685, 0.86, 0.02, 0);
  second.low.z = z1 - 0.01 * L;
  second.high.z = z1 + 0.02 * L;
  b.frustum(second.low, second.high, house, plain);
  const wheel = on(0.565, 0.668, 0.8, 0.024, 0);
  const z2 = second.high.z;
  wheel.low.z = z2 - 0.003 * L;
  wheel.high.z = z2 + 0.023 * L;
  b.bridge(wheel.low, wheel.high, [0.42, 0.78], house);
  const z3 = wheel.high.z;
  // Mast: a tapered tower with yards, radar and pole.
  const m = x(0.585);
  const w = 0.018 * L;
  b.frustum(
    { x0: m - w, x1: m + w, h0: w, z: z3 - 0.2 },
    { x0: m - 0.62 * w, x1: m + 0.25 * w, h0: 0.35 * w, z: z3 + 0.072 * L },
    house,
  );
  b.frustum(
    { x0: m - 0.7 * w, x1: m + 0.6 * w, h0: 1.25 * w, z: z3 + 0.036 * L },
    { x0: m - 0.7 * w, x1: m + 0.6 * w, h0: 1.3 * w, z: z3 + 0.0385 * L },
    PAINT.metal,
  );
  b.frustum(
    { x0: m - 0.16 * w, x1: m + 0.02 * w, h0: 2.9 * w, z: z3 + 0.062 * L },
    { x0: m - 0.16 * w, x1: m + 0.02 * w, h0: 2.9 * w, z: z3 + 0.0634 * L },
    PAINT.metal,
  );
  b.frustum(
    { x0: m - 0.1 * w, x1: m + 0.18 * w, h0: 1.1 * w, z: z3 + 0.0725 * L },
    { x0: m - 0.1 * w, x1: m + 0.18 * w, h0: 1.1 * w, z: z3 + 0.079 * L },
    PAINT.metal,
  );
  b.pole(m - 0.2 * w, 0, z3 + 0.07 * L, z3 + 0.112 * L, 0.0016 * L);
  for (const y of [-2.3, -1.2, 1.2, 2.3])
    b.pole(m - 0.07 * w, y * w, z3 + 0.063 * L, z3 + 0.085 * L, 0.0006 * L);
  b.dome(x(0.652), 0, z3 + 0.004 * L, 0.01 * L, PAINT.house);
  // Midships: a low house with boats, the funnel.
  const mid = on(0.335, 0.505, 0.62, 0.021);
  b.frustum(mid.low, mid.high, house, plain);
  const zm = mid.high.z;
  const f = { x0: x(0.395), x1: x(0.465), h0: 0.026 * L, h1: 0.023 * L, z: zm - 0.1 };
  b.frustum(
    f,
    { x0: x(0.396), x1: x(0.448), h0: 0.019 * L, h1: 0.016 * L, z: zm + 0.036 * L },
    house,
  );
  b.frustum(
    { x0: x(0.3965), x1: x(0.4475), h0: 0.0185 * L, h1: 0.0155 * L, z: zm + 0.036 * L },
    { x0: x(0.399), x1: x(0.444), h0: 0.017 * L, h1: 0.014 * L, z: zm + 0.043 * L },
    PAINT.dark,
  );
  for (const side of [-1, 1]) {
    const y = side * 0.8 * deck.halfBreadth(x(0.47));
    const z = deck.heightAt(x(0.47), 0);
    b.frustum(
      { x0: x(0.452), x1: x(0.487), h0: 0.004 * L, h1: 0.002 * L, z: z + 0.01 * L },
      { x0: x(0.45), x1: x(0.492), h0: 0.008 * L, h1: 0.0035 * L, z: z + 0.019 * L },
      PAINT.orange,
      { y },
    );
    for (const s of [0.457, 0.48])
      b.pole(x(s), y - side * 0.006 * L, z, z + 0.028 * L, 0.0015 * L, PAINT.metal);
  }
  // Hangar over the flight deck, its door, a dome and the aft mast.
  const hangar = on(0.205, 0.338, 0.92, 0.04);
  b.frustum(hangar.low, hangar.high, house, plain);
  const door = 0.62 * hangar.low.h0;
  const zh = hangar.low.z;
  b.quad(
    [x(0.205) - 0.02, door, zh],
    [x(0.205) - 0.02, -door, zh],
    [hangar.high.x0 - 0.12, -door, zh + 0.034 * L],
    [hangar.high.x0 - 0.12, door, zh + 0.034 * L],
    PAINT.dark,
  );
  b.dome(x(0.315), 0.03 * L, hangar.high.z + 0.004 * L, 0.011 * L, house);
  b.dome(x(0.315), -0.03 * L, hangar.high.z + 0.004 * L, 0.011 * L, house);
  const a = x(0.3);
  b.frustum(
    { x0: a - 0.01 * L, x1: a + 0.008 * L, h0: 0.008 * L, z: hangar.high.z },
    { x0: a - 0.006 * L, x1: a + 0.001 * L, h0: 0.003 * L, z: hangar.high.z + 0.052 * L },
    house,
  );
  b.frustum(
    { x0: a - 0.004 * L, x1: a, h0: 0.026 * L, z: hangar.high.z + 0.051 * L },
    { x0: a - 0.004 * L, x1: a, h0: 0.026 * L, z: hangar.high.z + 0.0535 * L },
    PAINT.metal,
  );
  // Gun, cells of the foredeck, breakwater.
  const g = x(0.835);
  const zg = deck.heightAt(g, 0);
  b.frustum(
    { x0: g - 0.018 * L, x1: g + 0.016 * L, h0: 0.013 * L, h1: 0.01 * L, z: zg - 0.1 },
    { x0: g - 0.014 * L, x1: g + 0.004 * L, h0: 0.008 * L, h1: 0.006 * L, z: zg + 0.019 * L },
    house,
  );
  const barrel = (px) => zg + 0.011 * L + 0.1 * (px - g);
  b.rod(g, g + 0.05 * L, barrel, 0.0013 * L, PAINT.metal);
  const cells = on(0.735, 0.785, 0.46, 0.007);
  b.frustum(cells.low, cells.high, house, plain);
  const bow = x(0.992);
  b.pole(bow, 0, deck.heightAt(bow, 0), deck.heightAt(bow, 0) + 0.024 * L, 0.0008 * L);
  b.pole(
    x(0.008),
    0,
    deck.heightAt(x(0.008), 0),
    deck.heightAt(x(0.008), 0) + 0.03 * L,
    0.0008 * L,
  );
  return [wheel.high.x1 + 0.012 * L, 0.1 * wheel.high.h0, z2 + 0.0165 * L];
}

function workboat(b, deck, x, L) {
  const house = block(deck, x, 0.42, 0.72, 0.72, 0.07 * L);
  b.frustum(house.low, house.high, PAINT.house, { roof: PAINT.deck });
  const wheel = block(deck, x, 0.5, 0.66, 0.6, 0.08 * L);
  wheel.low.z = house.high.z - 0.005 * L;
  wheel.high.z = house.high.z + 0.075 * L;
  b.bridge(wheel.low, wheel.high, [0.42, 0.82], PAINT.house);
  b.pole(x(0.53), 0, wheel.high.z, wheel.high.z + 0.16 * L, 0.006 * L, PAINT.metal, -0.01 * L);
  b.pole(
    x(0.44),
    0.2 * house.high.h0,
    house.high.z,
    house.high.z + 0.07 * L,
    0.016 * L,
    PAINT.dark,
    -0.005 * L,
    0.9,
  );
  return [wheel.high.x1 + 0.02 * L, 0, wheel.low.z + 0.6 * (wheel.high.z - wheel.low.z)];
}

/// Rails along the deck's edge, as line segments.
function railing(deck, x, L) {
  const height = Math.min(1.1, 0.07 * L);
  const gap = Math.max(1.6, L / 70);
  const stations = [];
  for (let s = 0.01; s < 0.975; s += gap / L) {
    const h = deck.halfBreadth(x(s)) - 0.012 * L * 0.1;
    if (h > 0.004 * L) stations.push([x(s), h, deck.heightAt(x(s), 0.97 * h)]);
  }
  const lines = [];
  for (const side of [-1, 1]) {
    stations.forEach(([px, h, z], i) => {
      lines.push(px, side * h, z, px, side * h, z + height);
      if (i === 0) return;
      const [qx, qh, qz] = stations[i - 1];
      for (const f of [0.5, 1]) {
        lines.push(qx, side * qh, qz + f * height, px, side * h, z + f * height);
      }
    });
  }
  return Float32Array.from(lines);
}
