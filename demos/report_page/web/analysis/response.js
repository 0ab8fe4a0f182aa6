// What a ship does in a sea, from its RAOs: motion, velocity and acceleration of a point, their
// variance over headings. RAOs are complex amplitudes per metre of the wave's at G, rotations in
// rad/m, for e^{+iωt}; axes x forward, y to port, z up, points are given from G. Pure.
import { cosineSquared, encounter, isHeld, trapezoid } from "./sea.js";

const QUARTER = Math.PI / 180;

/**
 * Quantities of a point. `of` gives the weights of the six modes, and `wave` the share of the
 * wave's own elevation at the point; `rate` is the number of derivatives over time.
 * Transverse acceleration is what is felt aboard: roll brings in a share of gravity.
 */
export const QUANTITIES = [
  { key: "vertical", name: "vertical motion", unit: "m", of: vertical, rate: 0 },
  { key: "vertical-velocity", name: "vertical velocity", unit: "m/s", of: vertical, rate: 1 },
  { key: "vertical-acceleration", name: "vertical acceleration", unit: "m/s²", of: vertical,
    rate: 2 },
  { key: "transverse", name: "transverse motion", unit: "m", of: transverse, rate: 0 },
  { key: "transverse-velocity", name: "transverse velocity", unit: "m/s", of: transverse, rate: 1 },
  { key: "transverse-acceleration", name: "transverse acceleration, felt", unit: "m/s²",
    of: transverse, rate: 2, gravity: 3 },
  { key: "lengthwise", name: "lengthwise motion", unit: "m", of: lengthwise, rate: 0 },
  { key: "lengthwise-acceleration", name: "lengthwise acceleration, felt", unit: "m/s²",
    of: lengthwise, rate: 2, gravity: 4 },
  { key: "relative", name: "motion relative to the undisturbed wave", unit: "m", of: vertical,
    rate: 0, wave: -1 },
  { key: "roll", name: "roll", unit: "°", of: () => [0, 0, 0, 1 / QUARTER, 0, 0], rate: 0,
    anywhere: true },
  { key: "pitch", name: "pitch", unit: "°", of: () => [0, 0, 0, 0, 1 / QUARTER, 0], rate: 0,
    anywhere: true },
];

function lengthwise([, y, z]) {
  return [1, 0, 0, 0, z, -y];
}
function transverse([x, , z]) {
  return [0, 1, 0, -z, 0, x];
}
function vertical([x, y]) {
  return [0, 0, 1, y, -x, 0];
}

/** The quantity of a key. */
export const quantityOf = (key) => QUANTITIES.find((quantity) => quantity.key === key);

/**
 * Complex amplitude [re, im] per metre of wave, of a quantity at a point, in a regular wave; surge,
 * sway and yaw are left out where linear theory has none.
 * @param motion 12 numbers: re and im of the six modes
 * @param wave {omega, omegaE, headingDeg, gravity}
 */
export function transfer(quantity, point, motion, { omega, omegaE, headingDeg, gravity }) {
  const weights = quantity.of(point);
  let re = 0, im = 0;
  for (let mode = 0; mode < 6; ++mode) {
    if (!isHeld(mode, omegaE)) continue;
    re += weights[mode] * motion[2 * mode];
    im += weights[mode] * motion[2 * mode + 1];
  }
  if (quantity.wave) {
    const beta = headingDeg * QUARTER, k = omega * omega / gravity;
    const phase = k * (point[0] * Math.cos(beta) - point[1] * Math.sin(beta));
    re += quantity.wave * Math.cos(phase);
    im -= quantity.wave * Math.sin(phase);
  }
  for (let i = 0; i < quantity.rate; ++i) [re, im] = [-omegaE * im, omegaE * re];
  if (quantity.gravity) {
    // Gravity along the ship's own axes: +g·roll athwart (port up), −g·pitch along (bow down).
    const share = quantity.gravity === 3 ? gravity : -gravity;
    re += share * motion[2 * quantity.gravity];
    im += share * motion[2 * quantity.gravity + 1];
  }
  return [re, im];
}

/** RAOs of a heading at `parts` times as many frequencies, linear in between. */
export function refined(omega, values, heading, parts = 4) {
  const n = omega.length, count = (n - 1) * parts + 1;
  const fine = { omega: new Float64Array(count), motions: new Float64Array(count * 12) };
  for (let i = 0; i < count; ++i) {
    const left = Math.min(Math.floor(i / parts), Math.max(0, n - 2)), share = i / parts - left;
    const right = Math.min(left + 1, n - 1);
    fine.omega[i] = omega[left] + share * (omega[right] - omega[left]);
    const a = (heading * n + left) * 12, b = (heading * n + right) * 12;
    for (let j = 0; j < 12; ++j) {
      fine.motions[12 * i + j] = (1 - share) * values[a + j] + share * values[b + j];
    }
  }
  return fine;
}

// A ship with port and starboard alike answers waves from the other side mirrored.
function mirrored(motions) {
  return motions.map((value, i) => (Math.floor((i % 12) / 2) % 2 ? -value : value));
}

/** RAOs of all headings round the circle: those of 0 to 180 degrees and their mirror images. */
export function allRound({ headingsDeg, omega, values }, symmetric) {
  const found = new Map();
  headingsDeg.forEach((headingDeg, i) => {
    const fine = refined(omega, values, i);
    const circle = ((headingDeg % 360) + 360) % 360;
    found.set(circle, { headingDeg: circle, ...fine });
    const other = (360 - circle) % 360;
    if (symmetric && !found.has(other)) {
      found.set(other, { headingDeg: other, omega: fine.omega, motions: mirrored(fine.motions) });
    }
  });
  return [...found.values()].sort((a, b) => a.headingDeg - b.headingDeg);
}

/** Variance of a quantity in a long-crested sea of spectrum S from one of `allRound`. */
export function variance(direction, quantity, point, spectrum, speed, gravity) {
  const { headingDeg, omega, motions } = direction;
  const weights = trapezoid(omega);
  let sum = 0;
  for (let i = 0; i < omega.length; ++i) {
    const omegaE = encounter(omega[i], speed, headingDeg, gravity);
    const motion = motions.subarray(12 * i, 12 * i + 12);
    const [re, im] = transfer(quantity, point, motion,
      { omega: omega[i], omegaE, headingDeg, gravity });
    sum += (re * re + im * im) * spectrum(omega[i]) * weights[i];
  }
  return sum;
}

/** Variances over headings of a sea with short crests: cos² about each heading. */
export function spread(variances, stepDeg) {
  const n = variances.length;
  return variances.map((_, i) => cosineSquared(stepDeg).reduce((sum, { steps, weight }) =>
    sum + weight * variances[(i + steps + n) % n], 0));
}

/** Are these headings a whole circle of equal steps? The step [deg], or 0. */
export function circleStep(headings) {
  const step = 360 / headings.length;
  const whole = headings.length > 2
    && headings.every((at, i) => Math.abs(at - i * step) < 1e-6);
  return whole ? step : 0;
}
