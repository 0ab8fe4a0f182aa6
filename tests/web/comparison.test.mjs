// A run beside its prediction, and curves as they are drawn.
import assert from "node:assert/strict";
import { test } from "node:test";
import { compare, endOfEnergy, predictionOf, rangeOf, RESPONSES, slowLimit, stepOf }
  from "../../demos/report_page/web/analysis/comparison.js";
import { abscissaAt, ascendingParts, sortedPoints, unwrapped }
  from "../../demos/report_page/web/analysis/curves.js";
import { encounter, GRAVITY } from "../../demos/report_page/web/analysis/sea.js";

const near = (value, wanted, tolerance) => assert.ok(Math.abs(value - wanted) <= tolerance,
  `${value} is not ${wanted} within ${tolerance}`);

const OMEGA = Array.from({ length: 60 }, (_, i) => 0.2 + 0.03 * i);
const PITCH = 0.03; // rad per m, at every frequency
const TABLE = OMEGA.flatMap(() => [0, 0, 0, 0, 0.6, 0, 0, 0, PITCH, 0, 0, 0]);

/** A run of 40 head waves whose ship does what the RAOs say, and drifts along x. */
function linearRun(speed = 6) {
  const omega = Array.from({ length: 40 }, (_, i) => 0.5 + 0.02 * i + 0.003 * Math.sin(9 * i));
  const sea = { omega, amplitude: omega.map(() => 0.3), phase: omega.map((_, i) => 2.4 * i * i),
    heading: omega.map(() => Math.PI), tp: 8, ramp: 20 };
  const t = Float64Array.from({ length: 60000 }, (_, i) => 0.1 * i);
  const wave = t.map((time) => omega.reduce((sum, w, i) =>
    sum + 0.3 * Math.cos(encounter(w, speed, 180) * time + sea.phase[i]), 0));
  const columns = { t, wave, z: wave.map((zeta) => 1.3 + 0.6 * zeta),
    pitch_deg: wave.map((zeta) => zeta * PITCH * 180 / Math.PI),
    x: wave.map((zeta, i) => 0.6 * t[i] + 4 * Math.sin(0.02 * t[i]) + 0 * zeta) };
  return { sea, speed, mean: "free", gravity: GRAVITY, linear: { omega: OMEGA, values: TABLE },
    column: (name) => ({ values: columns[name] }) };
}

const responseOf = (column) => RESPONSES.find((response) => response.column === column);

test("a ship that does what linear theory says lies on the prediction", () => {
  const run = linearRun(), prediction = predictionOf(run, { raos: [], ship: {} });
  const t = run.column("t").values, range = rangeOf(t, run.sea.ramp);
  for (const column of ["wave", "z", "pitch_deg"]) {
    const result = compare(responseOf(column), run.column(column).values, range, stepOf(t),
      { prediction, period: 8 });
    near(result.significant / result.predictedSignificant, 1, 0.01);
    near(result.period / result.predictedPeriod, 1, 0.03);
    const top = Math.max(...result.predictedDensity);
    // The components beat with each other within a segment; the average leaves some of it.
    result.spectrum.density.forEach((value, k) =>
      near(value / top, result.predictedDensity[k] / top, 0.12));
  }
});

test("slow drift is left out of surge", () => {
  const run = linearRun(), prediction = predictionOf(run, { raos: [], ship: {} });
  near(slowLimit(prediction), 0.6 * encounter(0.5, 6, 180), 0.02);
  const t = run.column("t").values;
  const result = compare(responseOf("x"), run.column("x").values, rangeOf(t, 20), stepOf(t),
    { prediction, period: 8 });
  assert.ok(result.significant < 0.05, `${result.significant}`);
  assert.equal(slowLimit(null), 0);
});

test("bodies and calm water have no prediction; seas of many directions use all headings", () => {
  const run = linearRun();
  assert.equal(predictionOf({ ...run, sea: null }, { raos: [] }), null);
  assert.equal(predictionOf({ ...run, body: { size: [1, 1, 1] } }, { raos: [] }), null);
  const spread = { ...run, sea: { ...run.sea,
    heading: run.sea.heading.map((beta, i) => beta - 0.01 * i) } };
  const rao = { speed: 6, free: true, headingsDeg: [0, 180], omega: OMEGA,
    values: [...TABLE, ...TABLE] };
  const page = { raos: [rao], ship: { gravity: GRAVITY } };
  assert.match(predictionOf(spread, page).words, /own direction/);
  assert.match(predictionOf(spread, { raos: [], ship: {} }).words, /main direction/);
});

test("a record with a nan has no spectrum", () => {
  const values = Float64Array.from({ length: 500 }, (_, i) => (i === 300 ? NaN : i % 7));
  const options = { prediction: null, period: 3 };
  assert.equal(compare(responseOf("z"), values, [0, 500], 0.1, options), null);
  assert.ok(compare(responseOf("z"), values, [0, 300], 0.1, options).significant > 0);
});

test("times must have equal steps", () => {
  near(stepOf([0, 0.5, 1, 1.5]), 0.5, 1e-12);
  assert.equal(stepOf([0, 0.5, 1.5, 2.5]), 0);
  assert.deepEqual(rangeOf([0, 1, 2, 3, 4], 1), [2, 5]);
  assert.deepEqual(rangeOf([0, 1, 2, 3, 4], 1, { from: 1, to: 3 }), [1, 4]);
  assert.equal(endOfEnergy([0, 1, 2, 3], [1, 5, 5, 0]), 2);
});

test("over ω_e a following sea's curve is cut where it turns round", () => {
  const about = { speed: 10, headingDeg: 0, gravity: GRAVITY, length: 100 };
  const x = OMEGA.map((omega) => abscissaAt("encounter", omega, about));
  const parts = ascendingParts(x, OMEGA);
  assert.equal(parts.length, 3);
  for (const part of parts) {
    for (let i = 1; i < part.x.length; ++i) assert.ok(part.x[i] > part.x[i - 1]);
  }
  const length = abscissaAt("length", Math.sqrt(2 * Math.PI * GRAVITY / 100), about);
  near(length, 1, 1e-12);
  assert.deepEqual(sortedPoints([3, 1, 2], ["c", "a", "b"]), { x: [1, 2, 3], y: ["a", "b", "c"] });
});

test("phases leave at ±180 and come back on the other side", () => {
  const parts = unwrapped({ x: [0, 1, 2, 3, 4], y: [150, 170, -170, null, 5] });
  assert.deepEqual(parts, [{ x: [0, 1, 1.5], y: [150, 170, 180] },
    { x: [1.5, 2], y: [-180, -170] }, { x: [4], y: [5] }]);
});
