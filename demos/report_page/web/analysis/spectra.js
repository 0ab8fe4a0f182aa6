// Spectra of records, and of sums of sines as such a record would show them. Densities are
// one-sided, over ω [rad/s]: ∫ S dω from 0 is the variance. Pure.
import { fft } from "./fft.js";
import { withoutTrend } from "./statistics.js";

/** Means of each `n` samples: a shorter record for what is slow beside its steps. */
export function blockMeans(values, n) {
  if (n < 2) return values;
  return Float64Array.from({ length: Math.floor(values.length / n) }, (_, i) => {
    let sum = 0;
    for (let j = i * n; j < (i + 1) * n; ++j) sum += values[j];
    return sum / n;
  });
}

/**
 * Samples of a segment: 12 periods, a fifth of the record if there is no period, and never more
 * than 2/5 of it, so that there are four half-overlapped ones to average over; 0 if that is too
 * short.
 */
export function segmentLength(n, dt, period) {
  const wanted = Math.round(12 * period / dt) || Math.floor(n / 5);
  const length = Math.min(wanted, Math.floor(n / 2.5));
  return length < 16 ? 0 : length;
}

/**
 * Welch's method: means over half-overlapped segments under Hann's window, the trend of the whole
 * taken off before; padded with zeros, so that the curve is smooth.
 * {omega, density, duration of a segment [s], segments}
 */
export function welch(values, dt, length) {
  if (!(length >= 16) || length > values.length) return null;
  const record = withoutTrend(values), size = 2 ** (Math.ceil(Math.log2(length)) + 1);
  const window = Float64Array.from({ length }, (_, i) =>
    0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / length));
  const energy = window.reduce((sum, w) => sum + w * w, 0);
  const hop = Math.floor(length / 2), half = size / 2, density = new Float64Array(half + 1);
  const segments = Math.floor((record.length - length) / hop) + 1;
  const re = new Float64Array(size), im = new Float64Array(size);
  for (let segment = 0; segment < segments; ++segment) {
    re.fill(0);
    im.fill(0);
    for (let i = 0; i < length; ++i) re[i] = window[i] * record[segment * hop + i];
    fft(re, im);
    for (let k = 0; k <= half; ++k) density[k] += re[k] * re[k] + im[k] * im[k];
  }
  // Σ density Δω is the variance with Δω = 2π/(N Δt); both signs of ω count but at both ends.
  for (let k = 0; k <= half; ++k) {
    density[k] *= (k === 0 || k === half ? 1 : 2) * dt / (2 * Math.PI * energy * segments);
  }
  const step = 2 * Math.PI / (size * dt);
  const omega = Float64Array.from({ length: half + 1 }, (_, k) => k * step);
  return { omega, density, duration: length * dt, segments };
}

/** m_n = ∫ ω^n S dω from `least` on. */
export function momentOf({ omega, density }, n, least = 0) {
  let sum = 0;
  for (let k = 0; k < omega.length; ++k) {
    if (omega[k] >= least) sum += omega[k] ** n * density[k];
  }
  return sum * omega[1];
}

/**
 * By how much the standard deviation of a record of `duration` scatters by chance, as a share of
 * it: half of that of the variance, √(2π ∫S² dω / T) / m0.
 */
export function scatter({ omega, density }, duration, least = 0) {
  let squares = 0;
  for (let k = 0; k < omega.length; ++k) {
    if (omega[k] >= least) squares += density[k] ** 2 * omega[1];
  }
  return 0.5 * Math.sqrt(2 * Math.PI * squares / duration) / momentOf({ omega, density }, 0, least);
}

const sinc = (x) => (Math.abs(x) < 1e-9 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x));

/** Power of Hann's window of `duration` at a distance Δω from a line; its integral is 1. */
export function windowPower(distance, duration) {
  const x = distance * duration / (2 * Math.PI);
  const amplitude = sinc(x) + 0.5 * sinc(x - 1) + 0.5 * sinc(x + 1);
  return amplitude * amplitude * duration / (3 * Math.PI);
}

/**
 * Density that Welch's method shows on average for lines [{omega, variance}], at the ω given: each
 * line as wide as the window makes it. Lines below 0 are folded back.
 */
export function densityOfLines(lines, omega, duration) {
  const reach = 8 * 2 * Math.PI / duration;
  return Float64Array.from(omega, (at) => {
    let sum = 0;
    for (const line of lines) {
      const away = Math.abs(line.omega) - at;
      if (Math.abs(away) < reach) sum += line.variance * windowPower(away, duration);
    }
    return sum;
  });
}

/** m_n = Σ |ω|^n variance of lines. */
export function momentOfLines(lines, n) {
  return lines.reduce((sum, { omega, variance }) => sum + Math.abs(omega) ** n * variance, 0);
}
