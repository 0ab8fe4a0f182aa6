// What the replay shows in words and numbers over its picture: readouts, the scene, legends, a
// rule.
import { make, setText } from "./dom.js";

const READOUTS = [
  ["t", "time", "s"], ["heave", "heave", "m"], ["roll", "roll", "°"], ["pitch", "pitch", "°"],
  ["speed", "speed", "m/s"], ["zeta", "wave at G", "m"],
];

/// Numbers of the body in view; `set` takes {t, heave, roll, ...} as text.
export function makeReadout() {
  const node = make("div", { class: "cw-panel cw-read", "aria-hidden": "true" });
  const cells = {};
  for (const [key, name, unit] of READOUTS) {
    cells[key] = make("b");
    node.append(make("span", {}, name), cells[key], make("span", {}, unit));
  }
  return {
    node,
    set(words) {
      for (const [key, value] of Object.entries(words)) {
        setText(cells[key], value.replace("-", "−"));
      }
    },
  };
}

const options = (names) => names.map((name, i) => make("option", { value: i }, name));

/// Lists of scenes and of the scene's bodies, shown where there is a choice, and the sea in words.
export function makeAbout(scenes, act) {
  const chosen = (tell) => (event) => tell(Number(event.target.value));
  const sceneList =
    make("select", { "aria-label": "Scene", onchange: chosen(act.scene) }, ...options(scenes));
  const bodyList = make("select", { "aria-label": "Body in view", onchange: chosen(act.body) });
  const sea = make("small");
  sceneList.hidden = scenes.length < 2;
  return {
    node: make("div", { class: "cw-panel cw-about" }, sceneList, " ", bodyList, sea),
    setScene(index, bodies, seaText) {
      sceneList.value = String(index);
      bodyList.replaceChildren(...options(bodies));
      bodyList.hidden = bodies.length < 2;
      setText(sea, seaText);
    },
    setBody(i) {
      bodyList.value = String(i);
    },
  };
}

function pressureLegend({ top, colours }) {
  const ramp = make("div", { class: "cw-ramp" });
  ramp.style.background = `linear-gradient(90deg, ${colours.join(", ")})`;
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((f) =>
    make("span", {}, String(Number((f * top).toPrecision(3)))));
  return make("div", {}, make("div", {}, "pressure of the water, kPa"), ramp,
    make("div", { class: "cw-ticks" }, ...ticks));
}

function forcesLegend({ rows, text }) {
  const cells = rows.flatMap(({ colour, name, value }) => {
    const dot = make("i");
    dot.style.background = colour;
    return [make("span", {}, dot, name), make("b", {}, value)];
  });
  return make("div", {}, make("div", { class: "cw-parts" }, ...cells), make("small", {}, text));
}

/// Legends of pressure and forces; `set` takes stage.js's.
export function makeLegend() {
  const node = make("div", { class: "cw-panel cw-legend" });
  return {
    node,
    set({ pressure, forces }) {
      const blocks = [];
      if (pressure) blocks.push(pressureLegend(pressure));
      if (forces) blocks.push(forcesLegend(forces));
      node.replaceChildren(...blocks);
    },
  };
}

/// A length in the picture at the distance of G.
export function makeRule() {
  const bar = make("div");
  const text = make("span");
  const node = make("div", { class: "cw-panel cw-rule" }, text, bar);
  return {
    node,
    set({ pixels, metres }) {
      node.hidden = !(pixels > 0);
      bar.style.width = `${pixels.toFixed(0)}px`;
      setText(text, `${metres} m, at G`);
    },
  };
}
