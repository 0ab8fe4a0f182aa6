// The replay's own controls and readouts: buttons, time slider, legends, keys. No drawing in three
// dimensions here; replay.js is told what the user wants.

export const SPEEDS = [0.25, 0.5, 1, 2, 5, 10];

const make = (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (value === true) node.setAttribute(key, "");
    else if (value !== false && value !== null) node.setAttribute(key, value);
  }
  node.append(...children);
  return node;
};

export const OVERLAYS = [
  ["waterline", "waterline", "w"],
  ["pressure", "pressure on the wetted hull", "p"],
  ["forces", "force arrows", "f"],
  ["centre", "centre of gravity G", "g"],
  ["track", "track over ground", "k"],
  ["glass", "see-through water", "t"],
  ["decoration", "superstructure (decoration)", "d"],
];

const clock = (t) => {
  const sign = t < 0 ? "-" : "";
  const s = Math.abs(t);
  const h = Math.floor(s / 3600);
  const m = Math.floor((s % 3600) / 60);
  const rest = (s % 60).toFixed(1).padStart(4, "0");
  return h > 0 ? `${sign}${h}:${String(m).padStart(2, "0")}:${rest}` : `${sign}${m}:${rest}`;
};

/// act: {toggle, seek, speed, camera, overlay, scene, body, gain, key} are called with the user's
/// wishes; names of scenes come in `scenes`.
export function makeControls(root, scenes, act) {
  const canvas = make("canvas", {
    tabindex: "0",
    role: "img",
    "aria-label":
      "The ship in its sea. Space plays and pauses, arrow keys move in time, " +
      "1 to 3 choose the camera, plus and minus change the speed, h hides the controls.",
  });
  const read = make("div", { class: "cw-panel cw-read", "aria-hidden": "true" });
  const cells = {};
  for (const [key, name, unit] of [
    ["t", "time", "s"],
    ["heave", "heave", "m"],
    ["roll", "roll", "°"],
    ["pitch", "pitch", "°"],
    ["speed", "speed", "m/s"],
    ["zeta", "wave at G", "m"],
  ]) {
    cells[key] = make("b");
    read.append(make("span", {}, name), cells[key], make("span", {}, unit));
  }
  const sceneList = make(
    "select",
    { "aria-label": "Scene", onchange: (e) => act.scene(Number(e.target.value)) },
    ...scenes.map((name, i) => make("option", { value: i }, name)),
  );
  const bodyList = make("select", {
    "aria-label": "Body in view",
    onchange: (e) => act.body(Number(e.target.value)),
  });
  const about = make("small");
  const aboutPanel = make("div", { class: "cw-panel cw-about" });
  sceneList.hidden = scenes.length < 2;
  aboutPanel.append(sceneList, " ", bodyList, about);
  const legend = make("div", { class: "cw-panel cw-legend" });
  const ruleBar = make("div");
  const ruleText = make("span");
  const rule = make("div", { class: "cw-panel cw-rule" }, ruleText, ruleBar);

  const play = make("button", {
    class: "cw-play",
    type: "button",
    title: "Space",
    onclick: () => act.toggle(),
  });
  const slider = make("input", {
    type: "range",
    min: 0,
    max: 1000,
    step: "any",
    "aria-label": "Time",
    oninput: (e) => act.seek(Number(e.target.value)),
  });
  const time = make("span", { class: "cw-time" });
  const speed = make(
    "select",
    { "aria-label": "Speed of the replay", onchange: (e) => act.speed(Number(e.target.value)) },
    ...SPEEDS.map((s) =>
      make(
        "option",
        { value: s },
        s === 0.25 ? "¼ speed" : s === 0.5 ? "½ speed" : s === 1 ? "real speed" : `${s} ×`,
      ),
    ),
  );
  const cameraButtons = new Map();
  const cameras = make(
    "span",
    { class: "cw-set", role: "group", "aria-label": "Camera" },
    ...[
      ["follow", "Follow"],
      ["orbit", "Orbit"],
      ["bridge", "Bridge"],
    ].map(([kind, name], i) => {
      const button = make(
        "button",
        { type: "button", title: `key ${i + 1}`, onclick: () => act.camera(kind) },
        name,
      );
      cameraButtons.set(kind, button);
      return button;
    }),
  );
  const boxes = new Map();
  const menu = make(
    "div",
    { class: "cw-menu" },
    ...OVERLAYS.map(([key, name, letter]) => {
      const box = make("input", {
        type: "checkbox",
        onchange: (e) => act.overlay(key, e.target.checked),
      });
      boxes.set(key, box);
      return make("label", { title: `key ${letter}` }, box, ` ${name}`);
    }),
  );
  const gain = make(
    "select",
    { "aria-label": "Length of the arrows", onchange: (e) => act.gain(Number(e.target.value)) },
    ...[1, 4, 16, 64].map((g) => make("option", { value: g }, `arrows ${g} ×`)),
  );
  menu.append(gain);
  const full = make("button", {
    type: "button",
    title: "Full screen",
    onclick: () =>
      document.fullscreenElement ? document.exitFullscreen() : box.requestFullscreen?.(),
  });
  full.innerHTML =
    '<svg width="13" height="13" viewBox="0 0 13 13" fill="none" stroke="currentColor" ' +
    'stroke-width="1.6"><path d="M1 4.5V1h3.5M8.5 1H12v3.5M12 8.5V12H8.5M4.5 12H1V8.5"/></svg>';
  full.setAttribute("aria-label", "Full screen");
  const bar = make(
    "div",
    { class: "cw-panel cw-bar" },
    play,
    slider,
    time,
    speed,
    cameras,
    make("details", {}, make("summary", {}, "Show"), menu),
    full,
  );
  const box = make("div", { class: "cw-replay" }, canvas, read, aboutPanel, legend, rule, bar);
  const note = make("p", { class: "cw-note" });
  root.replaceChildren(box, note);

  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const tag = event.target.tagName;
    if (tag === "SELECT") return;
    if (
      event.key === " " &&
      (tag === "BUTTON" || tag === "SUMMARY" || event.target.type === "checkbox")
    )
      return;
    if (tag === "INPUT" && event.target.type === "range" && event.key.startsWith("Arrow")) return;
    if (act.key(event)) event.preventDefault();
  });

  const text = (node, value) => {
    if (node.textContent !== value) node.textContent = value;
  };
  return {
    box,
    canvas,
    legend,
    setScene({ index, start, end, bodies, seaText, note: noteText }) {
      sceneList.value = String(index);
      bodyList.replaceChildren(...bodies.map((name, i) => make("option", { value: i }, name)));
      bodyList.hidden = bodies.length < 2;
      text(about, seaText);
      slider.min = start;
      slider.max = end;
      text(note, noteText);
    },
    setTime(t, end, words) {
      if (document.activeElement !== slider || Number(slider.value) !== t) slider.value = t;
      slider.setAttribute("aria-valuetext", `${t.toFixed(1)} s`);
      text(time, `${clock(t)} / ${clock(end)}`);
      for (const [key, value] of Object.entries(words)) text(cells[key], value.replace("-", "−"));
    },
    setPlaying(playing) {
      text(play, playing ? "❚❚ Pause" : "▶ Play");
      play.setAttribute("aria-label", playing ? "Pause" : "Play");
    },
    setSpeed: (s) => {
      speed.value = String(s);
    },
    setCamera(kind) {
      for (const [name, button] of cameraButtons)
        button.setAttribute("aria-pressed", String(name === kind));
    },
    setOverlay(key, on, possible = true) {
      boxes.get(key).checked = on;
      boxes.get(key).disabled = !possible;
    },
    setGain(g, shown) {
      gain.value = String(g);
      gain.hidden = !shown;
    },
    setBody: (i) => {
      bodyList.value = String(i);
    },
    setRule(pixels, metres) {
      rule.hidden = !(pixels > 0);
      ruleBar.style.width = `${pixels.toFixed(0)}px`;
      text(ruleText, `${metres} m, at G`);
    },
    setLegend({ pressure, forces }) {
      const blocks = [];
      if (pressure) {
        const ramp = make("div", { class: "cw-ramp" });
        ramp.style.background = `linear-gradient(90deg, ${pressure.colours.join(", ")})`;
        blocks.push(
          make(
            "div",
            {},
            make("div", {}, "pressure of the water, kPa"),
            ramp,
            make(
              "div",
              { class: "cw-ticks" },
              ...[0, 0.25, 0.5, 0.75, 1].map((f) =>
                make("span", {}, String(Number((f * pressure.top).toPrecision(3)))),
              ),
            ),
          ),
        );
      }
      if (forces) {
        const rows = forces.rows.flatMap(({ colour, name, value }) => {
          const dot = make("i");
          dot.style.background = colour;
          return [make("span", {}, dot, name), make("b", {}, value)];
        });
        blocks.push(
          make(
            "div",
            {},
            make("div", { class: "cw-parts" }, ...rows),
            make("small", {}, forces.text),
          ),
        );
      }
      legend.replaceChildren(...blocks);
    },
  };
}
