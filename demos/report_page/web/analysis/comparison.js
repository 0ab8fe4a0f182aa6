// A run beside its linear prediction: which RAOs apply, the spectra and significant values. Pure.
import { predict } from "./prediction.js";
import { blockMeans, densityOfLines, momentOf, momentOfLines, scatter, segmentLength, welch }
  from "./spectra.js";
import { crossingPeriod, firstFrom, statistics, withoutTrend } from "./statistics.js";

const DEGREES = 180 / Math.PI;

/**
 * Columns that have a spectrum; `mode` counts from 0, the wave has none. Nothing holds what drifts:
 * of that only what is as quick as the waves is compared.
 */
export const RESPONSES = [
  { column: "wave", name: "wave at the ship", unit: "m", mode: null, scale: 1 },
  { column: "x", name: "surge", unit: "m", mode: 0, scale: 1, drifts: true },
  { column: "y", name: "sway", unit: "m", mode: 1, scale: 1, drifts: true },
  { column: "z", name: "heave", unit: "m", mode: 2, scale: 1 },
  { column: "roll_deg", name: "roll", unit: "°", mode: 3, scale: DEGREES },
  { column: "pitch_deg", name: "pitch", unit: "°", mode: 4, scale: DEGREES },
  { column: "yaw_deg", name: "yaw", unit: "°", mode: 5, scale: DEGREES,
    drifts: true },
];

const sameDirection = (sea) => sea.heading.every((beta) => Math.abs(beta - sea.heading[0]) < 1e-9);

/**
 * The prediction of a run and in words what it rests on: {modes, wave, covered, words}. Waves of
 * many directions need the RAOs of all headings; a run's own are those of its main heading.
 */
export function predictionOf(run, page) {
  const { sea } = run;
  if (!sea?.omega?.length || run.body || run.hull) return null;
  const gravity = run.gravity ?? page.ship.gravity;
  const table = page.raos.find(({ speed, free }) => free === (run.mean === "free")
    && Math.abs(speed - run.speed) < 0.01 * Math.max(1, run.speed));
  if (!sameDirection(sea) && table) {
    return { ...predict(sea, table, run.speed, gravity),
      words: "each wave from its own direction" };
  }
  if (!run.linear?.omega?.length) return null;
  return { ...predict(sea, run.linear, run.speed, gravity),
    words: sameDirection(sea) ? "" : "every wave taken as from the main direction" };
}

/** Are the times equally spaced, as a spectrum needs them? The step, or 0. */
export function stepOf(t) {
  const n = t.length;
  if (n < 3) return 0;
  const step = (t[n - 1] - t[0]) / (n - 1);
  return Math.abs(t[1] - t[0] - step) < 1e-3 * step ? step : 0;
}

/** Indexes [begin, end) after the ramp and a tenth of the run, or of a range of time. */
export function rangeOf(t, ramp, window = null) {
  const last = t[t.length - 1];
  const from = window ? window.from : Math.min(t[0] + (ramp ?? 0) + 0.1 * (last - t[0]), last);
  return [firstFrom(t, from), window ? firstFrom(t, window.to + 1e-9) : t.length];
}

/** 0.6 of the ω_e below which a hundredth of the sea's energy lies; 0 without a sea. */
export function slowLimit(prediction) {
  const lines = (prediction?.wave ?? []).map(({ omega, variance }) =>
    ({ omega: Math.abs(omega), variance })).sort((a, b) => a.omega - b.omega);
  let sum = 0;
  const whole = momentOfLines(lines, 0);
  for (const { omega, variance } of lines) {
    sum += variance;
    if (sum > 0.01 * whole) return 0.6 * omega;
  }
  return 0;
}

const tau = 2 * Math.PI;

/**
 * Measured and predicted of one response over [begin, end): spectra, significant amplitudes, mean
 * periods. `period` [s] says how long a segment must be. Of a record with a nan there is null.
 */
export function compare(response, values, [begin, end], dt, { prediction, period }) {
  if (values.subarray(begin, end).some(Number.isNaN)) return null;
  const record = withoutTrend(values, begin, end);
  const block = Math.max(1, Math.floor(period / 60 / dt));
  const short = blockMeans(record, block), step = dt * block;
  const spectrum = welch(short, step, segmentLength(short.length, step, period));
  const lines = prediction && (response.mode === null ? prediction.wave
    : prediction.modes[response.mode]);
  const least = response.drifts && spectrum ? slowLimit(prediction) : 0;
  const scaled = lines?.filter(({ omega }) => Math.abs(omega) >= least)
    .map(({ omega, variance }) => ({ omega, variance: variance * response.scale ** 2 }));
  const m0 = scaled ? momentOfLines(scaled, 0) : NaN;
  const measured = least ? [momentOf(spectrum, 0, least), momentOf(spectrum, 2, least)] : null;
  return {
    spectrum, least,
    predictedDensity: spectrum && scaled
      ? densityOfLines(scaled, spectrum.omega, spectrum.duration) : null,
    significant: 2 * (measured ? Math.sqrt(measured[0]) : statistics(record).deviation),
    predictedSignificant: 2 * Math.sqrt(m0),
    scatter: spectrum ? scatter(spectrum, record.length * dt, least) : NaN,
    period: measured ? tau * Math.sqrt(measured[0] / measured[1]) : crossingPeriod(record, dt),
    predictedPeriod: tau * Math.sqrt(m0 / (scaled ? momentOfLines(scaled, 2) : NaN)),
  };
}

/** ω beyond which a density has less than `share` of its integral. */
export function endOfEnergy(omega, density, share = 0.01) {
  const whole = density.reduce((sum, value) => sum + value, 0);
  let rest = 0;
  for (let i = density.length - 1; i > 0; --i) {
    rest += density[i];
    if (rest > share * whole) return omega[i];
  }
  return omega.at(-1);
}
