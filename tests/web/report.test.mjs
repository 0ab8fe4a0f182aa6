// The report's figures: still water on a box, cosine integrals and units in closed form.
import assert from "node:assert/strict";
import { test } from "node:test";
import { posed, stillWaterLoad, submerged }
  from "../../demos/report_page/web/analysis/buoyancy.js";
import { buoyancyCurve, cosineIntegral, dampingCurve, dampingUnit, excitationCurve, extremes,
  headingNear, hydrostaticsRow, isDamped, motionCurve, raosNear, reportSpeed, slopeCurve,
  squaredKernelCurve, staysOn, sweepPoints } from "../../demos/report_page/web/analysis/report.js";

const near = (value, wanted, tolerance) => assert.ok(Math.abs(value - wanted) <= tolerance,
  `${value} is not ${wanted} within ${tolerance}`);

/** Box of length l, beam b, height d about its middle, triangles counterclockwise from outside. */
function box(l, b, d) {
  const points = [];
  for (const x of [-1, 1]) for (const y of [-1, 1]) for (const z of [-1, 1]) {
    points.push(x * l / 2, y * b / 2, z * d / 2);
  }
  const quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4],
    [1, 5, 7, 3]];
  return { points: Float32Array.from(points),
    faces: Uint32Array.from(quads.flatMap(([p, q, r, s]) => [p, q, r, p, r, s])) };
}

const DRAUGHT = 2;
const { points, faces } = box(20, 6, 4);
const ship = { name: "box", length: 20, beam: 6, draught: DRAUGHT, mass: 1000 * 20 * 6 * DRAUGHT,
  density: 1000, gravity: 9.80665, cog: [0, 0, 0], gyradii: [2, 5, 5], hull: { points, faces },
  hydrostatics: [["C33", 1000 * 9.80665 * 120, "N/m"], ["wetted_area", 224, "m^2"]] };

test("a box that floats upright: volume, centre, waterline", () => {
  for (const draught of [0.5, 1, 2, 3.75]) {
    const { volume, centre, waterline } = submerged(posed(points, { height: 2 - draught }), faces);
    near(volume, 120 * draught, 1e-9);
    near(centre[0], 0, 1e-12);
    near(centre[2], -draught / 2, 1e-12);
    assert.deepEqual(waterline, [-10, 10]);
  }
});

test("under water all of it counts, above it nothing", () => {
  near(submerged(posed(points, { height: -50, roll: 1, pitch: 0.3 }), faces).volume, 480, 1e-9);
  assert.deepEqual(submerged(posed(points, { height: 3 }), faces),
    { volume: 0, centre: null, waterline: null });
});

test("a box that heels has the arm of wall-sided ships, until its deck is wet", () => {
  // GZ = sin φ (GM + BM tan²φ/2), with BM = b²/12T and GB = T/2.
  const bm = 36 / (12 * DRAUGHT), gm = bm - DRAUGHT / 2;
  for (const roll of [-0.4, 0.1, 0.3, 0.5]) {
    const load = stillWaterLoad(points, faces, { height: 0, roll });
    near(load.heave, 240, 1e-9);
    near(load.roll / 240, -Math.sin(roll) * (gm + bm * Math.tan(roll) ** 2 / 2), 1e-9);
    near(load.pitch, 0, 1e-9);
  }
});

test("a box that trims is wall-sided as well; bow down is positive and is lifted", () => {
  const bm = 400 / (12 * DRAUGHT), gm = bm - DRAUGHT / 2, pitch = 0.1;
  const load = stillWaterLoad(points, faces, { height: 0, pitch });
  near(load.pitch / 240, -Math.sin(pitch) * (gm + bm * Math.tan(pitch) ** 2 / 2), 1e-9);
});

test("Figure 34 of a box is straight between keel and deck, −1 above, 1 below", () => {
  const deep = { ship: { ...ship, length: 124.5 } };  // heave in metres from −8 to 6
  const { x, y, linear } = buoyancyCurve(deep, "heave");
  x.forEach((heave, i) => {
    near(y[i], Math.max(-1, Math.min(1, -heave / DRAUGHT)), 1e-9);
    near(linear[i], -heave / DRAUGHT, 1e-9);
  });
  assert.equal(buoyancyCurve(deep, "roll").linear, null);
});

test("Table 2 of a box", () => {
  const row = hydrostaticsRow({ ship });
  near(row.volume, 240, 1e-9);
  near(row.lcb, 10, 1e-9);
  near(row.vcb, -1, 1e-9);
  assert.equal(row.area, 224);
});

test("the cosine integral of a tent is its closed form", () => {
  for (const tau of [0, 1e-6, 0.3, 2, 40]) {
    const wanted = tau < 1e-3 ? 1 : 2 * (1 - Math.cos(tau)) * Math.cos(tau) / tau ** 2;
    near(cosineIntegral([0, 1, 2], [0, 1, 0], tau), wanted, 1e-9);
  }
});

test("U² K^UU of pitch: its second derivative over time is −U² K of heave", () => {
  const omega = Array.from({ length: 400 }, (_, i) => 0.02 * (i + 1));
  const B = { 33: omega.map((w) => w ** 3 * Math.exp(-w * w)) };
  const page = { ship, coefficients: { omega, B, A: {} } };
  const h = 0.05, [a, b, c] = squaredKernelCurve(page, 4, [1 - h, 1, 1 + h]).y;
  const K = 2 / Math.PI * cosineIntegral([0, ...omega], [0, ...B[33]], 1);
  const unit = ship.mass * 25 * ship.gravity / ship.length;
  const speed2 = reportSpeed(ship) ** 2;
  near((a - 2 * b + c) / h ** 2 * unit, -speed2 * K, 0.01 * speed2);
  assert.equal(squaredKernelCurve(page, 2, [0]), null);
});

test("units: Δr²√(g/L), and Tuck's theorem for pitch and yaw alone", () => {
  near(dampingUnit(ship, 2), 240e3 * Math.sqrt(9.80665 / 20), 1e-6);
  near(dampingUnit(ship, 3), 4 * dampingUnit(ship, 2), 1e-6);
  near(reportSpeed({ length: 124.5, gravity: 9.80665 }), 10.28889, 1e-5);
  const coefficients = { omega: [1], A: { 35: [3], 26: [2] }, B: { 33: [dampingUnit(ship, 2)] } };
  const page = { ship, coefficients };
  assert.deepEqual(dampingCurve(page, 2), { x: [1], y: [1] });
  assert.equal(dampingCurve(page, 0), null);
  near(slopeCurve(page, 4).y[0], 3 * reportSpeed(ship) / dampingUnit(ship, 4), 1e-12);
  near(slopeCurve(page, 5).y[0], -2 * reportSpeed(ship) / dampingUnit(ship, 5), 1e-12);
  assert.equal(slopeCurve(page, 2), null);
});

test("excitation and motions over weight and wave", () => {
  const whole = Float32Array.from({ length: 12 }, (_, i) => (i % 2 ? 4 : 3));
  const none = new Float32Array(12);
  const weight = ship.mass * ship.gravity;
  const excitation = { omega: [1], headingsDeg: [30], froudeKrylov: whole, diffraction: none };
  near(excitationCurve({ ship, excitation }, 0, 0).y[0], 5 * 20 / weight, 1e-12);
  near(excitationCurve({ ship, excitation }, 0, 4).y[0], 5 / weight, 1e-12);
  const rao = { speed: 0, free: false, headingsDeg: [30], omega: [1], values: whole };
  near(motionCurve({ ship }, rao, 0, 2).y[0], 5, 1e-12);
  near(motionCurve({ ship }, rao, 0, 3).y[0], 5 * 9.80665, 1e-9);
  const slow = { ...rao, speed: 9.80665 / Math.cos(Math.PI / 6) };
  assert.equal(motionCurve({ ship }, slow, 0, 2).y[0], null);
});

test("the nearest speed and heading, and what is too far", () => {
  const raos = [0, 5, 10].flatMap((speed) => [true, false].map((free) => ({ speed, free })));
  assert.deepEqual(raosNear({ ship, raos }), { speed: 5, free: false });
  assert.equal(raosNear({ ship, raos: [] }), null);
  const sweep = { omega: [2, 1, 1], omegaE: [2, 1, 1], mode: [3, 3, 4], timeAmplitude: [4, 5, 6] };
  const runs = [{ kind: "sweep", mean: "free", speed: 5, headingDeg: 30, sweep }];
  const rao = raosNear({ ship, raos, runs });
  assert.deepEqual(rao, { speed: 5, free: true });
  assert.deepEqual(sweepPoints({ ship, runs }, rao, 30, 2), { x: [1, 2], y: [5, 4] });
  near(sweepPoints({ ship, runs }, rao, 30, 3).y[0], 6 * 9.80665, 1e-12);
  assert.equal(sweepPoints({ ship, runs }, rao, 150, 2), null);
  assert.ok(isDamped({ particulars: [["yaw_stiffness", 1, ""]] }, false));
  assert.ok(!isDamped({ particulars: [["yaw_stiffness", 1, ""]] }, true));
  assert.equal(headingNear([0, 22.5, 45], 30), 1);
  assert.equal(headingNear([0, 90, 180], 150), null);
});

test("extremes leave out gaps and what lies beyond", () => {
  const found = extremes({ x: [0, 1, 2, 3], y: [1, null, -2, 50] }, 2);
  assert.deepEqual(found, { least: -2, most: 1, value: -2, at: 2 });
  assert.equal(extremes({ x: [], y: [] }), null);
  assert.ok(staysOn(found, [-2, 1]));
  assert.ok(!staysOn(found, [-1, 1]));
});
