// Motions: RAOs of the six modes, amplitude and phase, over frequency or wave length; a sweep's
// amplitudes from the time domain are points on them.
import { ABSCISSAE, abscissaAt, ascendingParts, sortedPoints, unwrapped }
  from "../analysis/curves.js";
import { encounter, isHeld, SLOWEST } from "../analysis/sea.js";
import { chips, choice, h, missing, prose, tick } from "./dom.js";
import { Figure, legendOf } from "./figure.js";
import { degrees } from "./format.js";
import { complexAt, DEGREES, MODES, phaseDegrees, rotates, title } from "./modes.js";

const DASHES = [undefined, [7, 4], [2, 3], [10, 3, 2, 3]];

const metresPerSecond = (speed) => `${Number(speed.toPrecision(3))} m/s`;

function sweepsOf(page) {
  return page.runs.filter(({ kind, sweep }) => kind === "sweep" && sweep);
}

// What is drawn at first: the sweeps' headings and speeds, else a few.
function firstChoice(page) {
  const sweeps = sweepsOf(page);
  const speeds = [...new Set(page.raos.map(({ speed }) => speed))];
  const all = [...new Set(page.raos.flatMap(({ headingsDeg }) => headingsDeg))];
  const alike = sweeps.filter(({ speed, mean }) =>
    speed === sweeps[0].speed && mean === sweeps[0].mean);
  let headings = [...new Set(alike.map(({ headingDeg }) => headingDeg))].slice(0, 4);
  if (!headings.length) headings = [180, 135, 90].filter((heading) => all.includes(heading));
  if (!headings.length) headings = all.slice(0, 1);
  const speed = sweeps.length ? sweeps[0].speed : speeds[0];
  const free = sweeps.length ? sweeps[0].mean === "free" : page.raos.some((rao) => rao.free);
  return {
    speeds, all: [...new Set([...all, ...sweeps.map(({ headingDeg }) => headingDeg)])]
      .sort((a, b) => a - b),
    headings: new Set(headings), chosenSpeeds: new Set([speed]), free, abscissa: "omega",
    phases: true,
  };
}

// Greatest amplitude of a mode over all headings and frequencies.
function greatestOf({ values, headingsDeg, omega, speed }, mode, gravity) {
  let most = 0;
  headingsDeg.forEach((headingDeg, k) => omega.forEach((w, i) => {
    if (!isHeld(mode, encounter(w, speed, headingDeg, gravity))) return;
    most = Math.max(most, Math.hypot(...complexAt(values, omega.length, k, i, mode)));
  }));
  return most;
}

// One table of RAOs at one heading as lines, without the frequencies at which there is no number.
function curvesOf(page, rao, heading, state, mode) {
  const at = rao.headingsDeg.indexOf(heading);
  if (at < 0) return null;
  const n = rao.omega.length;
  const about = { speed: rao.speed, headingDeg: heading, gravity: page.ship.gravity,
    length: page.ship.length };
  const motion = rao.omega.map((_, i) => complexAt(rao.values, n, at, i, mode));
  const scale = rotates(mode) ? DEGREES : 1;
  const x = rao.omega.map((omega) => abscissaAt(state.abscissa, omega, about));
  const held = rao.omega.map((omega) =>
    isHeld(mode, encounter(omega, rao.speed, heading, page.ship.gravity)));
  const amplitude = motion.map(([re, im], i) => (held[i] ? Math.hypot(re, im) * scale : null));
  const least = 1e-3 * scale * greatestOf(rao, mode, page.ship.gravity);
  const phases = motion.map((value, i) => (amplitude[i] > least ? phaseDegrees(value) : null));
  return { amplitude: ascendingParts(x, amplitude),
    phase: ascendingParts(x, phases).flatMap(unwrapped) };
}

function pointsOf(page, run, state, mode) {
  const { sweep } = run, scale = rotates(mode) ? DEGREES : 1;
  const rows = sweep.mode.map((j, i) => i).filter((i) => sweep.mode[i] === mode + 1
    && Number.isFinite(sweep.timeAmplitude[i]) && isHeld(mode, sweep.omegaE[i]));
  const about = { speed: run.speed, headingDeg: run.headingDeg, gravity: page.ship.gravity,
    length: page.ship.length };
  const x = rows.map((i) => abscissaAt(state.abscissa, sweep.omega[i], about));
  return {
    amplitude: sortedPoints(x, rows.map((i) => sweep.timeAmplitude[i] * scale)),
    phase: sortedPoints(x, rows.map((i) => sweep.timePhaseDeg[i])),
  };
}

// Lines of one mode: {amplitude: [...], phase: [...]} for the figures.
function linesOf(page, state, mode) {
  const lines = { amplitude: [], phase: [] };
  const headings = state.all.filter((heading) => state.headings.has(heading));
  headings.forEach((heading, colour) => {
    state.speeds.filter((speed) => state.chosenSpeeds.has(speed)).forEach((speed, dash) => {
      const name = state.chosenSpeeds.size > 1 ? `${degrees(heading)}, ${metresPerSecond(speed)}`
        : degrees(heading);
      const style = { label: name, group: name, colour, dash: DASHES[dash % DASHES.length],
        about: { headingDeg: heading, speed, free: state.free } };
      const rao = page.raos.find((set) => set.speed === speed && set.free === state.free);
      const curves = rao && curvesOf(page, rao, heading, state, mode);
      for (const kind of curves ? ["amplitude", "phase"] : []) {
        for (const part of curves[kind]) lines[kind].push({ ...style, ...part });
      }
      addPoints(page, state, mode, { heading, speed }, style, lines);
    });
  });
  return lines;
}

function addPoints(page, state, mode, { heading, speed }, style, lines) {
  for (const run of sweepsOf(page)) {
    const same = run.headingDeg === heading && Math.abs(run.speed - speed) < 1e-6
      && (run.mean === "free") === state.free;
    if (!same) continue;
    const points = pointsOf(page, run, state, mode);
    const label = `${style.label}, time domain`;
    for (const kind of ["amplitude", "phase"]) {
      lines[kind].push({ ...style, label, group: label, dash: undefined, points: true,
        ...points[kind] });
    }
  }
}

// One range of abscissae for amplitude and phase.
function rangeOf(lines) {
  const ends = lines.flatMap(({ x }) => [x[0], x.at(-1)]).filter(Number.isFinite);
  return ends.length ? () => [Math.min(...ends), Math.max(...ends)] : undefined;
}

function controls(state, page, update) {
  const kinds = [...new Set(page.raos.map(({ free }) => free))];
  return h("div.controls", {},
    chips("Headings", state.all.map((heading) => [heading, degrees(heading)]),
      state.headings, update),
    state.speeds.length > 1 ? chips("Speeds", state.speeds.map((u) => [u, metresPerSecond(u)]),
      state.chosenSpeeds, update) : h("span.control", {}, h("span.label", {}, "Speed"),
      metresPerSecond(state.speeds[0])),
    kinds.length > 1 ? choice("Ship", [["true", "free"], ["false", "on a fixed course"]],
      state.free, (value) => {
        state.free = value === "true";
        update();
      }) : null,
    choice("Over", ABSCISSAE.map(({ key, name }) => [key, name]), state.abscissa, (value) => {
      state.abscissa = value;
      update();
    }),
    tick("phases", state.phases, (on) => {
      state.phases = on;
      update();
    }));
}

const NOTE = "Amplitude per metre of wave amplitude. Phases are the lead over the crest at the "
  + "centre of gravity G; they are left out where the amplitude is below a thousandth of the "
  + "mode's greatest. Surge, sway and yaw are left out below |ωₑ| = "
  + `${SLOWEST} rad/s, where nothing holds them and linear theory has none.`
  + " Headings: 180° head seas, 90° beam seas from port, 0° following seas.";

export function motions(section, page) {
  if (!page.raos.length) {
    section.append(missing("The data has no RAOs."));
    return;
  }
  const state = firstChoice(page);
  const legend = h("div"), grid = h("div.grid.three");
  const figures = MODES.map((_, mode) => pair(grid, mode));
  const update = () => {
    const abscissa = ABSCISSAE.find(({ key }) => key === state.abscissa);
    const all = MODES.map((_, mode) => linesOf(page, state, mode));
    legend.replaceChildren(legendOf(all[2].amplitude));
    figures.forEach(({ amplitude, phase }, mode) => {
      const range = rangeOf(all[mode].amplitude);
      for (const figure of [amplitude, phase]) figure.spec.x = { ...abscissa, range };
      amplitude.setLines(all[mode].amplitude);
      phase.element.hidden = !state.phases;
      phase.setLines(all[mode].phase);
    });
  };
  section.append(prose(NOTE, "p.lead"), controls(state, page, update), legend, grid);
  if (!sweepsOf(page).length) {
    section.append(missing("No points of the time domain: give `cutwater report` a sweep's run "
      + "file, `cutwater report DB.h5 SWEEP.toml`."));
  }
  update();
}

function pair(grid, mode) {
  const place = h("div");
  grid.append(place);
  const name = MODES[mode];
  const common = { x: ABSCISSAE[0], legend: false, empty: "Choose a heading and a speed above." };
  return {
    amplitude: new Figure(place, { ...common, id: `rao-${name}`, title: title(name), height: 200,
      y: { label: "", unit: rotates(mode) ? "°/m" : "m/m", least: 0.01 } }),
    phase: new Figure(place, { ...common, id: `rao-${name}-phase`, title: `${title(name)}, phase`,
      height: 150, y: { label: "", unit: "°", exponent: 0, range: [-180, 180],
        incrs: [90, 180] } }),
  };
}
