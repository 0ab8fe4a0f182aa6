// Coefficients of the database: added mass and damping, excitation, retardation functions.
import { choice, h, missing, prose, tick } from "./dom.js";
import { Figure } from "./figure.js";
import { degrees, subscript } from "./format.js";
import { complexAt, MODES, pairUnit, phaseDegrees, rotates, title } from "./modes.js";
import { unwrapped } from "../analysis/curves.js";

const someNotZero = (values) => values?.some((value) => value !== 0 && value !== null);

const pairsOf = (...tables) => [...new Set(tables.flatMap((table) => Object.keys(table ?? {})
  .filter((pair) => someNotZero(table[pair]))))].sort();

const rounded = (value) => String(Number(value.toPrecision(3)));

const fromZero = (plot, low, high) => [0, high];

const isDiagonal = (pair) => pair[0] === pair[1];

const nameOf = (pair) => `${MODES[pair[0] - 1]}–${MODES[pair[1] - 1]}`;

// Diagonal pairs one after the other, then one coupling to choose.
function pairGrid(section, heading, pairs, draw) {
  const grid = h("div.grid.three");
  section.append(h("h3", {}, heading), grid);
  pairs.filter(isDiagonal).forEach((pair) => draw(pair, grid));
  const coupled = pairs.filter((pair) => !isDiagonal(pair));
  if (!coupled.length) return;
  const place = h("div.grid.three");
  let figures = [];
  const choose = (pair) => {
    figures.forEach((figure) => figure.destroy());
    figures = draw(pair, place, "coupling");
  };
  section.append(h("div.controls", {}, choice("Coupling", coupled.map((pair) =>
    [pair, `${subscript(pair)}  ${nameOf(pair)}`]), coupled[0], choose)), place);
  choose(coupled[0]);
}

function frequencyMarks({ resolved, masked }) {
  return [
    ...(masked ?? []).map((x) => ({ x, kind: "masked" })),
    ...(resolved > 0 ? [{ x: resolved, kind: "limit", label: "resolved" }] : []),
  ];
}

function addedMass(pair, place, data, id) {
  const { omega, A, Ainf, A0 } = data;
  const lines = [{ label: "A(ω)", x: omega, y: A[pair] ?? omega.map(() => 0) }];
  const marks = frequencyMarks(data), include = [];
  if (Number.isFinite(A0?.[pair])) {
    lines.push({ label: "A(0)", x: [0], y: [A0[pair]], points: true, colour: 0 });
  }
  if (Number.isFinite(Ainf?.[pair])) {
    include.push(Ainf[pair]);
    lines.push({ label: "A(∞)", x: [omega[0], omega.at(-1)], y: [Ainf[pair], Ainf[pair]],
      dash: [6, 4], colour: 1, width: 1.2 });
  }
  return new Figure(place, { id: `A${id}`, title: `A${subscript(pair)} ${nameIf(pair)}`, marks,
    x: { label: "ω", unit: "rad/s", range: fromZero },
    y: { label: "", unit: pairUnit(pair, "kg"), include }, lines });
}

const nameIf = (pair) => (isDiagonal(pair) ? MODES[pair[0] - 1] : nameOf(pair));

function damping(pair, place, data, id) {
  const { omega, B } = data;
  return new Figure(place, { id: `B${id}`, title: `B${subscript(pair)} ${nameIf(pair)}`,
    marks: frequencyMarks(data), x: { label: "ω", unit: "rad/s", range: fromZero },
    y: { label: "", unit: pairUnit(pair, "kg/s") },
    lines: [{ label: "B(ω)", x: omega, y: B[pair] ?? omega.map(() => 0) }] });
}

function massAndDamping(section, data) {
  if (!data?.omega?.length) {
    section.append(missing("The data has no added mass and damping."));
    return;
  }
  const masked = data.masked?.length ? ` Masked frequencies (dotted) are not used: near them the `
    + `equations have resonances inside the hull (${data.masked.map(rounded).join(", ")}`
    + ` rad/s).` : "";
  const resolved = data.resolved > 0 ? ` The panels resolve waves up to ${rounded(data.resolved)}`
    + ` rad/s (dashed).` : "";
  section.append(prose(`At zero speed, about G, the centre of gravity.${resolved}${masked}`,
    "p.lead"));
  const pairs = pairsOf(data.A, data.B);
  for (const [heading, draw] of [["Added mass A", addedMass], ["Damping B", damping]]) {
    pairGrid(section, heading, pairs, (pair, place, coupling) =>
      [draw(pair, place, data, coupling ? "-coupling" : pair)]);
  }
}

function excitationLines(data, heading, mode, phases) {
  const { omega, froudeKrylov, diffraction } = data, n = omega.length;
  const at = (values) => omega.map((_, i) => complexAt(values, n, heading, i, mode));
  const parts = [at(froudeKrylov), at(diffraction)];
  parts.unshift(parts[0].map(([re, im], i) => [re + parts[1][i][0], im + parts[1][i][1]]));
  return ["whole", "Froude–Krylov", "diffraction"].flatMap((label, i) => {
    const sizes = parts[i].map(([re, im]) => Math.hypot(re, im));
    const style = { label, dash: [undefined, [7, 4], [2, 3]][i] };
    if (!phases) return [{ ...style, colour: i, x: omega, y: sizes }];
    const least = 1e-3 * Math.max(...sizes);
    const known = parts[i].map((part, k) => (sizes[k] > least ? phaseDegrees(part) : null));
    return unwrapped({ x: omega, y: known }).map((part) => ({ ...style, colour: i, ...part }));
  });
}

function excitation(section, data) {
  section.append(h("h3", {}, "Excitation by waves"));
  if (!data?.omega?.length) {
    section.append(missing("The data has no excitation."));
    return;
  }
  const beam = data.headingsDeg.indexOf(150);
  const state = { heading: beam < 0 ? 0 : beam, phases: false };
  const grid = h("div.grid.three");
  const figures = MODES.map((name, mode) => new Figure(grid, {
    id: `excitation-${name}`, title: `F${subscript(mode + 1)} ${name}`,
    x: { label: "ω", unit: "rad/s", range: fromZero }, y: { label: "" }, marks: [] }));
  const update = () => figures.forEach((figure, mode) => {
    const force = rotates(mode) ? "N·m/m" : "N/m";
    figure.spec.y = state.phases ? { label: "", unit: "°", exponent: 0, range: [-180, 180],
      incrs: [90, 180] } : { label: "", unit: force };
    figure.setLines(excitationLines(data, state.heading, mode, state.phases));
  });
  section.append(prose("Force and moment about G per metre of wave amplitude, at zero speed: "
    + "the pressure of the undisturbed wave (Froude–Krylov), and what the hull adds by scattering "
    + "it (diffraction).", "p.lead"),
  h("div.controls", {}, choice("Heading", data.headingsDeg.map((heading, i) =>
    [i, degrees(heading)]), state.heading, (value) => {
    state.heading = Number(value);
    update();
  }), tick("phases instead", state.phases, (on) => {
    state.phases = on;
    update();
  })), grid);
  update();
}

function retardation(section, data) {
  if (!data?.tau?.length) {
    section.append(h("h3", {}, "Retardation functions"),
      missing("The data has no retardation functions."));
    return;
  }
  pairGrid(section, "Retardation functions", pairsOf(data.K), (pair, place, coupling) => [
    new Figure(place, { id: `K${coupling ? "-coupling" : pair}`,
      title: `K${subscript(pair)} ${nameIf(pair)}`, x: { label: "τ", unit: "s", range: fromZero },
      y: { label: "", unit: pairUnit(pair, "kg/s²") },
      lines: [{ label: `K${subscript(pair)}(τ)`, x: data.tau, y: data.K[pair] }] }),
  ]);
}

export function coefficients(section, page) {
  massAndDamping(section, page.coefficients);
  excitation(section, page.excitation);
  retardation(section, page.retardation);
}
