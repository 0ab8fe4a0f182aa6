// The replay: the ships of a run in their sea. createReplay draws in an element with its own
// controls; what moves is the run's numbers, what only looks (sky, ripples, superstructure) is not.
import * as THREE from "three";
import { OVERLAYS, SPEEDS } from "./bar.js";
import { CAMERAS, makeCameras } from "./cameras.js";
import { makeControls } from "./controls.js";
import { aimSun, makeLight, makeSky } from "./light.js";
import { chooseQuality, QUALITIES } from "./quality.js";
import { groupRuns, sceneOfRuns, scenesWithoutRuns } from "./scenes.js";
import { Stage, SUN_BEARING } from "./stage.js";
import { elevation } from "./wave.js";

const OF_THE_RUN =
  "Heights and slopes of the sea, positions and attitudes are the run's own numbers.";
const NOTE = "Decoration: light, sky, ripples shorter than the run's waves, paint and " +
  "superstructure. Left out: the wake, the waves that the ship makes, spray and foam.";

function makeRenderer(canvas, quality) {
  const renderer = new THREE.WebGLRenderer({
    canvas, antialias: quality.antialias, alpha: false, powerPreference: "high-performance",
  });
  if (renderer.getContext().getExtension("EXT_color_buffer_float")) return renderer;
  renderer.dispose();
  throw new Error("this browser's WebGL cannot draw into float textures (EXT_color_buffer_float)");
}

/// Names of two runs, or of the first ship and how many more.
function titleOf(runs) {
  const names = runs.map(({ name }) => name);
  if (names.length < 3) return names.join(", ");
  const { name } = runs.find(({ body }) => !body) ?? runs[0];
  return `${name} and ${names.length - 1} more`;
}

/// Names and makers of all scenes of a page.
function listScenes(page) {
  const groups = groupRuns(page.runs ?? []);
  if (groups.length > 0) {
    return groups.map((runs) => ({
      title: titleOf(runs), make: () => sceneOfRuns(runs, page),
    }));
  }
  return scenesWithoutRuns(page).map((scene) => ({ title: scene.title, make: async () => scene }));
}

/// v with d decimals, without a sign of zero.
const fixed = (v, d) => v.toFixed(d).replace(/^-(0(\.0*)?)$/, "$1");

const clamp = (v, low, high) => Math.min(high, Math.max(low, v));

class Replay {
  constructor(element, page) {
    this.element = element;
    this.scenes = listScenes(page);
    this.quality = chooseQuality(window.location.search);
    Object.assign(this, {
      t: 0, speed: 1, playing: false, body: 0, dirty: true, visible: true, gone: false,
      request: 0, last: 0, slow: 0, fence: null, stage: null, scene: null,
    });
    this.show = Object.fromEntries(OVERLAYS.map(([key]) => [key, key === "decoration"]));
    this.controls = makeControls(element, this.scenes.map(({ title }) => title), this.wishes());
    this.renderer = makeRenderer(this.controls.canvas, this.quality);
    this.light = makeLight();
    this.sky = makeSky(this.light);
    this.camera = new THREE.PerspectiveCamera(40, 16 / 9, 0.5, 90000);
    this.cameras = makeCameras(this.camera, this.controls.canvas, () => this.touch());
  }

  /// What the controls call.
  wishes() {
    return {
      toggle: () => (this.playing ? this.pause() : this.play()),
      seek: (t) => this.setTime(t),
      speed: (s) => this.setSpeed(s),
      camera: (kind) => this.setCamera(kind),
      overlay: (key, on) => this.setOverlay(key, on),
      scene: (i) => this.openScene(i),
      body: (i) => this.setBody(i),
      gain: (g) => this.setGain(g),
      key: (event) => this.onKey(event),
    };
  }

  async start() {
    await this.openScene(0);
    this.setCamera("follow");
    this.setSpeed(1);
    this.pause();
    this.watch();
    this.draw();
    const calm = window.matchMedia?.("(prefers-reduced-motion: reduce)").matches;
    if (!calm && !this.quality.software) this.play();
  }

  /// Follows the size of the picture, and rests while it is out of sight.
  watch() {
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(this.controls.box);
    this.sight = new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      this.last = performance.now();
      if (this.dirty) this.wake();
    });
    this.sight.observe(this.controls.box);
    this.onVisible = () => {
      this.last = performance.now();
    };
    document.addEventListener("visibilitychange", this.onVisible);
  }

  async openScene(index) {
    const scene = await this.scenes[index].make();
    if (this.gone) return;
    this.scene = scene;
    const { bodies, start, end, sea, faults, note } = scene;
    this.buildStage();
    const yaw = (bodies[0].track.at(start).yaw * Math.PI) / 180;
    aimSun(this.light, yaw + SUN_BEARING);
    this.setTime(start + 2 * (sea.ramp ?? 0));
    this.controls.bar.setRange(start, end);
    this.controls.about.setScene(index, bodies.map(({ name }) => name), scene.seaText);
    this.controls.setNote(
      [...faults.map((f) => `Not shown: ${f}.`), note || OF_THE_RUN, NOTE].join(" "));
    this.setBody(Math.max(0, bodies.findIndex(({ box }) => !box)));
  }

  buildStage() {
    this.stage?.dispose();
    const { scene, light, sky, camera, quality } = this;
    this.stage = new Stage({
      renderer: this.renderer, scene, light, sky, camera, quality, changed: () => this.touch(),
    });
    for (const [key] of OVERLAYS) this.setOverlay(key, this.show[key]);
    this.resize();
  }

  setTime(t) {
    this.t = clamp(t, this.scene.start, this.scene.end);
    this.touch();
  }

  setSpeed(s) {
    this.speed = s;
    this.controls.bar.setSpeed(s);
  }

  setCamera(kind) {
    this.cameras.state.kind = kind;
    this.controls.bar.setCamera(kind);
    this.touch();
  }

  setBody(i) {
    this.body = i;
    this.stage.inView = i;
    this.cameras.state.length = this.stage.length;
    this.controls.about.setBody(i);
    this.touch();
  }

  setGain(g) {
    this.stage.gain = g;
    this.touch();
  }

  setOverlay(key, on) {
    const { stage, controls } = this;
    this.show[key] = on;
    controls.bar.setOverlay(key, on && stage.can(key), stage.can(key));
    // Pressure on a hull is seen through the water.
    stage.setShow({ ...this.show, glass: this.show.glass || this.show.pressure });
    controls.bar.setGain(stage.gain, this.show.forces && stage.can("forces"));
    this.touch();
  }

  play() {
    if (this.t >= this.scene.end) this.setTime(this.scene.start);
    this.playing = true;
    this.last = performance.now();
    this.controls.bar.setPlaying(true);
    this.wake();
  }

  pause() {
    this.playing = false;
    this.controls.bar.setPlaying(false);
  }

  /// Does what a key asks for; false if it is no key of the replay.
  onKey(event) {
    const camera = CAMERAS[Number(event.key) - 1];
    const overlay = OVERLAYS.find(([, , letter]) => letter === event.key.toLowerCase());
    const act = this.keys(event.shiftKey ? 10 : 1)[event.key] ??
      (camera && (() => this.setCamera(camera))) ??
      (overlay && (() => this.setOverlay(overlay[0], !this.show[overlay[0]])));
    act?.();
    return Boolean(act);
  }

  keys(step) {
    const { cameras } = this;
    const faster = (n) => () =>
      this.setSpeed(SPEEDS[clamp(SPEEDS.indexOf(this.speed) + n, 0, SPEEDS.length - 1)]);
    return {
      " ": () => (this.playing ? this.pause() : this.play()),
      ArrowLeft: () => this.setTime(this.t - step), ArrowRight: () => this.setTime(this.t + step),
      Home: () => this.setTime(this.scene.start), End: () => this.setTime(this.scene.end),
      ArrowUp: () => cameras.turnBy(0, 15), ArrowDown: () => cameras.turnBy(0, -15),
      "[": () => cameras.turnBy(20, 0), "]": () => cameras.turnBy(-20, 0),
      PageUp: () => cameras.scaleBy(0.87), PageDown: () => cameras.scaleBy(1.15),
      "+": faster(1), "=": faster(1), "-": faster(-1),
      h: () => this.controls.hide(),
    };
  }

  resize() {
    const [width, height] = this.controls.size;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, this.quality.pixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.touch();
  }

  draw() {
    const { controls, scene, t } = this;
    const { pose, speed, rule, legend } = this.stage.draw(t, this.cameras, controls.size);
    const [x, y, z] = pose.position;
    controls.bar.setTime(t, scene.end);
    controls.readout.set({
      t: t.toFixed(1), heave: fixed(z - scene.bodies[this.body].cogZ, 2),
      roll: fixed(pose.roll, 1), pitch: fixed(pose.pitch, 1),
      speed: Number.isFinite(speed) ? speed.toFixed(1) : "–",
      zeta: fixed(elevation(scene.sea, t, x, y), 2),
    });
    controls.rule.set(rule);
    controls.legend.set(legend);
    this.dirty = false;
    this.setFence();
  }

  /// Whether the graphics card has done the last picture: no more than one is ever under way.
  drawn() {
    const gl = this.renderer.getContext();
    if (!this.fence) return true;
    const state = gl.clientWaitSync(this.fence, 0, 0);
    if (state === gl.TIMEOUT_EXPIRED) return false;
    gl.deleteSync(this.fence);
    this.fence = null;
    return true;
  }

  setFence() {
    const gl = this.renderer.getContext();
    if (this.fence) gl.deleteSync(this.fence);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /// What is seen is no longer true.
  touch() {
    this.dirty = true;
    this.wake();
  }

  wake() {
    if (this.request !== 0 || this.gone) return;
    this.request = requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.request = 0;
    if (this.gone) return;
    if (!this.drawn()) {
      this.wake();
      return;
    }
    if (this.playing) this.advance(Math.min(2, (now - this.last) / 1000));
    this.last = now;
    if (this.dirty && this.visible) this.draw();
    if (this.playing) this.wake();
  }

  advance(dt) {
    if (!this.visible) return;
    this.setTime(this.t + Math.max(0, dt) * this.speed);
    if (this.t >= this.scene.end) this.pause();
    this.judge(dt);
  }

  /// Lowers the quality once frames have been slow for a while, unless the address asks for one.
  judge(dt) {
    this.slow = dt > 0.042 ? this.slow + (dt > 0.1 ? 4 : 1) : Math.max(0, this.slow - 2);
    if (this.slow < 40 || this.quality.asked || this.quality.name === "low") return;
    this.slow = 0;
    this.quality = { ...this.quality, ...QUALITIES.low };
    this.buildStage();
    this.setBody(this.body);
  }

  destroy() {
    this.gone = true;
    cancelAnimationFrame(this.request);
    for (const part of [this.sizes, this.sight]) part?.disconnect();
    document.removeEventListener("visibilitychange", this.onVisible);
    this.cameras.dispose();
    this.stage?.dispose();
    this.renderer.dispose();
    this.element.replaceChildren();
  }
}

/// For tests and pictures.
function debugOf(replay) {
  return {
    /// Height [m] that the texture holds for a vertex laid at x, y of the earth, at the time drawn.
    surfaceAt: (x, y) => replay.stage.surfaceAt(x, y),
    /// The greatest difference [m] from the formula of n vertices of the fine square, as drawn.
    worstVertex: (n = 500) => replay.stage.worstVertex(replay.t, n),
    scenes: replay.scenes.map(({ title }) => title),
    scene: (i) => replay.openScene(i),
    body: (i) => replay.setBody(i),
    camera: (kind) => replay.setCamera(kind),
    cameras: replay.cameras.state,
    overlay: (key, on) => replay.setOverlay(key, on),
    state: () => ({
      t: replay.t, playing: replay.playing, quality: replay.quality.name,
      vertices: replay.stage.vertices, show: { ...replay.show },
    }),
  };
}

/// Draws the replay of `page` (data.js: readPage) in `element`. Throws where WebGL 2 with float
/// textures is missing. `seek` has drawn when it returns.
export async function createReplay(element, page) {
  const replay = new Replay(element, page);
  await replay.start();
  return {
    destroy: () => replay.destroy(),
    seek(t) {
      replay.setTime(t);
      replay.draw();
    },
    play: () => replay.play(),
    pause: () => replay.pause(),
    time: () => replay.t,
    debug: debugOf(replay),
  };
}
