// Pressure of the water on points of a hull, and round numbers for scales.
import { rotate } from "./motion.js";
import { waterAt } from "./wave.js";

/// 1, 2 or 5 times a power of ten, at least x.
export function niceAbove(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [1, 2, 5, 10].find((m) => m * power >= x * (1 - 1e-9)) * power;
}

/// rho g (H - z) [kPa] at each point of a hull {points: in ship axes} at a pose {position, q};
/// below 0 where the point is dry. place.z is above calm water.
export function pressures(points, pose, sea, t, density, out) {
  const factor = (density * sea.gravity) / 1000;
  for (let v = 0; v < points.length / 3; ++v) {
    const r = rotate(pose.q, [points[3 * v], points[3 * v + 1], points[3 * v + 2]]);
    const z = pose.position[2] + r[2];
    const { head } = waterAt(sea, t, pose.position[0] + r[0], pose.position[1] + r[1], z);
    out[v] = factor * (head - z);
  }
  return out;
}
