// One scene in three dimensions: the sea about the body in view, the bodies, what is drawn over
// them. Local axes: earth axes with the origin at G of the body in view, on calm water.
import * as THREE from "three";
import { decorate, makeDeck } from "./decoration.js";
import { fineSquare, makeGrid } from "./grid.js";
import { hullGeometry, hullMaterial } from "./hull.js";
import { hullArrays, PAINT } from "./mesh.js";
import { rowAt } from "./motion.js";
import { makeOverlay, PART_COLOURS } from "./overlay.js";
import { niceAbove, pressures } from "./pressure.js";
import { makeSums } from "./sums.js";
import { makeSurface, MAX_BODIES } from "./surface.js";
import { elevation, rampAt, shortestLength } from "./wave.js";

/// Those of the hull's shader in its middling light.
const SCALE_COLOURS = ["#233470", "#2c7c95", "#8bb270", "#d7bb55", "#c55529"];

/// Arrows longer than this share of the ship are cut.
const LONGEST = 0.28;

/// What is known of a body's shape: its arrays, box, deck, decoration, and where its bridge is.
function shapeOf(body) {
  const { points, faces } = body.hull;
  const arrays = hullArrays(points, faces);
  const [main] = arrays.parts;
  const length = main.high[0] - main.low[0];
  const calm = -body.cogZ;
  const mainFaces = Uint32Array.from(
    main.faces.flatMap((f) => [0, 1, 2].map((k) => faces[3 * f + k])),
  );
  const deck = makeDeck(points, mainFaces);
  const heights = [0.2, 0.35, 0.5, 0.65]
    .map((s) => deck.heightAt(main.low[0] + s * length, 0))
    .filter(Number.isFinite);
  const top = heights.length ? Math.min(...heights) : main.high[2];
  const freeboard = Math.max(0.02 * length, top - calm);
  if (body.box) arrays.paint.fill(PAINT.box);
  const ownHouses = arrays.parts.length > 1;
  const decoration = body.box || ownHouses ? null : decorate(main, points, mainFaces);
  const house = arrays.parts
    .slice(1)
    .sort((a, b) => b.high[2] * (b.high[0] - b.low[0]) - a.high[2] * (a.high[0] - a.low[0]))[0];
  const middle = main.low[0] + 0.62 * length;
  const eye =
    decoration?.eye ??
    (house
      ? [house.high[0] + 0.02 * length, 0, house.low[2] + 0.7 * (house.high[2] - house.low[2])]
      : [
          middle,
          0,
          (Number.isFinite(deck.heightAt(middle, 0)) ? deck.heightAt(middle, 0) : main.high[2]) +
            0.07 * length,
        ]);
  const colours = body.box ? 2 : length > 45 ? 0 : ownHouses ? 1 : 3;
  return { arrays, main, length, calm, freeboard, decoration, eye, colours, faces };
}

function bodyGroup(shape, light, sums, grid) {
  const material = hullMaterial(light, sums, grid, shape);
  const geometry = hullGeometry(shape.arrays);
  const group = new THREE.Group();
  const hull = new THREE.Mesh(geometry, material);
  hull.frustumCulled = false;
  group.add(hull);
  const extra = new THREE.Group();
  if (shape.decoration) {
    const mesh = new THREE.Mesh(hullGeometry(shape.decoration), material);
    mesh.frustumCulled = false;
    const rails = new THREE.LineSegments(
      new THREE.BufferGeometry().setAttribute(
        "position",
        new THREE.BufferAttribute(shape.decoration.rails, 3),
      ),
      new THREE.LineBasicMaterial({
        color: 0x8a8f94,
        transparent: true,
        opacity: 0.55,
        toneMapped: false,
      }),
    );
    rails.frustumCulled = false;
    rails.renderOrder = 3;
    extra.add(mesh, rails);
  }
  group.add(extra);
  return { group, material, geometry, extra };
}

export function makeStage({ renderer, scene, light, sky, camera, quality, changed }) {
  const { bodies, sea } = scene;
  const known = new Map(); // shapes of hulls that several bodies share
  const shapes = bodies.map((body) => {
    const key = known.get(body.hull);
    if (key?.calm === -body.cogZ) return key;
    known.set(body.hull, shapeOf(body));
    return known.get(body.hull);
  });
  bodies.forEach((body, i) => {
    body.length = shapes[i].length;
  });
  const largest = Math.max(...shapes.map(({ length }) => length));
  const grid = makeGrid({ ...fineSquare(largest), ring: quality.ring, reach: 9000, skirt: 80000 });
  const sums = makeSums(renderer, grid, quality.view);
  const surface = makeSurface(grid, sums, light, {
    layerCount: quality.layers,
    anisotropy: Math.min(quality.anisotropy, renderer.capabilities.getMaxAnisotropy()),
  });
  const drawn = shapes.map((shape) => bodyGroup(shape, light, sums, grid));
  const overlay = makeOverlay(bodies);
  const world = new THREE.Scene();
  world.add(sky, surface.mesh, overlay.group, ...drawn.map(({ group }) => group));

  const wind = windOf(scene);
  const shortest = shortestLength(sea);
  const draughts = shapes.map(({ main, calm }) => calm - main.low[2]);
  const top = niceAbove(
    (scene.density * sea.gravity * (Math.max(...draughts) + 0.55 * scene.hs)) / 1000,
  );
  const weights = bodies.map((body, i) => weightOf(body, shapes[i], scene));
  let show = {};
  let inView = 0;
  let gain = 4;
  let origin = [0, 0];

  const scaleOf = (i) => weights[i] / (0.4 * shapes[i].length) / gain;
  const can = (key) =>
    ({
      forces: bodies.some(({ run }) => (run?.parts ?? []).length > 0),
      track: bodies.some(({ run }) => run),
      decoration: shapes.some(({ decoration }) => decoration),
    })[key] ?? true;

  function placeBodies(poses) {
    poses.forEach((pose, i) => {
      const { group } = drawn[i];
      group.position.set(
        pose.position[0] - origin[0],
        pose.position[1] - origin[1],
        pose.position[2],
      );
      group.quaternion.set(...pose.q);
      group.updateMatrixWorld();
    });
    surface.uniforms.bodies.value = Math.min(MAX_BODIES, bodies.length);
    poses.slice(0, MAX_BODIES).forEach((pose, i) => {
      const { main, calm, freeboard } = shapes[i];
      const middle = new THREE.Vector3(0.5 * (main.low[0] + main.high[0]), 0, calm).applyMatrix4(
        drawn[i].group.matrixWorld,
      );
      const yaw = (pose.yaw * Math.PI) / 180;
      surface.uniforms.bodyPlaces.value[i].set(middle.x, middle.y, Math.cos(yaw), Math.sin(yaw));
      surface.uniforms.bodySizes.value[i].set(
        0.49 * (main.high[0] - main.low[0]),
        0.5 * (main.high[1] - main.low[1]),
        freeboard + 0.04 * shapes[i].length,
        [0.1, 0.34, 0.12, 0.08][shapes[i].colours],
      );
    });
  }

  function colourByPressure(poses, t) {
    drawn.forEach(({ geometry, material }, i) => {
      material.uniforms.showPressure.value = show.pressure ? 1 : 0;
      material.uniforms.showLine.value = show.waterline ? 1 : 0;
      material.uniforms.below.value = show.glass ? 1 : 0;
      material.uniforms.pressureTop.value = top;
      if (!show.pressure) return;
      const { points } = bodies[i].hull;
      const p = pressures(
        points,
        poses[i],
        sea,
        t,
        scene.density,
        new Float64Array(points.length / 3),
      );
      const values = geometry.attributes.pressure;
      shapes[i].faces.forEach((v, c) => {
        values.array[c] = p[v];
      });
      values.needsUpdate = true;
    });
  }

  function draw(t, cameras, [width, height]) {
    const poses = bodies.map(({ track }) => track.at(t));
    const pose = poses[inView];
    origin = [pose.position[0], pose.position[1]];
    sums.setSea(sea, t, ...origin);
    sums.drawGrid();
    placeBodies(poses);
    cameras.set(
      {
        place: new THREE.Vector3(0, 0, pose.position[2]),
        yaw: courseOf(bodies[inView].track, t),
        q: drawn[inView].group.quaternion,
      },
      shapes[inView].eye,
      (x, y) =>
        elevation(sea, t, x + origin[0], y + origin[1]) + 0.25 + 0.006 * shapes[inView].length,
    );
    light.eye.value.copy(camera.position);
    light.cloudShift.value.set(0.00035 * t, 0.00012 * t);
    lookFrom(camera, sums);
    sums.drawView();
    surface.uniforms.waveHeight.value = scene.hs * rampAt(sea, t);
    surface.setRipples(wind, shortest, t, ...origin);
    colourByPressure(poses, t);
    const rows = bodies.map(({ track }) =>
      track.columns.has("t") ? rowAt(track.columns.get("t"), t) : null,
    );
    const forces = overlay.update({
      t,
      sea,
      eye: camera.position,
      origin,
      poses,
      show,
      rows,
      scaleOf,
      longest: LONGEST,
      changed,
    });
    renderer.render(world, camera);
    return {
      pose,
      speed: Math.hypot(bodies[inView].track.value("u", t), bodies[inView].track.value("v", t)),
      rule: ruleOf(camera, pose, width, height, cameras.state),
      legend: legendOf(forces[inView]),
    };
  }

  function legendOf(forces) {
    const { run } = bodies[inView];
    return {
      pressure: show.pressure ? { top, colours: SCALE_COLOURS } : null,
      forces:
        show.forces && forces
          ? {
              rows: forces.map((f, i) => ({
                colour: PART_COLOURS[i % PART_COLOURS.length],
                name: run.parts[i].replaceAll("_", " "),
                value: newtons(Math.hypot(...f)),
              })),
              text:
                `${niceAbove(0.1 * shapes[inView].length)} m of arrow: ` +
                `${newtons(niceAbove(0.1 * shapes[inView].length) * scaleOf(inView))}; all at G, ` +
                `cut at ${newtons(LONGEST * shapes[inView].length * scaleOf(inView))}`,
            }
          : null,
    };
  }

  return {
    draw,
    can,
    vertices: grid.places.length / 3,
    /// Bearing of the sun from the bow, so that its track lies in the first picture.
    sunBearing: (-172 * Math.PI) / 180,
    lengthOf: (i) => shapes[i].length,
    setBody: (i) => {
      inView = i;
    },
    get gain() {
      return gain;
    },
    setGain: (g) => {
      gain = g;
    },
    setShow(wanted) {
      show = wanted;
      surface.setOpacity(show.glass ? 0.42 : 1);
      sky.material.uniforms.depths.value = show.glass ? 1 : 0;
      drawn.forEach(({ extra }) => {
        extra.visible = show.decoration;
      });
    },
    surfaceAt: (x, y) => sums.probe(x - origin[0], y - origin[1])[0],
    worstVertex(t, n) {
      const all = new Float32Array(4 * sums.width * sums.width);
      renderer.readRenderTargetPixels(sums.target, 0, 0, sums.width, sums.width, all);
      let worst = 0;
      for (let m = 0; m < n; ++m) {
        const i = Math.floor(((m + 0.5) / n) * sums.width * sums.width);
        const formula = elevation(
          sea,
          t,
          origin[0] + grid.places[3 * i],
          origin[1] + grid.places[3 * i + 1],
        );
        worst = Math.max(worst, Math.abs(all[4 * i] - formula));
      }
      return worst;
    },
    dispose() {
      surface.dispose();
      sums.dispose();
      overlay.dispose();
      drawn.forEach(({ group, material }) => {
        group.traverse((o) => o.geometry?.dispose());
        material.dispose();
      });
      world.clear();
    },
  };
}

/// Bearing [rad] of the bow, averaged over some 20 s about t: a camera that follows must not yaw
/// with each wave.
function courseOf(track, t) {
  let [x, y] = [0, 0];
  for (let i = -5; i <= 5; ++i) {
    const yaw = (track.at(t + 2 * i).yaw * Math.PI) / 180;
    x += Math.cos(yaw);
    y += Math.sin(yaw);
  }
  return Math.atan2(y, x);
}

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

/// Weight [N] of a body: by its mass, by the run's own column, or by the water that it displaces.
function weightOf(body, shape, { density, sea }) {
  if (body.mass) return body.mass * sea.gravity;
  const { main, calm } = shape;
  const draught = Math.max(0.1, calm - main.low[2]);
  return 0.5 * density * sea.gravity * shape.length * (main.high[1] - main.low[1]) * draught;
}

function newtons(f) {
  if (f === 0) return "0";
  const [value, unit] = f >= 1e6 ? [f / 1e6, "MN"] : f >= 1e3 ? [f / 1e3, "kN"] : [f, "N"];
  return `${value.toPrecision(3)} ${unit}`;
}

/// Bearings and depressions that the camera sees, for the second texture of slopes.
function lookFrom(camera, sums) {
  const eye = camera.position;
  sums.viewEye.set(eye.x, eye.y, Math.max(0.4, eye.z));
  const t = Math.tan((camera.fov * Math.PI) / 360);
  const middle = new THREE.Vector3(0, 0, -1).applyQuaternion(camera.quaternion);
  const ahead = Math.atan2(middle.y, middle.x);
  let half = 0;
  let down = 0;
  for (let i = 0; i <= 8; ++i) {
    for (let j = 0; j <= 8; ++j) {
      const ray = new THREE.Vector3(
        (i / 4 - 1) * t * camera.aspect,
        (j / 4 - 1) * t,
        -1,
      ).applyQuaternion(camera.quaternion);
      const turn = Math.atan2(ray.y, ray.x) - ahead;
      half = Math.max(half, Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))));
      down = Math.max(down, Math.atan2(-ray.z, Math.hypot(ray.x, ray.y)));
    }
  }
  half = down > 1.3 ? Math.PI : Math.min(Math.PI, 1.06 * half + 0.02);
  sums.viewWindow.set(ahead + half, 2 * half, Math.min(1.55, 1.05 * down + 0.05), 0);
}

/// A length that fits the picture, at the distance of G.
function ruleOf(camera, pose, width, height, { kind, length }) {
  if (kind === "bridge") return { pixels: 0, metres: 0 };
  const distance = camera.position.distanceTo(new THREE.Vector3(0, 0, pose.position[2]));
  const perMetre = height / (2 * Math.tan((camera.fov * Math.PI) / 360) * distance);
  const metres = niceAbove(Math.max(1e-3, (0.09 * width) / perMetre));
  return { pixels: metres * perMetre, metres };
}
