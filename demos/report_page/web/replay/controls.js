// The replay's own controls and readouts, put together: canvas, panels, bar, the note below. No
// drawing in three dimensions here; replay.js is told what the user wants.
import { makeBar } from "./bar.js";
import { h } from "../element.js";
import { setText } from "./dom.js";
import { makeAbout, makeLegend, makeReadout, makeRule } from "./panels.js";

const LABEL = "The ship in its sea. Space plays and pauses, arrow keys move in time, 1 to 3 " +
  "choose the camera, plus and minus change the speed, h hides the controls.";

/// Whether the focused control needs the key itself.
function takesKey({ tagName, type }, key) {
  if (tagName === "SELECT") return true;
  if (key === " ") return tagName === "BUTTON" || tagName === "SUMMARY" || type === "checkbox";
  return type === "range" && key.startsWith("Arrow");
}

/// act: functions {toggle, seek, speed, camera, overlay, scene, body, gain, key} that are called
/// with the user's wishes; key says whether it knew the key. scenes: names.
export function makeControls(root, scenes, act) {
  const canvas = h("canvas", { tabindex: "0", role: "img", "aria-label": LABEL });
  const full = () =>
    (document.fullscreenElement ? document.exitFullscreen() : box.requestFullscreen?.());
  const readout = makeReadout();
  const about = makeAbout(scenes, act);
  const legend = makeLegend();
  const rule = makeRule();
  const bar = makeBar({ ...act, full });
  const box = h("div", { class: "cw-replay" }, canvas,
    ...[readout, about, legend, rule, bar].map(({ node }) => node));
  const note = h("p", { class: "cw-note" });
  root.replaceChildren(box, note);
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!takesKey(event.target, event.key) && act.key(event)) event.preventDefault();
  });
  return {
    box, canvas, readout, about, legend, rule, bar,
    get size() {
      return [box.clientWidth, box.clientHeight];
    },
    hide: () => box.classList.toggle("cw-bare"),
    setNote: (text) => setText(note, text),
  };
}
