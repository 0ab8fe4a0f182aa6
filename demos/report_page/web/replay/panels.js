// What the replay shows in words and numbers over its picture: readouts, the scene, legends, a
// rule.
import { h } from "../element.js";
import { setText } from "./dom.js";

const READOUTS = [
  ["t", "time", "s"], ["heave", "heave", "m"], ["roll", "roll", "°"], ["pitch", "pitch", "°"],
  ["speed", "speed", "m/s"], ["zeta", "wave at G", "m"],
];

/// Numbers of the body in view; `set` takes {t, heave, roll, ...} as text.
export function makeReadout() {
  const node = h("div", { class: "cw-panel cw-read", "aria-hidden": "true" });
  const cells = {};
  for (const [key, name, unit] of READOUTS) {
    cells[key] = h("b");
    node.append(h("span", {}, name), cells[key], h("span", {}, unit));
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

const options = (names) => names.map((name, i) => h("option", { value: i }, name));

/// Lists of scenes and of the scene's bodies, shown where there is a choice, and the sea in words.
export function makeAbout(scenes, act) {
  const chosen = (tell) => (event) => tell(Number(event.target.value));
  const sceneList =
    h("select", { "aria-label": "Scene", onchange: chosen(act.scene) }, ...options(scenes));
  const bodyList = h("select", { "aria-label": "Body in view", onchange: chosen(act.body) });
  const sea = h("small");
  sceneList.hidden = scenes.length < 2;
  return {
    node: h("div", { class: "cw-panel cw-about" }, sceneList, " ", bodyList, sea),
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
  const ramp = h("div", { class: "cw-ramp" });
  ramp.style.background = `linear-gradient(90deg, ${colours.join(", ")})`;
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((f) =>
    h("span", {}, String(Number((f * top).toPrecision(3)))));
  return h("div", {}, h("div", {}, "pressure of the water, kPa"), ramp,
    h("div", { class: "cw-ticks" }, ...ticks));
}

function forcesLegend({ rows, text }) {
  const cells = rows.flatMap(({ colour, name, value }) => {
    const dot = h("i");
    dot.style.background = colour;
    return [h("span", {}, dot, name), h("b", {}, value)];
  });
  return h("div", {}, h("div", { class: "cw-parts" }, ...cells), h("small", {}, text));
}

/// Legends of pressure and forces; `set` takes stage.js's.
export function makeLegend() {
  const node = h("div", { class: "cw-panel cw-legend" });
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
  const bar = h("div");
  const text = h("span");
  const node = h("div", { class: "cw-panel cw-rule" }, text, bar);
  return {
    node,
    set({ pixels, metres }) {
      node.hidden = !(pixels > 0);
      bar.style.width = `${pixels.toFixed(0)}px`;
      setText(text, `${metres} m, at G`);
    },
  };
}
