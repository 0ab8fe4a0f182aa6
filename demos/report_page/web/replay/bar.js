// The bar of controls below the picture: play, time, speed, cameras, what is shown, full screen.
import { h } from "../element.js";
import { clock, setText } from "./dom.js";

export const SPEEDS = [0.25, 0.5, 1, 2, 5, 10];
const SPEED_NAMES = ["¼ speed", "½ speed", "real speed", "2 ×", "5 ×", "10 ×"];
const CAMERA_NAMES = { follow: "Follow", orbit: "Orbit", bridge: "Bridge" };
const GAINS = [1, 4, 16, 64];

/// Key in `show`, what the menu says, letter of the keyboard.
export const OVERLAYS = [
  ["waterline", "waterline", "w"], ["pressure", "pressure on the wetted hull", "p"],
  ["forces", "force arrows", "f"], ["centre", "centre of gravity G", "g"],
  ["track", "track over ground", "k"], ["glass", "see-through water", "t"],
  ["decoration", "superstructure (decoration)", "d"],
];

const ICON = '<svg width="13" height="13" viewBox="0 0 13 13" fill="none" stroke="currentColor" ' +
  'stroke-width="1.6"><path d="M1 4.5V1h3.5M8.5 1H12v3.5M12 8.5V12H8.5M4.5 12H1V8.5"/></svg>';

const valueTo = (tell) => (event) => tell(Number(event.target.value));

function choice(label, values, names, tell) {
  return h("select", { "aria-label": label, onchange: valueTo(tell) },
    ...values.map((value, i) => h("option", { value }, names[i])));
}

/// One button a camera; `buttons` is filled by kind.
function cameraSet(act, buttons) {
  const made = Object.entries(CAMERA_NAMES).map(([kind, name], i) => {
    const button = h("button",
      { type: "button", title: `key ${i + 1}`, onclick: () => act.camera(kind) }, name);
    buttons.set(kind, button);
    return button;
  });
  return h("span", { class: "cw-set", role: "group", "aria-label": "Camera" }, ...made);
}

/// One box an overlay; `boxes` is filled by key.
function overlayMenu(act, boxes, gain) {
  const labels = OVERLAYS.map(([key, name, letter]) => {
    const box = h("input",
      { type: "checkbox", onchange: (event) => act.overlay(key, event.target.checked) });
    boxes.set(key, box);
    return h("label", { title: `key ${letter}` }, box, ` ${name}`);
  });
  return h("details", {}, h("summary", {}, "Show"),
    h("div", { class: "cw-menu" }, ...labels, gain));
}

function fullScreenButton(act) {
  const button = h("button",
    { type: "button", title: "Full screen", "aria-label": "Full screen", onclick: act.full });
  button.innerHTML = ICON;
  return button;
}

/// act: see controls.js.
export function makeBar(act) {
  const cameras = new Map();
  const boxes = new Map();
  const play = h("button", { class: "cw-play", type: "button", title: "Space",
    onclick: act.toggle });
  const slider = h("input", { type: "range", min: 0, max: 1, step: "any",
    "aria-label": "Time", oninput: valueTo(act.seek) });
  const time = h("span", { class: "cw-time" });
  const speed = choice("Speed of the replay", SPEEDS, SPEED_NAMES, act.speed);
  const gain = choice("Length of the arrows", GAINS, GAINS.map((g) => `arrows ${g} ×`), act.gain);
  return {
    node: h("div", { class: "cw-panel cw-bar" }, play, slider, time, speed,
      cameraSet(act, cameras), overlayMenu(act, boxes, gain), fullScreenButton(act)),
    setRange(start, end) {
      slider.min = start;
      slider.max = end;
    },
    setTime(t, end) {
      if (Number(slider.value) !== t) slider.value = t;
      slider.setAttribute("aria-valuetext", `${t.toFixed(1)} s`);
      setText(time, `${clock(t)} / ${clock(end)}`);
    },
    setPlaying(playing) {
      setText(play, playing ? "❚❚ Pause" : "▶ Play");
      play.setAttribute("aria-label", playing ? "Pause" : "Play");
    },
    setSpeed(s) {
      speed.value = String(s);
    },
    setCamera(kind) {
      cameras.forEach((button, name) =>
        button.setAttribute("aria-pressed", String(name === kind)));
    },
    setOverlay(key, on, possible) {
      boxes.get(key).checked = on;
      boxes.get(key).disabled = !possible;
    },
    setGain(g, shown) {
      gain.value = String(g);
      gain.hidden = !shown;
    },
  };
}
