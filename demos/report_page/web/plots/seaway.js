// In a seaway: motions of a point in a sea that the reader sets, over heading, and up to which wave
// height the ship keeps within limits that the reader sets.
import { limitingHeights, shareOfHeadings } from "../analysis/operability.js";
import { allRound, circleStep, QUANTITIES, quantityOf, spread, variance }
  from "../analysis/response.js";
import { jonswap, trapezoid } from "../analysis/sea.js";
import { chips, choice, h, missing, number, prose, table, tick } from "./dom.js";
import { Figure } from "./figure.js";
import { show } from "./format.js";
import { title } from "./modes.js";
import { Polar, ringStep } from "./polar.js";

// Examples of limits, for the reader to change; factor 2: significant amplitude, 1: rms.
const CRITERIA = [
  { name: "roll, significant amplitude", key: "roll", factor: 2, limit: 8, unit: "°" },
  { name: "pitch, significant amplitude", key: "pitch", factor: 2, limit: 3, unit: "°" },
  { name: "vertical acceleration at the bridge, rms", key: "vertical-acceleration", factor: 1,
    limit: 0.2, unit: "g" },
  { name: "transverse acceleration at the bridge, rms", key: "transverse-acceleration", factor: 1,
    limit: 0.1, unit: "g" },
];

// Places aboard, guessed from the hull's size: [x, y, z] from G.
function pointsOf(hull) {
  const reach = [0, 1, 2].map((axis) => {
    let least = Infinity, most = -Infinity;
    for (let i = axis; i < (hull?.points.length ?? 0); i += 3) {
      least = Math.min(least, hull.points[i]);
      most = Math.max(most, hull.points[i]);
    }
    return least > most ? { least: 0, most: 0 } : { least, most };
  });
  const [x, , z] = reach, length = x.most - x.least;
  const rounded = (value) => Number(value.toPrecision(3));
  return {
    bridge: { name: "bridge", at: [rounded(x.least + 0.6 * length), 0,
      rounded(z.most + 0.06 * length)] },
    bow: { name: "bow", at: [rounded(x.most - 0.02 * length), 0, rounded(z.most)] },
    g: { name: "centre of gravity", at: [0, 0, 0] },
    stern: { name: "stern", at: [rounded(x.least + 0.02 * length), 0, rounded(z.most * 0.7)] },
  };
}

function firstState(page) {
  const sea = page.runs.find(({ sea: of }) => of?.hs > 0)?.sea;
  const small = page.ship.length < 40;
  const speeds = [...new Set(page.raos.map(({ speed }) => speed))];
  return {
    hs: sea?.hs ?? (small ? 1 : 3), tp: sea?.tp > 0 ? sea.tp : small ? 5 : 9,
    gamma: sea?.gamma >= 1 ? sea.gamma : 3.3, short: true,
    free: page.raos.some(({ free }) => free), speeds, chosen: new Set(speeds.slice(0, 3)),
    points: pointsOf(page.ship.hull), point: "bridge", key: "vertical-acceleration", factor: 2,
    criteria: CRITERIA.map((criterion) => ({ ...criterion, on: true })),
  };
}

/** Standard deviation of a quantity over headings, for the sea of `state` or one of 1 m. */
function deviations(page, state, circle, speed, key, at, hs) {
  const spectrum = jonswap(hs, state.tp, state.gamma);
  const squares = circle.map((direction) =>
    variance(direction, quantityOf(key), at, spectrum, speed, page.ship.gravity));
  const step = circleStep(circle.map(({ headingDeg }) => headingDeg));
  return (state.short && step ? spread(squares, step) : squares).map(Math.sqrt);
}

function setsOf(page, state, cache) {
  return page.raos.filter(({ free, speed }) => free === state.free && state.chosen.has(speed))
    .map((rao) => {
      if (!cache.has(rao)) cache.set(rao, allRound(rao, page.ship.symmetric));
      return { speed: rao.speed, circle: cache.get(rao) };
    });
}

const speedName = (speed) => `${Number(speed.toPrecision(3))} m/s`;

function drawPolar(polar, page, state, sets) {
  const quantity = quantityOf(state.key), { name, at } = state.points[state.point];
  const lines = sets.map(({ speed, circle }) => ({
    label: speedName(speed), colour: state.speeds.indexOf(speed),
    values: deviations(page, state, circle, speed, state.key, at, state.hs)
      .map((sigma) => state.factor * sigma),
  }));
  const where = quantity.anywhere ? "" : ` at the ${name}`;
  const what = state.factor === 2 ? "significant amplitude" : "rms";
  polar.set(headingsOf(sets), lines, { title: title(`${quantity.name}${where}, ${what}`),
    unit: quantity.unit, closed: closedCircle(sets) });
}

const headingsOf = (sets) => (sets[0]?.circle ?? []).map(({ headingDeg }) => headingDeg);
const closedCircle = (sets) => circleStep(headingsOf(sets)) > 0;

function limitsOf(page, state, { speed, circle }) {
  const active = state.criteria.filter(({ on }) => on);
  const criteria = active.map(({ key, factor, limit, unit }) => ({
    limit: unit === "g" ? limit * page.ship.gravity : limit,
    perMetre: deviations(page, state, circle, speed, key, state.points.bridge.at, 1)
      .map((sigma) => factor * sigma),
  }));
  const limiting = limitingHeights(criteria, circle);
  return { limiting, words: limiting.map(({ by }) =>
    (by < 0 ? "" : `(${active[by].name.split(",")[0]})`)) };
}

function drawLimits(polar, figure, page, state, sets) {
  const limits = sets.map((set) => limitsOf(page, state, set));
  const finite = limits.flatMap(({ limiting }) => limiting.map(({ hs }) => hs))
    .filter(Number.isFinite);
  const median = finite.sort((a, b) => a - b)[Math.floor(finite.length / 2)] ?? 1;
  const usual = finite.filter((hs) => hs < 2.5 * median);
  const top = 1.1 * Math.max(...usual, state.hs), step = ringStep(top);
  const most = step * Math.ceil(top / step);
  polar.set(headingsOf(sets), sets.map(({ speed }, i) => ({ label: speedName(speed),
    colour: state.speeds.indexOf(speed), words: limits[i].words,
    values: limits[i].limiting.map(({ hs }) => hs) })),
  { title: "Greatest wave height within all limits", unit: "m of Hs", most, limit: state.hs,
    closed: closedCircle(sets) });
  const heights = Array.from({ length: 201 }, (_, i) => i * most / 200);
  figure.setLines(sets.map(({ speed }, i) => ({ label: speedName(speed),
    colour: state.speeds.indexOf(speed), x: heights,
    y: shareOfHeadings(limits[i].limiting, heights).map((share) => 100 * share) })),
  [{ x: state.hs, kind: "limit", label: `Hs ${state.hs} m` }]);
}

// Share of the sea's energy at frequencies for which there are RAOs.
function covered(state, sets) {
  const omega = sets[0]?.circle[0]?.omega;
  if (!omega) return 1;
  const spectrum = jonswap(1, state.tp, state.gamma), weights = trapezoid(omega);
  return Math.min(1, 16 * omega.reduce((sum, w, i) => sum + weights[i] * spectrum(w), 0));
}

function seaControls(state, update) {
  const field = (name, label, unit, limits) => number(label, unit, state[name], limits, (value) => {
    state[name] = value;
    update();
  });
  return [
    field("hs", "Hs", "m", { min: 0.05, max: 30, step: 0.25 }),
    field("tp", "Tp", "s", { min: 1, max: 30, step: 0.5 }),
    field("gamma", "γ", "", { min: 1, max: 20, step: 0.1 }),
    tick("short crests (cos²)", state.short, (on) => {
      state.short = on;
      update();
    }),
  ];
}

function pointControls(state, update) {
  const place = h("span.control");
  const fields = () => ["x", "y", "z"].map((axis, i) => number(axis, "m",
    state.points[state.point].at[i], { step: 0.1 }, (value) => {
      state.points[state.point].at[i] = value;
      update();
    }));
  const fill = () => place.replaceChildren(...fields());
  fill();
  return [choice("at", Object.entries(state.points).map(([key, { name }]) => [key, name]),
    state.point, (key) => {
      state.point = key;
      fill();
      update();
    }), place];
}

function allControls(page, state, update) {
  const both = new Set(page.raos.map(({ free }) => free)).size > 1;
  return [h("div.controls", {}, ...seaControls(state, update),
    state.speeds.length > 1 ? chips("Speeds", state.speeds.map((speed) =>
      [speed, speedName(speed)]), state.chosen, update) : null,
    both ? choice("Ship", [["true", "free"], ["false", "on a fixed course"]], state.free,
      (value) => {
        state.free = value === "true";
        update();
      }) : null),
  h("div.controls", {}, choice("Show", QUANTITIES.map(({ key, name }) => [key, name]), state.key,
    (key) => {
      state.key = key;
      update();
    }), ...pointControls(state, update),
  choice("as", [[2, "significant amplitude, 2σ"], [1, "rms, σ"]], state.factor, (value) => {
    state.factor = Number(value);
    update();
  }))];
}

function criteriaTable(state, update) {
  return table([{ title: "" }, { title: "limit on" }, { title: "at most", kind: "number" },
    { kind: "unit" }], state.criteria.map((criterion) => [
    tick("", criterion.on, (on) => {
      criterion.on = on;
      update();
    }),
    criterion.name,
    number("", "", criterion.limit, { min: 0.001, max: 1000 }, (value) => {
      criterion.limit = value;
      update();
    }),
    criterion.unit === "g" ? "g" : criterion.unit]));
}

const LEAD = "Linear theory in a JONSWAP sea that you set. The bow is up; a point lies in the "
  + "direction from which the waves come. Places are from G, x forward, y to port, z up; they are "
  + "guessed from the hull's size, so set your own. Accelerations athwart and lengthwise are those "
  + "that are felt aboard: roll and pitch bring in a share of gravity.";

export function seaway(section, page) {
  if (!page.raos.length) {
    section.append(missing("Without RAOs in the data there is nothing to show here."));
    return;
  }
  const state = firstState(page), cache = new Map();
  const grid = h("div.grid"), below = h("div.grid"), note = h("p.note");
  const limits = h("div", {}, h("h3", {}, "Limits"), prose("Examples, not a rule of anyone: set "
    + "those of your ship. Accelerations are those at the bridge, whose place is set above; g is "
    + "gravity."));
  const polar = new Polar(grid, { id: "polar-response" });
  const rim = new Polar(grid, { id: "polar-limits", fill: true });
  below.append(limits);
  const share = new Figure(below, { id: "operability", title: "Headings within all limits",
    x: { label: "significant wave height Hs", symbol: "Hs", unit: "m" }, height: 230,
    y: { label: "", unit: "%", exponent: 0, range: [0, 105] }, empty: "Choose a speed above." });
  const update = () => {
    const sets = setsOf(page, state, cache);
    drawPolar(polar, page, state, sets);
    drawLimits(rim, share, page, state, sets);
    const part = covered(state, sets);
    note.textContent = part > 0.995 ? "" : `The RAOs cover ${show(100 * part, 3)} % of this sea's `
      + "energy; the rest is left out, and what is shown is too small by it.";
  };
  limits.append(criteriaTable(state, update));
  section.append(prose(LEAD, "p.lead"), ...allControls(page, state, update), grid, note, below);
  update();
}
