// Which bodies move in which sea: simulate runs whose seas have the same numbers are one scene. A
// page without such runs has the ship at rest, or in a sea by its transfer functions.
import { calmSea, jonswapSea, makeSea, significantHeight } from "./wave.js";
import { makeLinearTrack, makeTrack } from "./motion.js";

const same = (a, b) => {
  if (!a || !b) return !a && !b;
  const keys = ["omega", "amplitude", "phase", "heading"];
  return (
    (a.ramp ?? 0) === (b.ramp ?? 0) &&
    keys.every((key) => a[key].length === b[key].length && a[key].every((v, i) => v === b[key][i]))
  );
};

/// Runs of kind "simulate", grouped: [[run, ...], ...]. Calm runs are one group.
export function groupRuns(runs) {
  const groups = [];
  for (const run of runs.filter(({ kind }) => kind === "simulate")) {
    const group = groups.find(
      ([first]) =>
        same(first.sea, run.sea) && first.profile === run.profile && first.gravity === run.gravity,
    );
    if (group) group.push(run);
    else groups.push([run]);
  }
  return groups;
}

/// The closed box of a body of that size, about its middle.
export function boxHull([l, b, h]) {
  const points = [];
  for (const z of [-0.5, 0.5]) {
    for (const y of [-0.5, 0.5]) for (const x of [-0.5, 0.5]) points.push(x * l, y * b, z * h);
  }
  const faces = [
    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3,
    7, 1, 7, 5,
  ];
  return { points: Float32Array.from(points), faces: Uint32Array.from(faces) };
}

function seaOf(run, gravity) {
  const g = run.gravity ?? gravity;
  if (!run.sea || run.sea.omega.length === 0) return calmSea(g);
  const { omega, amplitude, phase, heading, ramp, k } = run.sea;
  return makeSea(omega, amplitude, phase, heading, g, ramp ?? 0, run.profile, k);
}

/// The closed hull; of a database without one the wet panels, mirrored if they are one side's.
export function hullOf(ship) {
  if (ship?.hull) return ship.hull;
  if (!ship?.panels) throw new Error("the database holds neither a closed hull nor panels to draw");
  const { points, faces, lid } = ship.panels;
  const count = faces.length / 4 - (lid ?? 0);
  const oneSide = ship.symmetric && points.every((v, i) => i % 3 !== 1 || v > -1e-6);
  const triangles = [];
  for (let p = 0; p < count; ++p) {
    const [a, b, c, d] = faces.subarray(4 * p, 4 * p + 4);
    triangles.push(a, b, c);
    if (d !== c) triangles.push(a, c, d);
  }
  if (!oneSide) return { points, faces: Uint32Array.from(triangles) };
  const n = points.length / 3;
  const other = points.map((v, i) => (i % 3 === 1 ? -v : v));
  const turned = triangles.map((_, i) => n + triangles[i - (i % 3) + 2 - (i % 3)]);
  return {
    points: Float32Array.from([...points, ...other]),
    faces: Uint32Array.from([...triangles, ...turned]),
  };
}

async function bodyOf(run, page) {
  const columns = new Map();
  await Promise.all(
    run.columns.map(async (column) => {
      if (/_F[1-6]$/.test(column.name)) return;
      columns.set(column.name, column.values ?? (await column.load()));
    }),
  );
  const hull = run.body ? boxHull(run.body.size) : (run.hull ?? hullOf(page.ship));
  return {
    name: run.name,
    run,
    hull,
    box: Boolean(run.body),
    cogZ: run.cogZ ?? page.ship.cog[2],
    mass: run.hull || run.body ? null : page.ship.mass,
    track: makeTrack(columns),
    compartments: run.compartments ?? [],
    tow: run.tow ?? null,
  };
}

/// {title, note, sea, seaText, hs, bodies, start, end, density} of a group of runs. A run that
/// cannot be drawn is left out and its fault is in `faults`.
export async function sceneOfRuns(runs, page) {
  const bodies = [];
  const faults = [];
  for (const run of runs) {
    try {
      bodies.push(await bodyOf(run, page));
    } catch (error) {
      faults.push(`${run.file ?? run.name}: ${error.message}`);
    }
  }
  if (bodies.length === 0) throw new Error(faults.join("; "));
  const sea = seaOf(runs[0], page.ship.gravity);
  return {
    title: bodies.map(({ name }) => name).join(", "),
    seaText: runs[0].sea?.text ?? "calm water",
    note: "",
    faults,
    sea,
    hs: significantHeight(sea),
    tp: runs[0].sea?.tp ?? null,
    bodies,
    start: Math.min(...bodies.map(({ track }) => track.start)),
    end: Math.max(...bodies.map(({ track }) => track.end)),
    density: page.ship.density ?? 1025,
  };
}

const NO_RUN = "There is no run of this ship: cutwater report DB.h5 RUN.toml adds one.";

/// Answers H_j(omega) of a page's transfer functions at the heading nearest to `headingDeg`, as
/// {re, im} over the frequencies of the sea; 0 outside the table. values:
/// [heading][omega][mode][2].
export function answersAt(rao, headingDeg, omega) {
  const h = rao.headingsDeg.reduce(
    (best, v, i) =>
      Math.abs(v - headingDeg) < Math.abs(rao.headingsDeg[best] - headingDeg) ? i : best,
    0,
  );
  const n = rao.omega.length;
  const value = (i, j, part) => rao.values[((h * n + i) * 6 + j) * 2 + part];
  return [0, 1, 2, 3, 4, 5].map((j) => {
    const read = (part) =>
      Float64Array.from(omega, (w) => {
        if (w < rao.omega[0] || w > rao.omega[n - 1]) return 0;
        let i = 0;
        while (i < n - 2 && rao.omega[i + 1] < w) ++i;
        const f = (w - rao.omega[i]) / (rao.omega[i + 1] - rao.omega[i]);
        return (1 - f) * value(i, j, part) + f * value(i + 1, j, part);
      });
    return { re: read(0), im: read(1) };
  });
}

/// The ship without a run: at rest in calm water, and in a sea of about a fortieth of its length by
/// linear theory, where the page has transfer functions without way.
export function scenesWithoutRuns(page) {
  const { ship } = page;
  const gravity = ship.gravity ?? 9.80665;
  const cogZ = ship.cog[2];
  const still = (title, note, sea, seaText, answers, tp) => ({
    title,
    note,
    seaText,
    faults: [],
    sea,
    hs: significantHeight(sea),
    tp,
    start: 0,
    end: 300,
    density: ship.density ?? 1025,
    bodies: [
      {
        name: ship.name,
        run: null,
        hull: hullOf(ship),
        box: false,
        cogZ,
        mass: ship.mass,
        tow: null,
        track: makeLinearTrack(cogZ, sea, answers, 300),
      },
    ],
  });
  const scenes = [];
  const rao = (page.raos ?? [])
    .filter(({ speed }) => speed === 0)
    .sort((a, b) => Number(b.free) - Number(a.free))[0];
  if (rao) {
    const length = ship.length ?? 100;
    const hs = Number((length / 40).toPrecision(2));
    const tp = Number((1.1 * Math.sqrt((2 * Math.PI * length) / gravity)).toPrecision(2));
    const sea = jonswapSea(hs, tp, (150 * Math.PI) / 180, gravity);
    scenes.push(
      still(
        "linear motions, no run",
        `${NO_RUN} Shown: linear theory without way, from the transfer functions.`,
        sea,
        `JONSWAP, Hs ${hs} m, Tp ${tp} s, from 150 deg`,
        answersAt(rao, 150, sea.omega),
        tp,
      ),
    );
  }
  scenes.push(
    still(
      "at rest in calm water",
      `${NO_RUN} Shown: the ship at rest.`,
      calmSea(gravity),
      "calm water",
      null,
      null,
    ),
  );
  return scenes;
}
