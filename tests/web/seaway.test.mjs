// The sea, the ship's answer to it, operability and righting levers against closed forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { cosineSquared, encounter, GRAVITY, jonswap, trapezoid }
  from "../../demos/report_page/web/analysis/sea.js";
import { allRound, circleStep, quantityOf, spread, transfer, variance }
  from "../../demos/report_page/web/analysis/response.js";
import { limitingHeights, shareOfHeadings }
  from "../../demos/report_page/web/analysis/operability.js";
import { predict } from "../../demos/report_page/web/analysis/prediction.js";
import { rightingFacts } from "../../demos/report_page/web/analysis/righting.js";

const near = (value, wanted, tolerance) => assert.ok(Math.abs(value - wanted) <= tolerance,
  `${value} is not ${wanted} within ${tolerance}`);

const HEADINGS = [0, 45, 90, 135, 180];
const OMEGA = Array.from({ length: 300 }, (_, i) => 0.2 + 0.01 * i);

/** RAOs by a formula (omega, heading in rad) -> six [re, im]. */
function table(formula, headingsDeg = HEADINGS, omega = OMEGA) {
  const values = headingsDeg.flatMap((heading) => omega.flatMap((w) =>
    formula(w, heading * Math.PI / 180).flat()));
  return { headingsDeg, omega, values: Float64Array.from(values) };
}

const follows = table(() => [[0, 0], [0, 0], [1, 0], [0, 0], [0, 0], [0, 0]]);
const waveFor = (omega, headingDeg, speed = 0) =>
  ({ omega, headingDeg, omegaE: encounter(omega, speed, headingDeg), gravity: GRAVITY });

test("JONSWAP has the height asked for: 4√m0 = Hs, at any γ", () => {
  for (const gamma of [1, 3.3, 7]) {
    const s = jonswap(3, 9, gamma);
    let m0 = 0;
    for (let w = 0.0005; w < 12; w += 0.001) m0 += 0.001 * s(w);
    near(4 * Math.sqrt(m0), 3, 0.003);
  }
  assert.equal(jonswap(3, 9, 3.3)(0), 0);
});

test("head waves are met faster, overtaken ones from behind", () => {
  near(encounter(1, 10, 180), 1 + 10 / GRAVITY, 1e-12);
  near(encounter(1.5, 10, 0), 1.5 - 22.5 / GRAVITY, 1e-12);
  near(encounter(1, 10, 90), 1, 1e-12);
});

test("a ship that follows the surface has the sea's own height on every heading", () => {
  const s = jonswap(2, 7, 3.3);
  for (const direction of allRound(follows, true)) {
    const m0 = variance(direction, quantityOf("vertical"), [0, 0, 0], s, 0, GRAVITY);
    near(4 * Math.sqrt(m0), 2, 0.01);
    const none = variance(direction, quantityOf("relative"), [0, 0, 0], s, 0, GRAVITY);
    near(none, 0, 1e-12);
  }
});

test("surge, sway and yaw are left out where waves are hardly met", () => {
  const all = new Float64Array(12).fill(1), slow = { ...waveFor(1, 0), omegaE: 0.05 };
  const real = (key) => transfer(quantityOf(key), [0, 0, 0], all, slow)[0];
  assert.equal(real("lengthwise"), 0);
  assert.equal(real("transverse"), 0);
  assert.equal(real("vertical"), 1);
});

test("velocity and acceleration are ω_e and ω_e² times the motion", () => {
  const motion = [0, 0, 0, 0, 0.8, 0.3, 0, 0, 0, 0, 0, 0], wave = waveFor(0.9, 180, 6);
  const size = (key) => Math.hypot(...transfer(quantityOf(key), [0, 0, 0], motion, wave));
  near(size("vertical-velocity"), wave.omegaE * size("vertical"), 1e-12);
  near(size("vertical-acceleration"), wave.omegaE ** 2 * size("vertical"), 1e-12);
});

test("points move by rotation: bow down lowers it, port up lifts port, yaw swings the bow", () => {
  const alone = (mode) => Array.from({ length: 12 }, (_, i) => (i === 2 * mode ? 1 : 0));
  const wave = waveFor(1, 90), at = [10, 2, 5];
  const real = (key, mode) => transfer(quantityOf(key), at, alone(mode), wave)[0];
  assert.equal(real("vertical", 4), -10);
  assert.equal(real("vertical", 3), 2);
  assert.equal(real("transverse", 5), 10);
  assert.equal(real("transverse", 3), -5);
  assert.equal(real("lengthwise", 4), 5);
  // Held still at a heel, an accelerometer shows g times the heel: slow waves, ω_e → 0.
  near(transfer(quantityOf("transverse-acceleration"), at, alone(3), waveFor(1e-6, 90))[0],
    GRAVITY, 1e-9);
  near(transfer(quantityOf("lengthwise-acceleration"), at, alone(4), waveFor(1e-6, 90))[0],
    -GRAVITY, 1e-9);
});

test("the wave at a point lags the wave at G where the waves come later", () => {
  const still = new Float64Array(12);
  const [re, im] = transfer(quantityOf("relative"), [20, 0, 0], still, waveFor(0.7, 0));
  near(Math.atan2(-im, -re), -0.49 * 20 / GRAVITY, 1e-12);
});

test("waves from the other side: odd modes change sign, port and starboard swap", () => {
  const skew = table((w, beta) => [[0, 0], [0.1, 0], [0.5, 0.1], [0.05 * Math.sin(beta), 0.01],
    [0, 0.02], [0, 0]]);
  const circle = allRound(skew, true);
  assert.deepEqual(circle.map(({ headingDeg }) => headingDeg),
    [0, 45, 90, 135, 180, 225, 270, 315]);
  assert.equal(circleStep(circle.map(({ headingDeg }) => headingDeg)), 45);
  assert.equal(circleStep(HEADINGS), 0);
  const s = jonswap(2, 7, 3.3);
  const of = (i, y) => variance(circle[i], quantityOf("vertical"), [3, y, 0], s, 4, GRAVITY);
  near(of(1, 4), of(7, -4), 1e-12);
  assert.ok(Math.abs(of(1, 4) - of(7, 4)) > 1e-3);
  assert.equal(allRound(skew, false).length, 5);
});

test("the polar plot of a known RAO: |cos β| spreads to (2 + cos 2β)/4 of its square", () => {
  const step = 5, n = 360 / step, angle = (i) => i * step * Math.PI / 180;
  const squares = Array.from({ length: n }, (_, i) => Math.cos(angle(i)) ** 2);
  // Mean of cos²(β + θ) under (2/π) cos²θ: ½ + ¼ cos 2β.
  spread(squares, step).forEach((value, i) =>
    near(value, 0.5 + 0.25 * Math.cos(2 * angle(i)), 1e-12));
  near(cosineSquared(15).reduce((sum, { weight }) => sum + weight, 0), 1, 1e-15);
});

test("trapezoid weights integrate a straight line", () => {
  const x = [0, 0.5, 2, 3];
  near(trapezoid(x).reduce((sum, weight, i) => sum + weight * x[i], 0), 4.5, 1e-12);
});

test("the height at which the first limit is reached, and the share of headings beyond", () => {
  const limiting = limitingHeights(
    [{ limit: 8, perMetre: [1, 4, 0] }, { limit: 3, perMetre: [1, 0.5, 1] }], [0, 90, 180]);
  assert.deepEqual(limiting.map(({ hs, by }) => [hs, by]), [[3, 1], [2, 0], [3, 1]]);
  assert.deepEqual(shareOfHeadings(limiting, [1, 2, 2.5, 3, 4]), [1, 1, 2 / 3, 2 / 3, 0]);
});

test("the prediction of a run is Σ |RAO|² a²/2 at the frequencies of encounter", () => {
  const half = table((w) => [[0, 0], [0, 0], [0.5 * w, 0], [0, 0], [0, 0.02], [0, 0]]);
  const sea = { omega: [0.5, 0.8, 9], amplitude: [1, 2, 1], heading: [Math.PI, -2.5, Math.PI] };
  const { modes, wave, covered } = predict(sea, half, 5, GRAVITY);
  near(modes[2][0].variance, 0.5 * 0.25 ** 2, 1e-12);
  near(modes[2][1].variance, 2 * 0.4 ** 2, 1e-12);
  near(modes[4][1].variance, 2 * 0.02 ** 2, 1e-12);
  near(modes[2][0].omega, encounter(0.5, 5, 180), 1e-12);
  near(covered, 2.5 / 3, 1e-12);
  assert.equal(wave.length, 3);
  assert.equal(modes[2].length, 2);
  const single = predict(sea, { omega: OMEGA, values: half.values.slice(0, OMEGA.length * 12) }, 5,
    GRAVITY);
  near(single.modes[2][1].variance, 2 * 0.4 ** 2, 1e-12);
});

test("GZ = a sin φ + b sin 2φ: slope, top and the angle at which it vanishes", () => {
  const heelDeg = Array.from({ length: 37 }, (_, i) => 5 * i);
  const lever = (heel) => 1.3 * Math.sin(heel) + 0.9 * Math.sin(2 * heel);
  const facts = rightingFacts(heelDeg, heelDeg.map((heel) => lever(heel * Math.PI / 180)));
  near(facts.gm, 3.1, 2e-3);
  // cos φ = −1.3/1.8 where it vanishes.
  near(facts.vanishingDeg, Math.acos(-1.3 / 1.8) * 180 / Math.PI, 0.2);
  let top = 0;
  for (let heel = 0; heel < Math.PI; heel += 1e-4) top = Math.max(top, lever(heel));
  near(facts.greatest.gz, top, 2e-3);
  assert.equal(rightingFacts([0, 10, 20], [0, 0.1, 0.2]).vanishingDeg, null);
});
