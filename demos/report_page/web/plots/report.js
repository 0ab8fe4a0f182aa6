// The report's figures: those of McTaggart, DRDC Atlantic TM 2003-104, drawn for the page's hull
// from the page's data, with the axes of the report's plots as bands. Closed; built when opened.
import { buoyancyCurve, dampingCurve, excitationCurve, extremes, hasSlope, headingNear,
  hydrostaticsRow, isDamped, isReportShip, kernelCurve, motionCurve, raosNear, reportSpeed,
  slopeCurve, squaredKernelCurve, staysOn, sweepPoints, timeScale } from "../analysis/report.js";
import { BUOYANCY, DAMPED_MOTIONS, DAMPING, EXCITATION, MOTIONS, REPORT, RETARDATION, TABLE2 }
  from "../analysis/axes.js";
import { h, missing, prose, table } from "./dom.js";
import { Figure } from "./figure.js";
import { degrees, show, subscript } from "./format.js";
import { MODES, rotates } from "./modes.js";

const STERN = [30, "stern quartering"];
const BOW = [150, "bow quartering"];
const fromZero = (plot, low, high) => [0, high];
const short = (value) => show(Number(value.toPrecision(3)), 3).replace(/(\.\d*?)0+$/, "$1")
  .replace(/\.$/, "");
const bounds = ([lower, upper]) => `${short(lower)} to ${short(upper)}`;
const TUCK = "The report integrates ∂A/∂x over the hull. The page's data are at rest: here it is "
  + "by Tuck's theorem without its integral along the waterline, which gives";
const frequency = { label: "ω", unit: "rad/s", range: fromZero };
const speedText = (speed) => `${short(speed)} m/s`;

const withUnit = (value, unit) => `${short(value)}${unit === "°" ? "" : " "}${unit}`;

// What the hull shows, beside the axis of the report's plot.
function finding(curve, axis, { last, symbol, unit, before = "", beyond = "" }) {
  const found = extremes(curve, last);
  if (!found) return `${before}This hull: no numbers.`;
  const place = `at ${symbol} = ${withUnit(found.at, unit)}`;
  const other = found.value > 0 ? found.least : found.most;
  const both = found.least < 0 && found.most > 0
    ? `, ${short(other)} the other way` : "";
  const within = axis && staysOn(found, axis);
  const where = axis ? `; ${within ? "within" : "beyond"} the report's axis, ${bounds(axis)}` : "";
  return `${before}This hull: peak ${short(found.value)} ${place}${both}${where}.${
    axis && !within ? beyond : ""}`;
}

/** One plot with its band and its sentence; `spec` as Figure's, `said` as finding's. */
function plot(place, spec, axis, said) {
  const [line] = spec.lines;
  return new Figure(place, { height: 190, ...spec,
    y: { label: "", exponent: 0, ...spec.y, include: axis ?? [] },
    bands: axis ? [{ from: axis[0], to: axis[1] }] : [], note: finding(line, axis, said) });
}

function part(place, heading, found, ...more) {
  const grid = h("div.grid.three");
  place.append(h("h3", {}, heading), prose(`The report: ${found}`, "p.lead"), ...more, grid);
  return grid;
}

function tableTwo(place, page) {
  const { ship } = page;
  place.append(h("h3", {}, "Table 2: hydrostatics"), prose("The report: its three meshes differ by "
    + "less than 0.8 % in volume and 0.3 % in wetted surface.", "p.lead"));
  if (!ship.hull) {
    place.append(missing("The data has no hull."));
    return;
  }
  const own = hydrostaticsRow(page);
  const line = (name, length, draught, volume, lcb, vcb, area) => [name, show(volume, 5),
    show(lcb, 5), show(vcb, 4), show(area, 5), show(lcb / length, 4), show(-vcb / draught, 4),
    show(area / Math.sqrt(volume * length), 4)];
  const rows = TABLE2.map(([name, panels, ...numbers]) => line(
    `the report, ${name}, ${panels} panels`, REPORT.length, REPORT.draught, ...numbers));
  rows.push(line(ship.name, ship.length, ship.draught, own.volume, own.lcb, own.vcb, own.area));
  const titles = ["volume ∇ [m³]", "LCB aft of FP [m]", "CB above water [m]", "wetted S [m²]",
    "LCB/L", "CB depth/T", "S/√(∇L)"];
  place.append(table([{ title: "hull" }, ...titles.map((title) => ({ title, kind: "number" }))],
    rows));
  const [, , medium] = TABLE2[1];
  place.append(h("p.note", {}, "FP is taken as the fore end of the hull's waterline. "
    + (isReportShip(ship) ? `This hull's volume differs by ${
      short(100 * (own.volume / medium - 1))} % from the report's medium mesh.`
      : "This hull has not the report's dimensions: compare the last three columns.")));
}

function damping(place, page) {
  const { ship, coefficients } = page, speed = reportSpeed(ship);
  const grid = part(place, "Figures 15–20: damping and ∂A/∂x", "damping is nearly the same for all "
    + "its meshes; ∂A/∂x comes from the difference of bow and stern, is small, and needs a fine "
    + "mesh. Its axes say that U ∂A/∂x is positive in surge and heave, negative in sway and yaw.",
  prose(`In units of Δr²√(g/L), Δ the mass, r = 1 m or the gyradius. U = ${speedText(speed)}. ${TUCK
  } ∂A₅₅/∂x = A₃₅ and ∂A₆₆/∂x = −A₂₆, and none for surge, sway, heave and roll: these are left `
    + "out here. The demo `report_figures` has them all.", "p.note"));
  if (!coefficients?.omega?.length) {
    grid.replaceWith(missing("The data has no added mass and damping."));
    return;
  }
  const marks = coefficients.resolved > 0
    ? [{ x: coefficients.resolved, kind: "limit", label: "resolved" }] : [];
  const said = { last: coefficients.resolved || Infinity, symbol: "ω", unit: "rad/s" };
  MODES.forEach((name, mode) => {
    const j = subscript(`${mode + 1}${mode + 1}`), cell = h("div.stack");
    grid.append(cell);
    const B = dampingCurve(page, mode), slope = slopeCurve(page, mode);
    if (!B) cell.append(missing(`Figure ${15 + mode}: the data has no B${j}.`));
    else {
      plot(cell, { id: `report-${15 + mode}`, title: `Fig. ${15 + mode}  B${j} ${name}`,
        x: frequency, marks, lines: [{ label: "B", ...B }] }, DAMPING[mode].B, said);
    }
    if (slope) {
      plot(cell, { id: `report-${15 + mode}-slope`, x: frequency, marks,
        title: `Fig. ${15 + mode}  U ∂A${j}/∂x ${name}`, height: 150,
        lines: [{ label: "U ∂A/∂x", colour: 1, ...slope }] },
      DAMPING[mode].slope, said);
    } else if (hasSlope(mode)) cell.append(missing(`The data has no U ∂A${j}/∂x.`));
  });
}

// The report's wave frequencies, 0 to 2 rad/s, for a ship of this length.
function waveRange(ship, omega) {
  const last = Math.min(2 / timeScale(ship), omega.at(-1));
  return { axis: { ...frequency, range: () => [0, last] }, last };
}

const upTo = ({ x, y }, last) => {
  const n = x.filter((value) => value <= last * (1 + 1e-9)).length;
  return { x: x.slice(0, n), y: y.slice(0, n) };
};

function excitation(place, page) {
  const { ship, excitation: data } = page;
  const lead = "at 20 knots, interpolated influence matrices follow the direct solution; "
    + "interpolated inverses do not near irregular frequencies. Each axis ends above the peak.";
  for (const [figure, wanted, name] of [[21, ...STERN], [22, ...BOW]]) {
    const title = `Figure ${figure}: excitation at ${wanted}°, ${name}`;
    const at = data?.omega?.length ? headingNear(data.headingsDeg, wanted) : null;
    if (at === null) {
      part(place, title, lead).replaceWith(missing(data?.omega?.length
        ? `The data has no heading within 8° of ${wanted}°.` : "The data has no excitation."));
      continue;
    }
    const grid = part(place, title, lead, prose("|F| in units of Δga/L, |moment| in Δga. "
      + "The page's data are of a ship at rest, the report's figures of 20 knots: the demo "
      + `\`report_figures\` has those. Heading ${degrees(data.headingsDeg[at])}.`, "p.note"));
    const { axis, last } = waveRange(ship, data.omega);
    MODES.forEach((mode, j) => plot(grid, { id: `report-${figure}-${mode}`,
      title: `Fig. ${figure}  |F${subscript(j + 1)}| ${mode}`, x: axis,
      lines: [{ label: "|F|", ...upTo(excitationCurve(page, at, j), last) }] },
    EXCITATION[wanted][j], { last, symbol: "ω", unit: "rad/s" }));
  }
}

function motionPart(place, page, rao, wanted, name) {
  const { ship } = page;
  const figures = wanted === 30 ? "23 and 31" : "24 and 32";
  const at = headingNear(rao.headingsDeg, wanted);
  const heading = `Figures ${figures}: motions at ${wanted}°, ${name}`;
  const lead = "frequency and time domain agree. Figures 23 and 24 have no roll damping but the "
    + "waves', 31 and 32 some more and a yaw stiffness.";
  if (at === null) {
    part(place, heading, lead)
      .replaceWith(missing(`The data has no heading within 8° of ${wanted}°.`));
    return;
  }
  const damped = isDamped(ship, rao.free), headingDeg = rao.headingsDeg[at];
  const number = Number(figures.split(" and ")[damped ? 1 : 0]);
  const { axis, last } = waveRange(ship, rao.omega);
  const points = MODES.map((_, j) => sweepPoints(page, rao, headingDeg, j));
  const away = Math.abs(rao.speed - reportSpeed(ship)) > 0.01 * reportSpeed(ship)
    ? `, the nearest in the data to the report's ${speedText(reportSpeed(ship))}` : "";
  const grid = part(place, heading, lead, h("p.note", {}, `At ${speedText(rao.speed)}${away}; ${
    rao.free ? "a free ship" : "on a fixed course"}; heading ${degrees(headingDeg)}. In units of `
    + `a, rotations of ka. Waves met below 0.1 rad/s are left out. The ship ${damped
      ? "has damping or stiffness of its own" : "has no damping but the water's"}, so that the `
    + `bands are the axes of Figure ${number}.${points.some(Boolean) ? " Points: the time domain."
      : " No sweep at this speed and heading, so no points of the time domain."}`));
  MODES.forEach((mode, j) => {
    const curve = upTo(motionCurve(page, rao, at, j), last);
    const lines = [{ label: "frequency domain", ...curve }];
    if (points[j]) lines.push({ label: "time domain", points: true, ...points[j] });
    plot(grid, { id: `report-${number}-${mode}`, title: `Fig. ${number}  |η${subscript(j + 1)}|/${
      rotates(j) ? "ka" : "a"} ${mode}`, x: axis, lines },
    (damped ? DAMPED_MOTIONS : MOTIONS)[wanted][j], { last, symbol: "ω", unit: "rad/s" });
  });
}

function motions(place, page) {
  const rao = raosNear(page);
  if (!rao) {
    place.append(h("h3", {}, "Figures 23, 24, 31 and 32: motions"),
      missing("The data has no RAOs."));
    return;
  }
  motionPart(place, page, rao, ...STERN);
  motionPart(place, page, rao, ...BOW);
}

function retardation(place, page) {
  const { ship, retardation: data } = page;
  const grid = part(place, "Figures 25–30: retardation functions", "what does not depend on speed "
    + "is much greater than what does, at 20 knots; the coarse mesh is off in the latter alone.",
  prose(`K does not depend on speed; U² Kᵁᵁ grows with its square, here at U = ${
    speedText(reportSpeed(ship))}. Both in units of Δr²g/L. ${TUCK} Kᵁᵁ₅₅ from B₃₃ and Kᵁᵁ₆₆ from `
    + "B₂₂. It makes Kᵁ of a mode with itself 0: left out here. The demo `report_figures` has it.",
  "p.note"));
  if (!data?.tau?.length) {
    grid.replaceWith(missing("The data has no retardation functions."));
    return;
  }
  const last = 20 * timeScale(ship);
  const x = { label: "τ", unit: "s", range: fromZero }, said = { symbol: "τ", unit: "s" };
  MODES.forEach((name, mode) => {
    const j = subscript(`${mode + 1}${mode + 1}`), figure = 25 + mode;
    const cell = h("div.stack");
    const K = kernelCurve(page, mode, last);
    grid.append(cell);
    if (!K) {
      cell.append(missing(`Figure ${figure}: the data has no K${j}.`));
      return;
    }
    plot(cell, { id: `report-${figure}`, title: `Fig. ${figure}  K${j} ${name}`, x,
      lines: [{ label: "K", ...K }] }, RETARDATION[mode].K, said);
    const squared = squaredKernelCurve(page, mode, K.x);
    if (!squared) return;
    const share = Math.abs(extremes(squared).value / extremes(K).value);
    plot(cell, { id: `report-${figure}-squared`, title: `Fig. ${figure}  U² Kᵁᵁ${j} ${name}`, x,
      height: 150, lines: [{ label: "U² Kᵁᵁ", colour: 1, ...squared }] },
    RETARDATION[mode].squared, { ...said,
      beyond: " By Tuck's theorem: the report's form differs here.",
      before: `${short(100 * share)} % of K at most. ` });
  });
}

const STILL = [
  ["heave", 34, "heave force", "heave", "m", "F₃/Δg − 1", ""],
  ["roll", 35, "roll arm", "roll", "°", "F₄/Δg", "m"],
  ["pitch", 36, "pitch arm", "pitch", "°", "F₅/Δg", "m"],
];

function buoyancy(place, page) {
  const grid = part(place, "Figures 34–36: buoyancy in still water", "small displacements follow "
    + "linear theory; in heave the force levels off with the hull out of the water or all in it; "
    + "the roll moment is odd and falls off at large angles; in pitch the slope falls as ends "
    + "emerge or go under.",
  h("p.note", {}, "The whole hull to the deck, held about G; from the pressure of calm water on "
    + `its triangles. Pitch is positive bow down.${isReportShip(page.ship) ? ""
      : " No bands on the arms: this hull has not the report's dimensions."}`));
  if (!page.ship.hull) {
    grid.replaceWith(missing("The data has no hull."));
    return;
  }
  for (const [kind, figure, name, label, unit, quantity, metres] of STILL) {
    const { x, y, linear } = buoyancyCurve(page, kind);
    const lines = [{ label: "pressure on the hull", x, y }];
    if (linear) lines.push({ label: "linear", colour: 1, dash: [6, 4], x, y: linear });
    const axis = kind === "heave" || isReportShip(page.ship) ? BUOYANCY[kind] : null;
    plot(grid, { id: `report-${figure}`, title: `Fig. ${figure}  ${name} ${quantity}`,
      x: { label, unit, symbol: label }, y: { unit: metres }, height: 220, lines }, axis,
    { symbol: label, unit });
  }
}

const ELSEWHERE = [
  ["Tables 3–5", "computing times and sizes of databases: the demo `report_figures` writes 3 "
    + "and 4."],
  ["Figures 3–5", "panel meshes: Panels, under The ship, shows this hull's."],
  ["Figure 6", "one point or four a panel: the demo `report_figures`."],
  ["Figures 7–12", "condition numbers and irregular frequencies, of three meshes: the demo "
    + "`report_figures`. A database solved with a lid has no such peaks."],
  ["Figures 13, 14", "limits of condition numbers: not needed with a lid."],
  ["Figures 31, 32", "points of the time domain: above, if the page has sweeps; the runs "
    + "`demos/runs/sweep_20kn_030.toml` and `sweep_20kn_150.toml` make them."],
  ["Figure 33", "a drawing of axes, without numbers."],
  ["Figures 37, 38", "heave and pitch in steep head seas: the demo `steep_head_seas`."],
];

function elsewhere(place) {
  place.append(h("h3", {}, "What this page does not draw"), h("ul", {},
    ELSEWHERE.map(([name, text]) => prose(`${name}: ${text}`, "li"))));
}

export function reportFigures(section, page) {
  const place = h("div");
  const element = h("details.run", { id: "report-figures" }, h("summary", {},
    h("strong", {}, "Figures of TM 2003-104"), "for this hull, beside the report's axes"), place);
  const parts = [tableTwo, damping, excitation, motions, retardation, buoyancy, elsewhere];
  element.addEventListener("toggle", () => {
    if (!element.open || place.childElementCount) return;
    for (const build of parts) build(place, page);
  });
  section.append(prose("McTaggart, DRDC Atlantic TM 2003-104 (2003), is the report that the "
    + "method follows. Its ship is a frigate of 124.5 m. Of its plots only the axes are known: "
    + "they are the faint bands, in the report's units, so that any hull can be laid beside them.",
  "p.lead"), element);
}
