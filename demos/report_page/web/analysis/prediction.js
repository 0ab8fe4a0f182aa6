// Linear prediction of a run: each component of its sea through the RAO of the direction in which
// it meets the ship. Pure.
import { encounter, isHeld } from "./sea.js";

/** Linear in ω: 12 numbers of the modes; null outside of the frequencies. */
function motionAt(omega, values, heading, at) {
  const n = omega.length;
  if (!n || at < omega[0] - 1e-9 || at > omega[n - 1] + 1e-9) return null;
  let right = omega.findIndex((frequency) => frequency >= at);
  if (right < 0) right = n - 1;
  const left = Math.max(0, right - 1);
  const share = right === left ? 0 : (at - omega[left]) / (omega[right] - omega[left]);
  return Float64Array.from({ length: 12 }, (_, i) =>
    (1 - share) * values[(heading * n + left) * 12 + i]
    + share * values[(heading * n + right) * 12 + i]);
}

// Of headings round the circle the two beside `headingDeg` and how they share; of headings from 0
// to 180 only, the mirror image of a symmetric ship.
function besides(headingsDeg, headingDeg) {
  let beta = ((headingDeg % 360) + 360) % 360;
  const least = headingsDeg[0], most = headingsDeg.at(-1);
  const mirror = beta > most && least <= 0;
  if (mirror) beta = 360 - beta;
  if (beta < least - 1e-9 || beta > most + 1e-9) return null;
  let right = headingsDeg.findIndex((heading) => heading >= beta - 1e-9);
  const left = Math.max(0, headingsDeg[right] <= beta + 1e-9 ? right : right - 1);
  if (headingsDeg[right] <= beta + 1e-9) right = left;
  const share = right === left ? 0
    : (beta - headingsDeg[left]) / (headingsDeg[right] - headingsDeg[left]);
  return { left, right, share, mirror };
}

/**
 * Lines [{omega: ω_e, variance}] of the six modes (rotations in rad²) and of the wave, from the
 * components of a sea. `table` is {omega, values} of one heading, or with headingsDeg of many.
 * `covered` is the share of the wave's energy for which there is an RAO.
 */
export function predict(sea, table, speed, gravity) {
  const modes = Array.from({ length: 6 }, () => []), wave = [];
  let all = 0, covered = 0;
  for (let i = 0; i < sea.omega.length; ++i) {
    const energy = sea.amplitude[i] ** 2 / 2;
    const headingDeg = sea.heading[i] * 180 / Math.PI;
    const omega = encounter(sea.omega[i], speed, headingDeg, gravity);
    all += energy;
    wave.push({ omega, variance: energy });
    const squares = squaredMotion(table, headingDeg, sea.omega[i]);
    if (!squares) continue;
    covered += energy;
    squares.forEach((square, mode) => {
      if (isHeld(mode, omega)) modes[mode].push({ omega, variance: energy * square });
    });
  }
  return { modes, wave, covered: all ? covered / all : 0 };
}

// |RAO|² of the six modes; between headings the squares are interpolated, as phases differ.
function squaredMotion(table, headingDeg, omega) {
  const beside = table.headingsDeg ? besides(table.headingsDeg, headingDeg)
    : { left: 0, right: 0, share: 0 };
  if (!beside) return null;
  const [a, b] = [beside.left, beside.right].map((heading) =>
    motionAt(table.omega, table.values, heading, omega));
  if (!a) return null;
  return Array.from({ length: 6 }, (_, mode) => {
    const square = (motion) => motion[2 * mode] ** 2 + motion[2 * mode + 1] ** 2;
    return (1 - beside.share) * square(a) + beside.share * square(b);
  });
}
