// Transforms, statistics and spectra against closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fft } from "../../demos/report_page/web/analysis/fft.js";
import { blockMeans, densityOfLines, momentOf, momentOfLines, scatter, segmentLength, welch,
  windowPower } from "../../demos/report_page/web/analysis/spectra.js";
import { crossingPeriod, firstFrom, statistics, withoutTrend }
  from "../../demos/report_page/web/analysis/statistics.js";

const near = (value, wanted, tolerance) => assert.ok(Math.abs(value - wanted) <= tolerance,
  `${value} is not ${wanted} within ${tolerance}`);
const sum = (values, f) => values.reduce((total, value, i) => total + f(value, i), 0);

test("Parseval: the transform keeps Σ|x|², and a sine lies at its place", () => {
  const n = 256, re = new Float64Array(n), im = new Float64Array(n);
  for (let i = 0; i < n; ++i) {
    re[i] = Math.cos(2 * Math.PI * 5 * i / n) + 0.3 * ((i * 37) % 11);
    im[i] = 0.2 * ((i * 17) % 7);
  }
  const before = sum(re, (x, i) => x * x + im[i] * im[i]);
  fft(re, im);
  near(sum(re, (x, i) => x * x + im[i] * im[i]) / n / before, 1, 1e-12);
  const cosine = Float64Array.from({ length: 64 }, (_, i) => Math.cos(2 * Math.PI * 3 * i / 64));
  const zero = new Float64Array(64);
  fft(cosine, zero);
  near(cosine[3], 32, 1e-12);
  near(cosine[61], 32, 1e-12);
  near(cosine[4], 0, 1e-12);
  assert.throws(() => fft(new Float64Array(3), new Float64Array(3)), /no power of two/);
});

test("statistics of a sine of amplitude a: a/√2, and its period", () => {
  const dt = 0.05, period = 7.3, values = Float64Array.from({ length: 20 * 146 }, (_, i) =>
    2 + 3 * Math.sin(2 * Math.PI * i * dt / period));
  const { mean, deviation, least, most } = statistics(values);
  near(mean, 2, 1e-9);
  near(deviation, 3 / Math.sqrt(2), 1e-9);
  near(least, -1, 1e-3);
  near(most, 5, 1e-3);
  near(crossingPeriod(values, dt), period, 1e-4);
  assert.ok(Number.isNaN(crossingPeriod([1, 2, 3], dt)));
  assert.equal(statistics([1, NaN, 3]).mean, 2);
});

test("the trend is taken off whole", () => {
  const rest = withoutTrend(Float64Array.from({ length: 100 }, (_, i) => 4 - 0.3 * i), 10, 90);
  near(Math.max(...rest.map(Math.abs)), 0, 1e-12);
});

test("firstFrom finds the first that is not less", () => {
  assert.deepEqual([0, 1, 1.5, 9].map((x) => firstFrom([0, 1, 2], x)), [0, 1, 2, 3]);
});

// Lines that lie between the frequencies of the transform, as real ones do.
const LINES = [{ omega: 0.63, a: 1.2 }, { omega: 0.91, a: 0.7 }, { omega: 1.38, a: 0.4 }];

function recordOf(lines, n, dt) {
  return Float64Array.from({ length: n }, (_, i) =>
    sum(lines, ({ omega, a }, j) => a * Math.cos(omega * i * dt + 1.7 * j)));
}

test("a sum of sines has m0 = Σ a²/2, in the record and in its spectrum", () => {
  const dt = 0.1, values = recordOf(LINES, 60000, dt);
  const m0 = sum(LINES, ({ a }) => a * a / 2);
  near(statistics(values).deviation ** 2 / m0, 1, 2e-3);
  const spectrum = welch(values, dt, 4000);
  near(momentOf(spectrum, 0) / m0, 1, 5e-3);
  near(momentOf(spectrum, 0, 0.77) / (0.7 ** 2 / 2 + 0.4 ** 2 / 2), 1, 5e-3);
});

test("Welch's method shows lines as the window does: the prediction lies on it", () => {
  const dt = 0.1, values = recordOf(LINES, 120000, dt);
  const measured = welch(values, dt, 1900);
  const lines = LINES.map(({ omega, a }) => ({ omega, variance: a * a / 2 }));
  const predicted = densityOfLines(lines, measured.omega, measured.duration);
  const top = Math.max(...predicted);
  measured.omega.forEach((_, k) => near(measured.density[k] / top, predicted[k] / top, 0.02));
  near(momentOfLines(lines, 2), sum(LINES, ({ omega, a }) => omega * omega * a * a / 2), 1e-12);
});

test("the window's power has the integral 1", () => {
  const duration = 100, step = 1e-3;
  let total = 0;
  for (let x = -1; x <= 1; x += step) total += windowPower(x, duration) * step;
  near(total, 1, 1e-4);
});

test("segments are 12 periods long, and shorter where the record is", () => {
  assert.equal(segmentLength(100000, 0.1, 10), 1200);
  assert.equal(segmentLength(1000, 0.1, 10), 400);
  assert.equal(segmentLength(30, 0.1, 10), 0);
  assert.equal(welch(new Float64Array(10), 0.1, 0), null);
  assert.deepEqual([...blockMeans([1, 3, 5, 7, 9], 2)], [2, 6]);
});

test("the scatter of a flat band of width Δω is ½ √(2π/(T Δω))", () => {
  const omega = Float64Array.from({ length: 1001 }, (_, i) => i * 0.001);
  const density = omega.map((w) => (w > 0.2995 && w < 0.6995 ? 5 : 0));
  near(scatter({ omega, density }, 600), 0.5 * Math.sqrt(2 * Math.PI / (600 * 0.4)), 1e-9);
});
