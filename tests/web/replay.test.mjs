// The replay's pure modules against closed forms: the sea's formula, the grid that it is drawn on,
// the motion between ticks, pressures, scenes.
import assert from "node:assert/strict";
import test from "node:test";

const from = (name) => import(`../../demos/report_page/web/replay/${name}.js`);
const { elevation, jonswapSea, makeSea, rampAt, shortestLength, significantHeight, slope, turnsAt,
  waterAt } = await from("wave");
const { makeTrack, quaternion, rotate, rowAt, slerp } = await from("motion");
const { filterCell, fineSquare, gridLevels, makeGrid } = await from("grid");
const { connectedParts, creasedNormals } = await from("mesh");
const { niceAbove, pressures } = await from("pressure");
const { decorate, makeDeck } = await from("decoration");
const { answersAt, boxHull, groupRuns, hullOf, sceneOfRuns, scenesWithoutRuns } =
  await from("scenes");

const G = 9.80665;
const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test("a wave from astern travels along +x at g/omega", () => {
  const sea = makeSea([0.8], [1.5], [0.3], [0], G);
  const k = 0.64 / G;
  near(elevation(sea, 2, 30, -7), 1.5 * Math.cos(0.8 * 2 - k * 30 + 0.3), 1e-12);
  near(elevation(sea, 12, 30 + (10 * 0.8) / k, 5), elevation(sea, 2, 30, 5), 1e-9);
});

test("a wave at heading 90 degrees travels to starboard, towards -y", () => {
  const sea = makeSea([0.8], [1], [0], [Math.PI / 2], G);
  near(elevation(sea, 1, 0, (-1 * 0.8) / (0.64 / G)), 1, 1e-9);
});

test("the ramp is half a cosine", () => {
  const sea = makeSea([1], [1], [0], [0], G, 20);
  assert.deepEqual([rampAt(sea, 0), rampAt(sea, 20), rampAt(sea, 99)], [0, 1, 1]);
  near(rampAt(sea, 10), 0.5, 1e-15);
});

test("slopes are the derivatives of the elevation", () => {
  const sea = jonswapSea(4, 9, 2.5, G);
  const d = 1e-4;
  const [sx, sy] = slope(sea, 50, 20, 30);
  near(sx, (elevation(sea, 50, 20 + d, 30) - elevation(sea, 50, 20 - d, 30)) / (2 * d), 1e-7);
  near(sy, (elevation(sea, 50, 20, 30 + d) - elevation(sea, 50, 20, 30 - d)) / (2 * d), 1e-7);
});

test("phases at an origin and local distances give the same sea, ten hours from the start", () => {
  const sea = jonswapSea(4, 9, 2.5, G);
  const [t, x, y] = [36000, 150000, -40000];
  const turns = turnsAt(sea, t, x, y);
  let sum = 0;
  for (let i = 0; i < sea.size; ++i) {
    assert.ok(Math.abs(turns[i]) <= 0.5);
    const local = (sea.kx[i] * 40 + sea.ky[i] * 25) / (2 * Math.PI);
    sum += Math.fround(sea.amplitude[i]) * Math.cos(2 * Math.PI * Math.fround(turns[i] - local));
  }
  near(sum, elevation(sea, t, x + 40, y + 25), 1e-5);
});

test("a JONSWAP sea has its significant height, and waves of some metres carry its slopes", () => {
  const sea = jonswapSea(3, 9, 0, G);
  near(significantHeight(sea), 3, 1e-12);
  assert.ok(shortestLength(sea) > 5 && shortestLength(sea) < 30);
});

test("pressure head: e^{kz} at the heights that each profile takes", () => {
  const of = (profile) => makeSea([1], [2], [0], [0], G, 0, profile);
  const k = 1 / G;
  near(waterAt(of("extrapolated"), 0, 0, 0, -5).head, 2 * Math.exp(-5 * k), 1e-12);
  near(waterAt(of("extrapolated"), 0, 0, 0, 9).head, 2 * Math.exp(2 * k), 1e-12);
  near(waterAt(of("wheeler"), 0, 0, 0, -5).head, 2 * Math.exp(-7 * k), 1e-12);
  near(waterAt(of("wheeler"), 0, 0, 0, 2).head, 2, 1e-12);
  near(waterAt(of("constant"), 0, 0, 0, 1).head, 2, 1e-12);
});

test("pressure in calm water is rho g times the depth, whatever the attitude", () => {
  const pose = { position: [100, 50, -3], q: quaternion(0.4, 0.2, 1) };
  const out = pressures([0, 0, 0], pose, makeSea([], [], [], [], G), 5, 1025, new Float64Array(1));
  near(out[0], (1025 * G * 3) / 1000, 1e-9);
});

test("quaternions turn as R_z(yaw) R_y(pitch) R_x(roll)", () => {
  const close = (a, b) => a.forEach((v, i) => near(v, b[i], 1e-12));
  close(rotate(quaternion(0, 0, Math.PI / 2), [1, 0, 0]), [0, 1, 0]);
  close(rotate(quaternion(0, Math.PI / 2, 0), [1, 0, 0]), [0, 0, -1]);
  close(rotate(quaternion(Math.PI / 2, 0, 0), [0, 1, 0]), [0, 0, 1]);
  close(rotate(quaternion(Math.PI / 2, 0, Math.PI / 2), [0, 1, 0]), [0, 0, 1]);
});

test("between two ticks the attitude turns evenly, the short way", () => {
  const half = slerp(quaternion(0, 0, 3.1), quaternion(0, 0, -3.1), 0.5);
  near(Math.abs(rotate(half, [1, 0, 0])[0] + 1), 0, 1e-12);
});

test("a track holds its ends, and lies on the line between rows", () => {
  const columns = new Map(["t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"]
    .map((name, i) => [name, Float64Array.from([0, 1, 2], (v) => v * (i + 1))]));
  columns.set("t", Float64Array.from([0, 1, 3]));
  const track = makeTrack(columns);
  assert.deepEqual(track.at(2).position, [3, 4.5, 6]);
  assert.deepEqual(track.at(-5).position, [0, 0, 0]);
  assert.deepEqual(track.at(99).position, [4, 6, 8]);
  assert.deepEqual(rowAt(columns.get("t"), 1), { i: 1, f: 0 });
  assert.throws(() => makeTrack(new Map([["t", [0]]])), /no column x/);
});

/// Edges of triangles that only one triangle has, in the direction in which it runs.
function openEdges(indices) {
  const edges = new Set();
  for (let f = 0; f < indices.length; f += 3) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [indices[f + k], indices[f + ((k + 1) % 3)]];
      assert.ok(!edges.has(`${a},${b}`), "an edge runs twice in one direction");
      if (!edges.delete(`${b},${a}`)) edges.add(`${a},${b}`);
    }
  }
  return edges;
}

test("the grid covers the plane once: no crack, no overlap, to the horizon", () => {
  const grid = makeGrid({ cell: 0.5, half: 40, ring: 11, reach: 900, skirt: 8000 });
  const edges = openEdges(grid.indices);
  let rim = 0;
  for (const edge of edges) {
    const [a] = edge.split(",").map(Number);
    near(Math.max(Math.abs(grid.places[3 * a]), Math.abs(grid.places[3 * a + 1])), 8000, 0.01);
    rim += 1;
  }
  assert.ok(rim > 50);
  let area = 0;
  for (let f = 0; f < grid.indices.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * grid.indices[f + k]);
    const p = grid.places;
    area += 0.5 * ((p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[c] - p[a]) * (p[b + 1] - p[a + 1]));
  }
  near(area / 16000 ** 2, 1, 1e-6);
});

test("cells near a ship are at most 0.5 m, and every wave is drawn there", () => {
  for (const length of [12, 30, 124.5, 300]) {
    const { cell, half } = fineSquare(length);
    assert.ok(cell <= 0.5 && cell * half >= 0.62 * length);
    const levels = gridLevels(cell, half, 20, 5000);
    assert.equal(filterCell(levels, 0.6 * length), 0);
    let last = 0;
    for (let r = 1; r < 6000; r *= 1.02) {
      const now = filterCell(levels, r);
      assert.ok(now >= last && now - last < 0.2 * r, "waves fade steadily with distance");
      last = now;
    }
  }
});

test("a box keeps its edges sharp, a fine ball is smooth", () => {
  const { points, faces } = boxHull([4, 2, 1]);
  const normals = creasedNormals(points, faces, 0.66);
  for (let c = 0; c < faces.length; ++c) {
    assert.equal(Math.max(...[0, 1, 2].map((i) => Math.abs(normals[3 * c + i]))), 1);
    // Outwards: away from the middle.
    const dot = [0, 1, 2].reduce((s, i) => s + normals[3 * c + i] * points[3 * faces[c] + i], 0);
    assert.ok(dot > 0);
  }
  assert.equal(connectedParts(points, faces).length, 1);
});

test("scales end at round numbers", () => {
  assert.deepEqual([0.9, 1, 1.1, 3, 7, 51].map(niceAbove), [1, 1, 2, 5, 10, 100]);
});

const column = (name, values) => ({ name, values: Float64Array.from(values) });
const runOf = (name, phase) => ({
  name, kind: "simulate", gravity: G, profile: "wheeler", parts: [],
  sea: { text: "one wave", ramp: 0, omega: [1], amplitude: [1], phase: [phase], heading: [0] },
  columns: ["t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"].map((n) => column(n, [0, 1])),
});

test("runs in one sea are one scene; a run that lacks a column is left out and named", async () => {
  const runs = [runOf("a", 0), runOf("b", 1), runOf("c", 0), { ...runOf("d", 0), kind: "sweep" }];
  assert.deepEqual(groupRuns(runs).map((g) => g.map((r) => r.name)), [["a", "c"], ["b"]]);
  const page = { ship: { cog: [0, 0, 1], hull: boxHull([1, 1, 1]), density: 1025 }, runs };
  runs[2].columns.pop();
  const scene = await sceneOfRuns([runs[0], runs[2]], page);
  assert.deepEqual(scene.bodies.map(({ name }) => name), ["a"]);
  assert.match(scene.faults[0], /yaw_deg/);
});

test("without runs the ship lies still, or moves by its transfer functions; a note says so", () => {
  const omega = [0.1, 3];
  const values = new Float32Array(2 * 6 * 2);
  for (const i of [0, 1]) values[(i * 6 + 2) * 2] = 1; // heave follows the wave
  const rao = { speed: 0, free: true, headingsDeg: [150], omega, values };
  const ship = { name: "s", cog: [0, 0, 2], length: 100, gravity: G, hull: boxHull([9, 2, 2]) };
  const [moving, still] = scenesWithoutRuns({ ship, raos: [rao], runs: [] });
  assert.match(still.note, /no run/);
  assert.deepEqual(still.bodies[0].track.at(7).position, [0, 0, 2]);
  near(moving.bodies[0].track.at(7).position[2], 2 + elevation(moving.sea, 7, 0, 0), 1e-9);
  assert.deepEqual(Array.from(answersAt(rao, 140, [5])[2].re), [0]);
});

test("without a closed hull the panels are shown, one side mirrored, without the lid", () => {
  const points = Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 1, 0]);
  const faces = Uint32Array.from([0, 1, 2, 3, 1, 4, 2, 2, 0, 1, 3, 3]);
  const hull = hullOf({ symmetric: true, panels: { points, faces, lid: 1 } });
  assert.equal(hull.faces.length, 2 * 9);
  assert.deepEqual(Array.from(hull.faces.slice(9, 12)), [7, 6, 5]);
  assert.equal(hull.points[15 + 7], -1);
  assert.throws(() => hullOf({}), /neither a closed hull nor panels/);
});

test("decoration stands on the deck of a long hull, and none on a barge", () => {
  const of = (size) => {
    const { points, faces } = boxHull(size);
    return [connectedParts(points, faces)[0], points, faces];
  };
  assert.equal(decorate(...of([20, 15, 4])), null);
  for (const [length, beam, depth] of [[124, 15, 10], [30, 8, 4]]) {
    const hull = of([length, beam, depth]);
    near(makeDeck(hull[1], hull[2]).heightAt(0.3 * length, 0.2 * beam), 0.5 * depth, 1e-9);
    const { position, normal, paint, band, eye } = decorate(...hull);
    assert.deepEqual([normal.length, 3 * paint.length, 1.5 * band.length],
      [position.length, position.length, position.length]);
    for (let i = 0; i < position.length; i += 3) {
      assert.ok(Math.abs(position[i]) <= 0.51 * length && position[i + 2] > 0.4 * depth);
      near(Math.hypot(...normal.subarray(i, i + 3)), 1, 1e-5);
    }
    assert.ok(eye[2] > 0.5 * depth + 1.5, "the bridge sees over the deck");
  }
});
