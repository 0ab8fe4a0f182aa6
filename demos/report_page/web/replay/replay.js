// The replay: the ships of a run in their sea. createReplay draws in an element with its own
// controls; what moves is the run's numbers, what only looks (sky, ripples, superstructure) is not.
import * as THREE from "three";
import { makeCameras, CAMERAS } from "./cameras.js";
import { makeControls, OVERLAYS, SPEEDS } from "./controls.js";
import { aimSun, makeLight, makeSky } from "./light.js";
import { groupRuns, sceneOfRuns, scenesWithoutRuns } from "./scenes.js";
import { chooseQuality, QUALITIES } from "./quality.js";
import { makeStage } from "./stage.js";
import { elevation } from "./wave.js";

function makeRenderer(canvas, quality) {
  const renderer = new THREE.WebGLRenderer({
    canvas,
    antialias: quality.antialias,
    alpha: false,
    powerPreference: "high-performance",
  });
  if (!renderer.getContext().getExtension("EXT_color_buffer_float")) {
    renderer.dispose();
    throw new Error(
      "this browser's WebGL cannot draw into float textures (EXT_color_buffer_float).",
    );
  }
  renderer.info.autoReset = true;
  renderer.sortObjects = true;
  return renderer;
}

const RUN = "Heights and slopes of the sea, positions and attitudes are the run's own numbers. ";
const NOTE =
  "Decoration: light, sky, ripples shorter than the run's waves, paint and superstructure. " +
  "Left out: the wake, the waves that the ship makes, spray and foam.";

/// Names and makers of all scenes of a page.
function listScenes(page) {
  const groups = groupRuns(page.runs ?? []);
  if (groups.length > 0) {
    return groups.map((runs) => ({
      title: runs.map(({ name }) => name).join(", "),
      make: () => sceneOfRuns(runs, page),
    }));
  }
  return scenesWithoutRuns(page).map((scene) => ({ title: scene.title, make: async () => scene }));
}

/// Draws the replay of `page` (data.js: readPage) in `element`. Throws where WebGL 2 with float
/// textures is missing. `seek` has drawn when it returns.
export async function createReplay(element, page) {
  const scenes = listScenes(page);
  let request = 0; // of the next frame; 0 while nothing changes
  const view = {
    t: 0,
    speed: 1,
    playing: false,
    scene: 0,
    body: 0,
    gain: null,
    dirty: true,
    visible: true,
    show: {
      waterline: false,
      pressure: false,
      forces: false,
      centre: false,
      track: false,
      glass: false,
      decoration: true,
    },
    gone: false,
    cost: 0,
  };
  const controls = makeControls(
    element,
    scenes.map(({ title }) => title),
    {
      toggle: () => (view.playing ? pause() : play()),
      seek: (t) => setTime(t),
      speed: (s) => setSpeed(s),
      camera: (kind) => setCamera(kind),
      overlay: (key, on) => setOverlay(key, on),
      scene: (i) => openScene(i),
      body: (i) => setBody(i),
      gain: (g) => {
        stage.setGain(g);
        touch();
      },
      key: (event) => onKey(event),
    },
  );
  const renderer = await startRenderer(controls.canvas, element);
  let quality = renderer.quality;
  const light = makeLight();
  const sky = makeSky(light);
  const camera = new THREE.PerspectiveCamera(40, 16 / 9, 0.5, 90000);
  const cameras = makeCameras(camera, controls.canvas, () => {
    touch();
  });
  let stage = null;
  let current = null;

  async function openScene(index) {
    current = await scenes[index].make();
    if (view.gone) return;
    view.scene = index;
    buildStage();
    aimSun(
      light,
      (current.bodies[0].track.at(current.start).yaw * Math.PI) / 180 + stage.sunBearing,
    );
    setBody(0);
    setTime(
      Math.min(current.end, Math.max(current.start, current.start + 2 * (current.sea.ramp ?? 0))),
    );
    controls.setScene({
      index,
      start: current.start,
      end: current.end,
      seaText: current.seaText,
      bodies: current.bodies.map(({ name }) => name),
      note: [...current.faults.map((f) => `Not shown: ${f}.`), current.note || RUN, NOTE].join(" "),
    });
  }

  function buildStage() {
    stage?.dispose();
    stage = makeStage({
      renderer: renderer.three,
      scene: current,
      light,
      sky,
      camera,
      quality,
      changed: () => {
        touch();
      },
    });
    for (const [key] of OVERLAYS) setOverlay(key, view.show[key]);
    resize();
  }

  function setTime(t) {
    view.t = Math.min(current.end, Math.max(current.start, t));
    touch();
  }
  function setSpeed(s) {
    view.speed = s;
    controls.setSpeed(s);
  }
  function setCamera(kind) {
    cameras.state.kind = kind;
    controls.setCamera(kind);
    touch();
  }
  function setBody(i) {
    view.body = i;
    stage.setBody(i);
    cameras.state.length = stage.lengthOf(i);
    controls.setBody(i);
    touch();
  }
  function setOverlay(key, on) {
    const possible = stage.can(key);
    view.show[key] = on;
    controls.setOverlay(key, on && possible, possible);
    // Pressure on a hull is seen through the water.
    stage.setShow({ ...view.show, glass: view.show.glass || view.show.pressure });
    controls.setGain(stage.gain, view.show.forces && stage.can("forces"));
    touch();
  }
  function play() {
    if (view.t >= current.end) setTime(current.start);
    view.playing = true;
    last = performance.now();
    controls.setPlaying(true);
    wake();
  }
  function pause() {
    view.playing = false;
    controls.setPlaying(false);
  }

  function onKey(event) {
    const step = (event.shiftKey ? 10 : 1) * (view.playing ? 5 : 1);
    const speedBy = (n) =>
      setSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(view.speed) + n))]);
    const camera = CAMERAS[Number(event.key) - 1];
    const overlay = OVERLAYS.find(([, , letter]) => letter === event.key.toLowerCase());
    const keys = {
      " ": () => (view.playing ? pause() : play()),
      ArrowLeft: () => setTime(view.t - step),
      ArrowRight: () => setTime(view.t + step),
      Home: () => setTime(current.start),
      End: () => setTime(current.end),
      ArrowUp: () => cameras.turnBy(0, 15),
      ArrowDown: () => cameras.turnBy(0, -15),
      "[": () => cameras.turnBy(20, 0),
      "]": () => cameras.turnBy(-20, 0),
      PageUp: () => cameras.scaleBy(0.87),
      PageDown: () => cameras.scaleBy(1.15),
      h: () => controls.box.classList.toggle("cw-bare"),
      "+": () => speedBy(1),
      "=": () => speedBy(1),
      "-": () => speedBy(-1),
    };
    const act =
      keys[event.key] ??
      (camera && (() => setCamera(camera))) ??
      (overlay && (() => setOverlay(overlay[0], !view.show[overlay[0]])));
    act?.();
    return Boolean(act);
  }

  function resize() {
    const { clientWidth: w, clientHeight: h } = controls.box;
    if (w === 0 || h === 0) return;
    const ratio = Math.min(window.devicePixelRatio || 1, quality.pixelRatio);
    renderer.three.setPixelRatio(ratio);
    renderer.three.setSize(w, h, false);
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
    touch();
  }

  function draw() {
    const began = performance.now();
    const state = stage.draw(view.t, cameras, [
      controls.box.clientWidth,
      controls.box.clientHeight,
    ]);
    const g = state.pose.position;
    controls.setTime(view.t, current.end, {
      t: view.t.toFixed(1),
      heave: (g[2] - current.bodies[view.body].cogZ).toFixed(2),
      roll: state.pose.roll.toFixed(1),
      pitch: state.pose.pitch.toFixed(1),
      speed: Number.isFinite(state.speed) ? state.speed.toFixed(1) : "–",
      zeta: elevation(current.sea, view.t, g[0], g[1]).toFixed(2),
    });
    controls.setRule(state.rule.pixels, state.rule.metres);
    controls.setLegend(state.legend);
    view.dirty = false;
    view.cost = performance.now() - began;
  }

  let last = performance.now();
  let slow = 0;
  function frame(now) {
    request = 0;
    if (view.gone) return;
    const dt = Math.min(0.25, (now - last) / 1000);
    last = now;
    if (view.playing) {
      setTime(view.t + dt * view.speed);
      if (view.t >= current.end) pause();
      judge(dt);
    }
    if (view.dirty && view.visible) draw();
    if (view.playing) wake();
  }
  /// What is seen is no longer true.
  function touch() {
    view.dirty = true;
    wake();
  }
  function wake() {
    if (request === 0 && !view.gone) request = requestAnimationFrame(frame);
  }
  /// Lower quality once frames have been slow for a while, unless the address asks for one.
  function judge(dt) {
    slow = dt > 0.042 ? slow + 1 : Math.max(0, slow - 2);
    if (slow < 40 || quality.asked || quality.name === "low") return;
    slow = 0;
    quality = { ...QUALITIES.low, asked: false };
    buildStage();
    setBody(view.body);
  }

  const sizes = new ResizeObserver(resize);
  sizes.observe(controls.box);
  const sight = new IntersectionObserver(([entry]) => {
    view.visible = entry.isIntersecting;
    last = performance.now();
    if (view.dirty) wake();
  });
  sight.observe(controls.box);
  await openScene(0);
  setCamera("follow");
  setSpeed(1);
  controls.setPlaying(false);
  draw();
  const still = window.matchMedia?.("(prefers-reduced-motion: reduce)").matches || quality.software;
  if (!still) play();
  wake();

  return {
    destroy() {
      view.gone = true;
      cancelAnimationFrame(request);
      sizes.disconnect();
      sight.disconnect();
      cameras.dispose();
      stage.dispose();
      renderer.three.dispose();
      element.replaceChildren();
    },
    /// Goes to t [s] and draws.
    seek(t) {
      setTime(t);
      draw();
    },
    play,
    pause,
    time: () => view.t,
    debug: {
      /// Height [m] at earth x, y that the texture holds for a vertex laid there, at the time
      /// drawn.
      surfaceAt: (x, y) => stage.surfaceAt(x, y),
      /// The greatest difference [m] from the formula of n vertices of the fine square, as drawn.
      worstVertex: (n = 500) => stage.worstVertex(view.t, n),
      scene: openScene,
      camera: setCamera,
      cameras: cameras.state,
      overlay: setOverlay,
      body: setBody,
      scenes: scenes.map(({ title }) => title),
      state: () => ({ ...view, quality: quality.name, vertices: stage.vertices }),
    },
  };

  async function startRenderer(canvas, host) {
    const chosen = chooseQuality(window.location.search);
    try {
      const three = makeRenderer(canvas, chosen);
      return { three, quality: chosen };
    } catch (error) {
      host.replaceChildren();
      throw error;
    }
  }
}
