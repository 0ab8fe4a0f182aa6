// The curves of the report's figures for a hull, from the page's data, in the report's units.
// Modes count from 0. What the data has not is null. Pure.
import { stillWaterLoad, submerged } from "./buoyancy.js";
import { REPORT } from "./axes.js";
import { encounter, SLOWEST } from "./sea.js";

/** The report's speed for a ship of this length [m/s]: 20 knots for its own, the Froude number. */
export const reportSpeed = (ship) => REPORT.speed * Math.sqrt(ship.length / REPORT.length
  * ship.gravity / 9.80665);

/** How much slower or faster a hull of this length moves than the report's: time over time. */
export const timeScale = (ship) => Math.sqrt(ship.length / REPORT.length);

/** Is it the report's own ship, by its dimensions within a hundredth? */
export const isReportShip = (ship) => ["length", "beam", "draught"].every((key) =>
  Math.abs(ship[key] / REPORT[key] - 1) < 0.01);

const inertia = ({ mass, gyradii }, mode) => mass * (mode > 2 ? gyradii[mode - 3] ** 2 : 1);

/** Unit of damping and of U ∂A/∂x: Δr²√(g/L), r = 1 m for translations. */
export const dampingUnit = (ship, mode) => inertia(ship, mode)
  * Math.sqrt(ship.gravity / ship.length);

/** Unit of retardation functions: Δr²g/L. */
export const kernelUnit = (ship, mode) => inertia(ship, mode) * ship.gravity / ship.length;

/** Figures 15 to 20: {x: ω, y: B_jj}. */
export function dampingCurve({ ship, coefficients }, mode) {
  const B = coefficients?.B?.[`${mode + 1}${mode + 1}`];
  if (!B) return null;
  return { x: coefficients.omega, y: B.map((value) => value / dampingUnit(ship, mode)) };
}

// Tuck's theorem: ∂A/∂x = T A, of T only T₅₃ = 1 and T₆₂ = −1: [pair of A, sign] by mode.
const TUCK = { 4: ["35", 1], 5: ["26", -1] };

/** Does Tuck's theorem give this mode's diagonal ∂A/∂x anything but 0? */
export const hasSlope = (mode) => mode in TUCK;

/** Figures 19 and 20: {x: ω, y: U ∂A_jj/∂x} by Tuck's theorem; null for other modes. */
export function slopeCurve({ ship, coefficients }, mode) {
  const [pair, sign] = TUCK[mode] ?? [];
  const A = coefficients?.A?.[pair];
  if (!A) return null;
  const scale = sign * reportSpeed(ship) / dampingUnit(ship, mode);
  return { x: coefficients.omega, y: A.map((value) => value * scale) };
}

/** Index of the heading next to `wanted` [deg]; null if none is within 8°. */
export function headingNear(headingsDeg, wanted) {
  let best = null;
  headingsDeg.forEach((heading, i) => {
    const away = Math.abs(heading - wanted);
    if (away <= 8 && (best === null || away < Math.abs(headingsDeg[best] - wanted))) best = i;
  });
  return best;
}

const sizeAt = (values, at) => Math.hypot(values[at], values[at + 1]);

/** Figures 21 and 22, at rest: {x: ω, y: |F_j|} in Δga/L or Δga. */
export function excitationCurve({ ship, excitation }, heading, mode) {
  const { omega, froudeKrylov, diffraction } = excitation;
  const unit = ship.mass * ship.gravity / (mode > 2 ? 1 : ship.length);
  const y = omega.map((_, i) => {
    const at = ((heading * omega.length + i) * 6 + mode) * 2;
    return Math.hypot(froudeKrylov[at] + diffraction[at],
      froudeKrylov[at + 1] + diffraction[at + 1]) / unit;
  });
  return { x: omega, y };
}

const alike = (run, { speed, free }) => run.kind === "sweep" && run.sweep
  && (run.mean === "free") === free && Math.abs(run.speed - speed) < 1e-3;

/**
 * RAOs of the speed next to the report's; of those first the kind, free or fixed course, that a
 * sweep has, else a fixed course's. null of none.
 */
export function raosNear({ ship, raos, runs = [] }) {
  const wanted = reportSpeed(ship);
  const swept = (rao) => runs.some((run) => alike(run, rao));
  const rank = (rao) => [Math.abs(rao.speed - wanted), swept(rao) ? 0 : 1, rao.free ? 1 : 0];
  return [...raos].sort((a, b) => {
    const [p, q] = [rank(a), rank(b)];
    return p[0] - q[0] || p[1] - q[1] || p[2] - q[2];
  })[0] ?? null;
}

/** Figures 31 and 32: points {x: ω, y: |η_j|} of the sweeps at the RAOs' speed and this heading. */
export function sweepPoints({ ship, runs = [] }, rao, headingDeg, mode) {
  const points = runs.filter((run) => alike(run, rao)
    && Math.abs(run.headingDeg - headingDeg) < 0.1)
    .flatMap(({ sweep }) => sweep.omega.map((omega, i) => ({ omega, i, sweep })))
    .filter(({ i, sweep }) => sweep.mode[i] === mode + 1 && Math.abs(sweep.omegaE[i]) >= SLOWEST
      && sweep.timeAmplitude[i] !== null && Number.isFinite(sweep.timeAmplitude[i]))
    .map(({ omega, i, sweep }) => [omega, sweep.timeAmplitude[i]
      / (mode > 2 ? omega * omega / ship.gravity : 1)]).sort((p, q) => p[0] - q[0]);
  return points.length ? { x: points.map(([x]) => x), y: points.map(([, y]) => y) } : null;
}

/** Has the ship roll damping or yaw stiffness of its own, as the report's has in Figures 31, 32? */
export const isDamped = ({ particulars }, free) => (particulars ?? []).some(([name, value]) =>
  (name === "roll_damping" || (!free && name === "yaw_stiffness")) && value > 0);

/** Figures 23 and 24: {x: ω, y: |η_j|} in a or ka; null where |ω_e| < 0.1 rad/s. */
export function motionCurve({ ship }, rao, heading, mode) {
  const { omega, values, speed } = rao, headingDeg = rao.headingsDeg[heading];
  const y = omega.map((w, i) => {
    if (Math.abs(encounter(w, speed, headingDeg, ship.gravity)) < SLOWEST) return null;
    const wave = mode > 2 ? w * w / ship.gravity : 1;
    return sizeAt(values, ((heading * omega.length + i) * 6 + mode) * 2) / wave;
  });
  return { x: omega, y };
}

/** Figures 25 to 30: {x: τ, y: K_jj} up to `last` seconds. */
export function kernelCurve({ ship, retardation }, mode, last) {
  const K = retardation?.K?.[`${mode + 1}${mode + 1}`];
  if (!K) return null;
  const x = retardation.tau.filter((tau) => tau <= last);
  return { x, y: x.map((_, i) => K[i] / kernelUnit(ship, mode)) };
}

/** ∫ f(ω) cos ωτ dω of a function that is straight between its points: exact for every τ. */
export function cosineIntegral(omega, f, tau) {
  let sum = 0;
  for (let i = 1; i < omega.length; ++i) {
    const width = omega[i] - omega[i - 1], slope = (f[i] - f[i - 1]) / width;
    const [sa, sb] = [Math.sin(omega[i - 1] * tau), Math.sin(omega[i] * tau)];
    const [ca, cb] = [Math.cos(omega[i - 1] * tau), Math.cos(omega[i] * tau)];
    if (tau * width < 1e-4) {
      sum += width * (f[i - 1] * ca + f[i] * cb) / 2;
      continue;
    }
    sum += (f[i] * sb - f[i - 1] * sa) / tau + slope * (cb - ca) / (tau * tau);
  }
  return sum;
}

/**
 * Figures 29 and 30: {x: τ, y: U² K^UU_jj} by Tuck's theorem, (2/π)∫(B/ω²) cos ωτ dω with B₃₃ for
 * pitch and B₂₂ for yaw; null for other modes. B/ω² vanishes with ω.
 */
export function squaredKernelCurve({ ship, coefficients }, mode, tau) {
  const B = coefficients?.B?.[{ 4: "33", 5: "22" }[mode]];
  if (!B || !tau?.length) return null;
  const omega = [0, ...coefficients.omega];
  const f = [0, ...B.map((value, i) => value / coefficients.omega[i] ** 2)];
  const scale = 2 / Math.PI * reportSpeed(ship) ** 2 / kernelUnit(ship, mode);
  return { x: tau, y: tau.map((t) => scale * cosineIntegral(omega, f, t)) };
}

const range = (first, last, steps) =>
  Array.from({ length: steps + 1 }, (_, i) => first + (last - first) * i / steps);

const hydrostatic = (ship, name) => ship.hydrostatics?.find(([key]) => key === name)?.[1];

/**
 * Figures 34 to 36: {x, y, linear} of kind "heave" [m], "roll" or "pitch" [deg]; the force is less
 * the weight, over Δg; arms [m] are moments over Δg. `linear` is null without hydrostatics.
 */
export function buoyancyCurve({ ship }, kind) {
  const { points, faces } = ship.hull, rest = ship.cog[2];
  const [x, key, stiffness] = {
    heave: [range(-8, 6, 56).map((value) => value * ship.length / REPORT.length), "height", "C33"],
    roll: [range(-90, 90, 72), "roll", "C44"],
    pitch: [range(-10, 10, 80), "pitch", "C55"],
  }[kind];
  const volume = ship.mass / ship.density;
  const unit = kind === "heave" ? 1 : Math.PI / 180;
  const y = x.map((value) => {
    const pose = { height: rest };
    pose[key] = (kind === "heave" ? rest : 0) + value * unit;
    return stillWaterLoad(points, faces, pose)[kind] / volume - (kind === "heave" ? 1 : 0);
  });
  const C = hydrostatic(ship, stiffness);
  return { x, y, linear: Number.isFinite(C)
    ? x.map((value) => -C * value * unit / (ship.mass * ship.gravity)) : null };
}

/** Table 2: volume, LCB aft of the waterline's fore end, CB above calm water, wetted area. */
export function hydrostaticsRow({ ship }) {
  const points = Float64Array.from(ship.hull.points, (value, i) =>
    value + (i % 3 === 2 ? ship.cog[2] : 0));
  const { volume, centre, waterline } = submerged(points, ship.hull.faces);
  return { volume: hydrostatic(ship, "volume") ?? volume,
    lcb: centre && waterline ? waterline[1] - centre[0] : NaN,
    vcb: centre ? centre[2] : NaN,
    area: hydrostatic(ship, "wetted_area") ?? NaN };
}

/**
 * Least and greatest of a curve and the abscissa of what is farthest from 0; null of an empty one.
 * @param last  what lies beyond is left out
 */
export function extremes({ x, y }, last = Infinity) {
  let found = null;
  y.forEach((value, i) => {
    if (value === null || !Number.isFinite(value) || x[i] > last) return;
    found ??= { least: value, most: value, value, at: x[i] };
    found.least = Math.min(found.least, value);
    found.most = Math.max(found.most, value);
    if (Math.abs(value) > Math.abs(found.value)) Object.assign(found, { value, at: x[i] });
  });
  return found;
}

/** Does a curve with these extremes stay on the axis [lower, upper]? */
export function staysOn({ least, most }, [lower, upper]) {
  const round = 1e-9 * (upper - lower);
  return least >= lower - round && most <= upper + round;
}
