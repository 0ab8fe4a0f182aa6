// Spectra of records, and of sums of sines as such a record would show them. Densities are
// one-sided, over ω [rad/s]: ∫ S dω from 0 is the variance. Pure.
import { fft } from "./fft.js";
import { withoutTrend } from "./statistics.js";

/** Samples of a segment: a power of two with about `segments` half-overlapped ones in n samples. */
export function segmentLength(n, segments = 9) {
  const most = 2 * n / (segments + 1);
  return most < 16 ? 0 : 2 ** Math.floor(Math.log2(most));
}

/**
 * Welch's method: means over half-overlapped segments under Hann's window, the trend of the whole
 * taken off before. {omega, density, duration of a segment [s], segments}
 */
export function welch(values, dt, length = segmentLength(values.length)) {
  if (!length || length > values.length) return null;
  const record = withoutTrend(values);
  const window = Float64Array.from({ length }, (_, i) =>
    0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / length));
  const energy = window.reduce((sum, w) => sum + w * w, 0);
  const half = length / 2, density = new Float64Array(half + 1);
  const segments = Math.floor((record.length - length) / half) + 1;
  const re = new Float64Array(length), im = new Float64Array(length);
  for (let segment = 0; segment < segments; ++segment) {
    for (let i = 0; i < length; ++i) re[i] = window[i] * record[segment * half + i];
    im.fill(0);
    fft(re, im);
    for (let k = 0; k <= half; ++k) density[k] += re[k] * re[k] + im[k] * im[k];
  }
  // Σ density Δω is the variance with Δω = 2π/(N Δt); both signs of ω count but at both ends.
  for (let k = 0; k <= half; ++k) {
    density[k] *= (k === 0 || k === half ? 1 : 2) * dt / (2 * Math.PI * energy * segments);
  }
  const step = 2 * Math.PI / (length * dt);
  const omega = Float64Array.from({ length: half + 1 }, (_, k) => k * step);
  return { omega, density, duration: length * dt, segments };
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
