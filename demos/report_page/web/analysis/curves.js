// Curves of RAOs as they are drawn: over which abscissa, and where a line must break. Pure.
import { encounter } from "./sea.js";

/** Abscissae to choose from: value at ω. */
export const ABSCISSAE = [
  { key: "omega", name: "wave frequency ω", label: "ω", unit: "rad/s" },
  { key: "encounter", name: "encounter frequency |ωₑ|", label: "|ωₑ|", unit: "rad/s" },
  { key: "length", name: "wave length λ/L", label: "λ/L", unit: "" },
];

/** @param about {speed, headingDeg, gravity, length} */
export function abscissaAt(key, omega, { speed, headingDeg, gravity, length }) {
  if (key === "encounter") return Math.abs(encounter(omega, speed, headingDeg, gravity));
  if (key === "length") return 2 * Math.PI * gravity / (omega * omega * length);
  return omega;
}

/**
 * A curve cut where its abscissa turns round, each part with ascending x: [{x, y}]. In following
 * seas one ω_e belongs to up to three waves.
 */
export function ascendingParts(x, y) {
  const parts = [];
  let begin = 0;
  for (let i = 1; i <= x.length; ++i) {
    const turns = i === x.length
      || (i > begin + 1 && Math.sign(x[i] - x[i - 1]) !== Math.sign(x[i - 1] - x[i - 2]));
    if (!turns) continue;
    const part = { x: [...x.slice(begin, i)], y: [...y.slice(begin, i)] };
    if (part.x.length > 1 && part.x[1] < part.x[0]) {
      part.x.reverse();
      part.y.reverse();
    }
    parts.push(part);
    begin = i - 1;
    if (i === x.length) break;
  }
  return parts;
}

/** Points in the order of x. */
export function sortedPoints(x, y) {
  const order = x.map((_, i) => i).sort((a, b) => x[a] - x[b]);
  return { x: order.map((i) => x[i]), y: order.map((i) => y[i]) };
}

/**
 * Phases in degrees as lines that end at ±180 and go on at the other edge, and that leave out what
 * is null: parts [{x, y}].
 */
export function unwrapped({ x, y }) {
  const parts = [];
  let part = null;
  const begin = () => {
    part = { x: [], y: [] };
    parts.push(part);
  };
  const add = (at, value) => {
    part.x.push(at);
    part.y.push(value);
  };
  x.forEach((at, i) => {
    const before = y[i - 1] ?? null, now = y[i];
    if (now === null) return;
    if (before === null) begin();
    else if (Math.abs(now - before) > 180) {
      const edge = before > 0 ? 180 : -180, way = now + 2 * edge - before;
      const cross = x[i - 1] + (way === 0 ? 0.5 : (edge - before) / way) * (at - x[i - 1]);
      add(cross, edge);
      begin();
      add(cross, -edge);
    }
    add(at, now);
  });
  return parts;
}
