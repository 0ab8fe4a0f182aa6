// One scene in three dimensions: the sea about the body in view, the bodies, what is drawn over
// them. Local axes: earth axes with the origin at G of the body in view, on calm water.
import * as THREE from "three";
import { DrawnBody, shapeOf, weightOf } from "./body.js";
import { fineSquare, makeGrid } from "./grid.js";
import { courseOf, lookFrom, ruleOf } from "./look.js";
import { rowAt } from "./motion.js";
import { makeOverlay, PART_COLOURS } from "./overlay.js";
import { niceAbove } from "./pressure.js";
import { makeSums } from "./sums.js";
import { makeSurface, MAX_BODIES } from "./surface.js";
import { elevation, rampAt, shortestLength } from "./wave.js";

/// Those of the hull's shader in its middling light.
const SCALE_COLOURS = ["#233470", "#2c7c95", "#8bb270", "#d7bb55", "#c55529"];

/// Arrows longer than this share of the ship are cut.
const LONGEST = 0.28;

/// Bearing [rad] of the sun from the bow, so that its track lies in the first picture.
export const SUN_BEARING = (-172 * Math.PI) / 180;

/// Wind that would raise the sea (Pierson and Moskowitz: Hs = 0.22 U^2/g), along the mean wave.
function windOf({ sea, hs }) {
  let x = 0;
  let y = 0;
  for (let i = 0; i < sea.size; ++i) {
    const weight = (sea.amplitude[i] * sea.amplitude[i]) / Math.max(1e-9, sea.k[i]);
    x += weight * sea.kx[i];
    y += weight * sea.ky[i];
  }
  return {
    speed: Math.min(18, Math.max(2.2, Math.sqrt((hs * sea.gravity) / 0.22))),
    bearing: x === 0 && y === 0 ? 2.6 : Math.atan2(y, x),
  };
}

function newtons(f) {
  if (f === 0) return "0";
  const [value, unit] = f >= 1e6 ? [f / 1e6, "MN"] : f >= 1e3 ? [f / 1e3, "kN"] : [f, "N"];
  return `${value.toPrecision(3)} ${unit}`;
}

/// Shapes of all bodies; those that share a hull share them.
function shapesOf(bodies) {
  const known = new Map();
  return bodies.map((body) => {
    const shape = known.get(body.hull);
    if (shape?.calm === -body.cogZ) return shape;
    known.set(body.hull, shapeOf(body));
    return known.get(body.hull);
  });
}

export class Stage {
  /// scene: of scenes.js; `changed` is called when something that was being read has come.
  constructor({ renderer, scene, light, sky, camera, quality, changed }) {
    Object.assign(this, { renderer, scene, light, sky, camera, changed });
    const { bodies, sea } = scene;
    this.shapes = shapesOf(bodies);
    bodies.forEach((body, i) => {
      body.length = this.shapes[i].length;
    });
    this.weights = bodies.map((body, i) => weightOf(body, this.shapes[i], scene));
    this.makeSea(quality);
    this.drawn = bodies.map((body, i) =>
      new DrawnBody(body, this.shapes[i], light, this.sums, this.grid));
    this.overlay = makeOverlay(bodies);
    this.world = new THREE.Scene();
    this.world.add(sky, this.surface.mesh, this.overlay.group, ...this.drawn.map((d) => d.group));
    this.wind = windOf(scene);
    this.shortest = shortestLength(sea);
    const draught = Math.max(...this.shapes.map(({ main, calm }) => calm - main.low[2]));
    this.topPressure = niceAbove(
      (scene.density * sea.gravity * (draught + 0.55 * scene.hs)) / 1000);
    /// Bodies, the largest first: those that the water mirrors.
    this.bySize = bodies.map((_, i) => i).sort((a, b) =>
      this.shapes[b].length - this.shapes[a].length);
    this.show = {};
    this.inView = 0;
    this.gain = 4;
    this.origin = [0, 0];
  }

  makeSea(quality) {
    const { renderer, light } = this;
    const longest = Math.max(...this.shapes.map(({ length }) => length));
    this.grid = makeGrid({
      ...fineSquare(longest), ring: quality.ring, reach: 9000, skirt: 80000,
    });
    this.sums = makeSums(renderer, this.grid, quality.view);
    this.surface = makeSurface(this.grid, this.sums, light, {
      layerCount: quality.layers,
      anisotropy: Math.min(quality.anisotropy, renderer.capabilities.getMaxAnisotropy()),
    });
  }

  get vertices() {
    return this.grid.places.length / 3;
  }

  get length() {
    return this.shapes[this.inView].length;
  }

  /// Whether this scene has what an overlay shows.
  can(key) {
    const { bodies } = this.scene;
    const has = {
      forces: bodies.some(({ run }) => (run?.parts ?? []).length > 0),
      track: bodies.some(({ run }) => run),
      decoration: this.shapes.some(({ decoration }) => decoration),
    };
    return has[key] ?? true;
  }

  setShow(show) {
    this.show = show;
    this.surface.setOpacity(show.glass ? 0.42 : 1);
    this.sky.material.uniforms.depths.value = show.glass ? 1 : 0;
    this.drawn.forEach((body) => body.show(show, this.topPressure));
  }

  /// Newtons a metre of arrow of body i.
  scaleOf(i) {
    return this.weights[i] / (0.4 * this.shapes[i].length) / this.gain;
  }

  /// Draws time t [s]; size: of the picture in CSS pixels. Returns what the controls show.
  draw(t, cameras, size) {
    const { bodies, sea } = this.scene;
    const poses = bodies.map(({ track }) => track.at(t));
    const pose = poses[this.inView];
    this.origin = [pose.position[0], pose.position[1]];
    this.sums.setSea(sea, t, ...this.origin);
    this.sums.drawGrid();
    this.placeBodies(poses, t);
    this.aim(cameras, pose, t);
    this.sums.drawView();
    this.surface.uniforms.waveHeight.value = this.scene.hs * rampAt(sea, t);
    this.surface.setRipples(this.wind, this.shortest, t, ...this.origin);
    const forces = this.drawOver(poses, t);
    this.renderer.render(this.world, this.camera);
    const { track } = bodies[this.inView];
    return {
      pose,
      speed: Math.hypot(track.value("u", t), track.value("v", t)),
      rule: ruleOf(this.camera, pose, size, cameras.state),
      legend: this.legendOf(forces[this.inView]),
    };
  }

  placeBodies(poses, t) {
    const { bodies, bodyPlaces, bodySizes } = this.surface.uniforms;
    bodies.value = Math.min(MAX_BODIES, this.drawn.length);
    this.drawn.forEach((body, i) => {
      body.place(poses[i], this.origin, t);
      const rank = this.bySize.indexOf(i);
      if (rank < MAX_BODIES) body.mirror(poses[i], bodyPlaces.value[rank], bodySizes.value[rank]);
      if (this.show.pressure) body.setPressures(poses[i], this.scene.sea, t, this.scene.density);
    });
  }

  aim(cameras, pose, t) {
    const { camera, light } = this;
    const [x0, y0] = this.origin;
    const clearance = 0.25 + 0.006 * this.length;
    cameras.set({
      place: new THREE.Vector3(0, 0, pose.position[2]),
      yaw: courseOf(this.scene.bodies[this.inView].track, t),
      q: this.drawn[this.inView].group.quaternion,
    }, this.shapes[this.inView].eye,
    (x, y) => elevation(this.scene.sea, t, x + x0, y + y0) + clearance);
    light.eye.value.copy(camera.position);
    light.cloudShift.value.set(0.00035 * t, 0.00012 * t);
    lookFrom(camera, this.sums);
  }

  drawOver(poses, t) {
    const rows = this.scene.bodies.map(({ track }) =>
      (track.columns.has("t") ? rowAt(track.columns.get("t"), t) : null));
    return this.overlay.update({
      t, sea: this.scene.sea, eye: this.camera.position, origin: this.origin, poses, rows,
      show: this.show, scaleOf: (i) => this.scaleOf(i), longest: LONGEST, changed: this.changed,
    });
  }

  legendOf(forces) {
    const { pressure, forces: arrows } = this.show;
    return {
      pressure: pressure ? { top: this.topPressure, colours: SCALE_COLOURS } : null,
      forces: arrows && forces ? this.forcesLegend(forces) : null,
    };
  }

  forcesLegend(forces) {
    const { parts } = this.scene.bodies[this.inView].run;
    const scale = this.scaleOf(this.inView);
    const metres = niceAbove(0.1 * this.length);
    const rows = parts.map((part, i) => ({
      colour: PART_COLOURS[i % PART_COLOURS.length], name: part.replaceAll("_", " "),
      value: forces[i] && newtons(Math.hypot(...forces[i])),
    }));
    const silent = rows.filter(({ value }) => !value).map(({ name }) => name).join(", ");
    return {
      rows: rows.filter(({ value }) => value),
      text: `${metres} m of arrow: ${newtons(metres * scale)}; all at G, ` +
        `cut at ${newtons(LONGEST * this.length * scale)}` +
        (silent ? `. Always 0: ${silent}` : ""),
    };
  }

  /// zeta [m] that the texture holds for a vertex laid at x, y of the earth.
  surfaceAt(x, y) {
    return this.sums.probe(x - this.origin[0], y - this.origin[1])[0];
  }

  /// Greatest difference [m] from the formula of n vertices of the fine square.
  worstVertex(t, n) {
    const heights = this.sums.readFine();
    const { places } = this.grid;
    let worst = 0;
    for (let m = 0; m < n; ++m) {
      const i = Math.floor(((m + 0.5) / n) * (heights.length / 4));
      const [x, y] = [this.origin[0] + places[3 * i], this.origin[1] + places[3 * i + 1]];
      worst = Math.max(worst, Math.abs(heights[4 * i] - elevation(this.scene.sea, t, x, y)));
    }
    return worst;
  }

  dispose() {
    [this.surface, this.sums, this.overlay, ...this.drawn].forEach((part) => part.dispose());
    this.world.clear();
  }
}
