// Runs: time histories, spectra and significant values beside the linear prediction, force parts.
// A run's plots are made when it is opened.
import { compare, endOfEnergy, predictionOf, rangeOf, RESPONSES, stepOf }
  from "../analysis/comparison.js";
import { crossingPeriod, firstFrom, statistics } from "../analysis/statistics.js";
import { chips, choice, h, missing, prose, table, tick } from "./dom.js";
import { Figure } from "./figure.js";
import { degrees, exponentFor, scaledUnit, seconds, show, unitText } from "./format.js";
import { History, Window, windowControls } from "./history.js";
import { DEGREES, MODES, rotates, title } from "./modes.js";

const NAMES = { wave: "Wave at the ship", z: "Height z of G", roll_deg: "Roll",
  pitch_deg: "Pitch", yaw_deg: "Yaw", x: "Way x of G", y: "Way y of G", u: "Velocity u, forward",
  v: "Velocity v, to port", w: "Velocity w, up", p: "Roll rate p", q: "Pitch rate q",
  r: "Yaw rate r" };
const ORDER = Object.keys(NAMES);
const FIRST = ["wave", "z", "roll_deg", "pitch_deg"];

const isForce = (name) => /_F[1-6]$/.test(name);

function describe(run) {
  const words = [run.sea?.text ?? (run.kind === "sweep" ? "regular waves" : "calm water")];
  if (run.speed) words.push(`${Number(run.speed.toPrecision(3))} m/s`);
  if (run.mean) words.push(run.mean === "free" ? "free" : "on a fixed course");
  if (run.mode) words.push(run.mode);
  return words.join(", ");
}

function histories(place, run, id, window) {
  const t = run.column("t").values;
  const rank = ({ name }) => (ORDER.indexOf(name) + ORDER.length + 1) % (ORDER.length + 1);
  const columns = run.columns.filter(({ name }) => name !== "t" && !isForce(name))
    .sort((a, b) => rank(a) - rank(b));
  const on = new Set(columns.map(({ name }) => name).filter((name) => FIRST.includes(name)));
  if (!on.size) columns.slice(0, 3).forEach(({ name }) => on.add(name));
  const list = h("div.histories"), shown = new Map();
  const update = () => {
    for (const [name, history] of shown) {
      if (on.has(name)) continue;
      history.destroy();
      shown.delete(name);
    }
    for (const column of columns.filter(({ name }) => on.has(name))) {
      if (shown.has(column.name)) continue;
      shown.set(column.name, new History(list, { id: `${id}-${column.name}`,
        title: NAMES[column.name] ?? column.name, unit: unitText(column.unit) }, window, t,
      column.values));
    }
    const inOrder = columns.map(({ name }) => shown.get(name)).filter(Boolean);
    list.append(...inOrder.map(({ figure }) => figure.element));
  };
  place.append(h("h4", {}, "Time histories"), windowControls(window),
    h("div.controls.plain", {}, chips("Plots", columns.map(({ name }) => [name,
      (NAMES[name] ?? name).split(",")[0]]), on, update)), list);
  update();
}

const percent = (value, reference) => (reference > 0 && Number.isFinite(value)
  ? `${value >= reference ? "+" : "−"}${Math.abs(100 * (value / reference - 1)).toFixed(1)}` : "–");

function significantTable(rows, predicted) {
  const heads = [{ title: "" }, { title: "run", kind: "number" }, { kind: "unit" },
    { title: "by chance ±", kind: "number" }, { kind: "unit" },
    { title: "linear", kind: "number" }, { kind: "unit" }, { title: "difference", kind: "number" },
    { kind: "unit" }, { title: "mean period", kind: "number" }, { kind: "unit" },
    { title: "linear", kind: "number" }, { kind: "unit" }];
  const cells = rows.map(({ response, result }) => [response.name, show(result.significant, 3),
    response.unit, show(100 * result.scatter, 2), "%", show(result.predictedSignificant, 3),
    response.unit,
    percent(result.significant, result.predictedSignificant), "%", show(result.period, 3), "s",
    show(result.predictedPeriod, 3), "s"]);
  const alone = [0, 1, 2, 3, 4, 9, 10];
  const kept = heads.map((_, i) => i).filter((i) => predicted || alone.includes(i));
  return table(kept.map((i) => heads[i]), cells.map((row) => kept.map((i) => row[i])),
    "Significant amplitude, 2σ, and mean period between upward crossings");
}

function spectrumFigure(place, response, id) {
  return new Figure(place, { id: `${id}-spectrum-${response.column}`,
    title: `${title(response.name)}, spectrum`, height: 180,
    x: { label: "ωₑ", unit: "rad/s", range: (plot, low, high) => [0, high] },
    y: { label: "", unit: `${response.unit === "°" ? "°²" : "m²"}·s` } });
}

// What a run shows against what linear theory has, over the run or over the range shown.
function comparison(place, run, page, id, window) {
  const t = run.column("t").values, dt = stepOf(t);
  place.append(h("h4", {}, "Spectra and significant values"));
  const responses = RESPONSES.filter(({ column }) => moves(run.column(column)?.values));
  if (!dt || t.length < 64 || !responses.length) {
    place.append(missing(responses.length ? "A spectrum needs at least 64 rows at equal steps of "
      + "time; this run has none." : "Nothing moves in this run."));
    return;
  }
  const prediction = predictionOf(run, page);
  const period = typicalPeriod(run, responses, dt);
  const words = h("p.note"), grid = h("div.grid.three"), numbers = h("div");
  const figures = responses.map((response) => spectrumFigure(grid, response, id));
  let shownOnly = false;
  const update = () => {
    const range = rangeOf(t, run.sea?.ramp, shownOnly ? window : null);
    words.textContent = wordsOf(run, t, range, prediction);
    const all = responses.map((response, i) => ({ response, figure: figures[i],
      result: compare(response, run.column(response.column).values, range, dt,
        { prediction, period }) }));
    const rows = all.filter(({ result }) => result);
    const end = commonEnd(rows);
    for (const { result, figure } of all) {
      figure.spec.empty = result ? "The range is too short for a spectrum."
        : "Some of these numbers are nan: there is no spectrum.";
      figure.setLines(result ? spectrumLines(result, end) : []);
    }
    numbers.replaceChildren(significantTable(rows, prediction));
  };
  // When the zoom rests: a spectrum of a long run takes a second.
  let rest = null;
  window.listeners.add(() => {
    if (!shownOnly) return;
    clearTimeout(rest);
    rest = setTimeout(update, 200);
  });
  place.append(h("div.controls.plain", {}, tick("of the range shown above only", false, (on) => {
    shownOnly = on;
    update();
  })), words, numbers, grid);
  update();
}

// Peak period of the sea; without one what the first response shows.
function typicalPeriod(run, responses, dt) {
  if (run.sea?.tp > 0) return run.sea.tp;
  return crossingPeriod(run.column(responses[0].column).values, dt) || 10;
}

function moves(values) {
  if (!values) return false;
  const { deviation, mean } = statistics(values);
  return deviation > 1e-9 * Math.max(1, Math.abs(mean));
}

function wordsOf(run, t, [begin, end], prediction) {
  const from = `From ${seconds(t[begin])} to ${seconds(t[end - 1])} s, each column less its trend.`;
  if (!prediction) {
    const why = !run.sea ? "in calm water"
      : run.body || run.hull ? "of this body" : "without RAOs at this speed and heading";
    return `${from} There is no linear prediction ${why}.`;
  }
  const part = prediction.covered > 0.995 ? ""
    : ` The RAOs cover ${show(100 * prediction.covered, 3)} % of this sea's energy.`;
  return `${from} Linear prediction: Σ |RAO|² a²/2 of the run's own waves at their frequencies of `
    + `encounter, seen through the same window${prediction.words ? `, ${prediction.words}` : ""}. `
    + "Surge, sway and yaw without what is slower than the waves, as nothing holds them. A run of "
    + `this length scatters by chance by the share given.${part}`;
}

const commonEnd = (rows) => Math.max(0.1, ...rows.map(({ result: { spectrum } }) =>
  (spectrum ? endOfEnergy(spectrum.omega, spectrum.density) : 0))) * 1.15;

function spectrumLines({ spectrum, predictedDensity, least }, end) {
  if (!spectrum) return [];
  const part = [firstFrom(spectrum.omega, least), firstFrom(spectrum.omega, end) + 1];
  const x = spectrum.omega.subarray(...part);
  const lines = [{ label: "run", x, y: spectrum.density.subarray(...part) }];
  if (predictedDensity) {
    lines.push({ label: "linear", x, y: predictedDensity.subarray(...part), dash: [6, 4] });
  }
  return lines;
}

// Force parts: means and deviations as a table, histories of one component.
async function forces(place, run, id, window) {
  const t = run.column("t").values, range = rangeOf(t, run.sea?.ramp);
  const body = h("div", {}, missing("Reading the forces …"));
  place.append(body);
  let shown = [];
  const draw = async (component) => {
    shown.forEach((history) => history.destroy());
    const parts = await Promise.all(run.parts.map(async (part) => {
      const values = await run.column(`${part}_F${component}`)?.load();
      return { part, values };
    }));
    shown = fillForces(list, numbers, parts.filter(({ values }) => values), component,
      { id, window, t, range });
  };
  const list = h("div.histories"), numbers = h("div");
  await draw(3);
  body.replaceChildren(h("div.controls.plain", {}, choice("Component", MODES.map((mode, i) =>
    [i + 1, `F${i + 1}, ${rotates(i) ? "moment" : "force"} of ${mode}`]), 3, draw)), numbers, list);
}

function fillForces(list, numbers, parts, component, { id, window, t, range }) {
  const unit = component > 3 ? "N·m" : "N";
  const rows = parts.map(({ part, values }) => ({ part, values,
    ...statistics(values, ...range) }));
  const most = Math.max(...rows.map(({ mean, deviation }) =>
    Math.max(Math.abs(mean), deviation)));
  const exponent = exponentFor(most), scale = 10 ** exponent;
  const cell = (value) => (value / scale).toFixed(3).replace("-", "−");
  numbers.replaceChildren(table([{ title: "part" }, { title: "mean", kind: "number" },
    { title: "standard deviation", kind: "number" }, { title: "least", kind: "number" },
    { title: "greatest", kind: "number" }, { kind: "unit" }],
  rows.map(({ part, mean, deviation, least, most: top }) => [part.replaceAll("_", " "), cell(mean),
    cell(deviation), cell(least), cell(top), scaledUnit(unit, exponent)])));
  const moving = rows.filter(({ least, most: top }) => top - least > 1e-6 * most);
  const still = rows.filter((row) => !moving.includes(row)).map(({ part }) =>
    part.replaceAll("_", " "));
  if (still.length) numbers.append(h("p.note", {}, `Constant, and so not drawn: ${
    still.join(", ")}.`));
  return moving.map(({ part, values }) => new History(list, { id: `${id}-${part}_F${component}`,
    title: title(part.replaceAll("_", " ")), unit, height: 120 }, window, t, values));
}

function simulation(place, run, page, id) {
  if (!run.column("t")?.values.length) {
    place.append(missing(`${run.file} has no rows.`));
    return;
  }
  const window = new Window(run.column("t").values);
  window.key = id;
  histories(place, run, id, window);
  comparison(place, run, page, id, window);
  place.append(h("h4", {}, "Force parts"));
  if (!run.parts?.length) {
    place.append(missing("This run has no columns of forces: `cutwater simulate --forces` writes "
      + "them."));
    return;
  }
  const part = h("details", { class: "inner" }, h("summary", {}, `${run.parts.length} parts`));
  part.addEventListener("toggle", () => part.open && forces(part, run, id, window),
    { once: true });
  place.append(part);
}

function sweepTable(place, run) {
  const { sweep } = run;
  const rows = MODES.map((mode, j) => {
    const at = sweep.mode.map((m, i) => i).filter((i) => sweep.mode[i] === j + 1
      && sweep.timeAmplitude[i] !== null && sweep.freqAmplitude[i] !== null
      && Number.isFinite(sweep.timeAmplitude[i]) && Number.isFinite(sweep.freqAmplitude[i]));
    const top = Math.max(0, ...at.map((i) => sweep.freqAmplitude[i]));
    const worst = Math.max(0, ...at.map((i) =>
      Math.abs(sweep.timeAmplitude[i] - sweep.freqAmplitude[i])));
    const scale = rotates(j) ? DEGREES : 1;
    return [title(mode), String(at.length), show(top * scale, 3), rotates(j) ? "°/m" : "m/m",
      top > 1e-6 ? show(100 * worst / top, 2) : "–", "% of the peak"];
  });
  place.append(prose("A sweep: regular waves one by one. Its amplitudes are the points on the "
    + "curves under Motions."), table([{ title: "mode" }, { title: "waves", kind: "number" },
    { title: "peak, linear", kind: "number" }, { kind: "unit" },
    { title: "greatest difference", kind: "number" }, { kind: "unit" }], rows));
}

function block(run, page, number) {
  const id = `run-${number}`;
  const place = h("div");
  const element = h("details.run", { id },
    h("summary", {}, h("strong", {}, run.name), ` ${describe(run)}`), place);
  const fill = () => {
    if (place.childElementCount) return;
    const facts = [run.file, run.headingDeg === undefined || run.headingDeg === null ? null
      : `heading ${degrees(run.headingDeg)}`, run.dt ? `steps of ${run.dt} s` : null,
    run.double === undefined ? null : `Bullet in ${run.double ? "double" : "single"} precision`,
    run.profile && run.sea ? `wave pressure profile: ${run.profile}` : null].filter(Boolean);
    place.append(h("p.note", {}, `${facts.join(", ")}.`));
    if (run.kind === "sweep" && run.sweep) sweepTable(place, run);
    else simulation(place, run, page, id);
  };
  element.addEventListener("toggle", () => element.open && fill());
  return { element, fill };
}

export function runs(section, page) {
  if (!page.runs.length) {
    section.append(missing("No runs: `cutwater report DB.h5 RUN.toml -o PAGE.html` shows those "
      + "whose CSV lies beside their RUN.toml."));
    return;
  }
  const blocks = page.runs.map((run, i) => block(run, page, i));
  section.append(...blocks.map(({ element }) => element));
  blocks[0].fill();
  blocks[0].element.open = true;
}
