// A ship or another body in the picture: what is known of its shape, and how it is drawn.
import * as THREE from "three";
import { decorate, makeDeck } from "./decoration.js";
import { hullGeometry, hullMaterial } from "./hull.js";
import { hullArrays, PAINT } from "./mesh.js";
import { pressures } from "./pressure.js";

/// Where one stands on a hull without decoration: before the largest house, or above the deck.
function eyeOn([main, ...houses], deck) {
  const length = main.high[0] - main.low[0];
  const side = ({ low, high }) => (high[2] - low[2]) * (high[0] - low[0]);
  const house = houses.sort((a, b) => side(b) - side(a))[0];
  if (house) {
    return [house.high[0] + 0.02 * length, 0, house.low[2] + 0.7 * (house.high[2] - house.low[2])];
  }
  const x = main.low[0] + 0.62 * length;
  const height = deck.heightAt(x, 0);
  return [x, 0, (Number.isFinite(height) ? height : main.high[2]) + 0.07 * length];
}

/// What is known of a body's shape: its arrays, box, deck, decoration, and where its bridge is.
export function shapeOf(body) {
  const { points, faces } = body.hull;
  const arrays = hullArrays(points, faces);
  const [main] = arrays.parts;
  const size = main.high.map((v, i) => v - main.low[i]);
  const length = Math.max(size[0], size[1]);
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
  // A box as thin as a link of a chain is dark.
  const thin = length > 8 * Math.max(Math.min(size[0], size[1]), size[2]);
  if (body.box) arrays.paint.fill(thin ? PAINT.dark : PAINT.box);
  const ownHouses = arrays.parts.length > 1;
  const decoration = body.box || ownHouses ? null : decorate(main, points, mainFaces);
  const eye = decoration?.eye ?? eyeOn(arrays.parts, deck);
  const colours = body.box ? 2 : length > 45 ? 0 : ownHouses ? 1 : 3;
  return { arrays, main, length, calm, freeboard, decoration, eye, colours, faces };
}

/// Weight [N] of a body: by its mass, by the run's own column, or by the water that it displaces.
export function weightOf(body, shape, { density, sea }) {
  if (body.mass) return body.mass * sea.gravity;
  const { main, calm } = shape;
  const draught = Math.max(0.1, calm - main.low[2]);
  return 0.5 * density * sea.gravity * shape.length * (main.high[1] - main.low[1]) * draught;
}

/// Superstructure and rails, in a group of their own.
function decorationGroup(shape, material) {
  const group = new THREE.Group();
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
    group.add(mesh, rails);
  }
  return group;
}

/// A ship's compartments, about G as its hull: the edges of each, and its water, which is drawn as
/// it lies in the upright ship. Both show through the hull.
class DrawnRooms {
  constructor(compartments, track) {
    this.track = track;
    this.group = new THREE.Group();
    this.rooms = compartments.map(({ name, centre, size, permeability }) => {
      const box = new THREE.BoxGeometry(...size);
      const edges = new THREE.LineSegments(
        new THREE.EdgesGeometry(box),
        new THREE.LineBasicMaterial({
          color: 0xe9eef2, transparent: true, opacity: 0.7, depthTest: false, toneMapped: false,
        }),
      );
      const water = new THREE.Mesh(
        box,
        new THREE.MeshBasicMaterial({
          color: 0x2f7fb5, transparent: true, opacity: 0.55, depthTest: false, depthWrite: false,
          toneMapped: false,
        }),
      );
      edges.position.set(centre[0], centre[1], centre[2]);
      [water.renderOrder, edges.renderOrder] = [4, 5];
      this.group.add(water, edges);
      return { name, centre, size, permeability, water };
    });
  }

  /// The water at t.
  fill(t) {
    for (const { name, centre, size, permeability, water } of this.rooms) {
      const volume = this.track.value(`${name}_water`, t);
      const share = Math.min(1, volume / (permeability * size[0] * size[1] * size[2]));
      water.visible = share > 1e-4;
      if (!water.visible) continue;
      water.scale.set(1, 1, share);
      water.position.set(centre[0], centre[1], centre[2] - 0.5 * size[2] * (1 - share));
    }
  }
}

/// A body as it is drawn: `group` in local axes.
export class DrawnBody {
  constructor(body, shape, light, sums, grid) {
    this.body = body;
    this.shape = shape;
    this.material = hullMaterial(light, sums, grid, shape);
    this.geometry = hullGeometry(shape.arrays);
    const hull = new THREE.Mesh(this.geometry, this.material);
    hull.frustumCulled = false;
    this.extra = decorationGroup(shape, this.material);
    this.rooms = new DrawnRooms(body.compartments ?? [], body.track);
    this.group = new THREE.Group().add(hull, this.extra, this.rooms.group);
    this.kilopascals = new Float64Array(body.hull.points.length / 3);
  }

  place(pose, [x, y], t) {
    this.rooms.fill(t);
    this.group.position.set(pose.position[0] - x, pose.position[1] - y, pose.position[2]);
    this.group.quaternion.set(...pose.q);
    this.group.updateMatrixWorld();
  }

  /// What the water mirrors of it: an upright elliptic cylinder. Sets {place, size} of surface.js.
  mirror(pose, place, size) {
    const { main, calm, freeboard, length, colours } = this.shape;
    const middle = new THREE.Vector3(0.5 * (main.low[0] + main.high[0]), 0, calm)
      .applyMatrix4(this.group.matrixWorld);
    const yaw = (pose.yaw * Math.PI) / 180;
    place.set(middle.x, middle.y, Math.cos(yaw), Math.sin(yaw));
    const brightness = [0.1, 0.34, 0.12, 0.08][colours];
    const half = [0, 1].map((i) => 0.5 * (main.high[i] - main.low[i]));
    size.set(0.98 * half[0], half[1], freeboard + 0.04 * length, brightness);
  }

  /// Which overlays lie on the hull; `top` [kPa] ends the scale.
  show({ pressure, waterline, glass, decoration }, top) {
    const { uniforms } = this.material;
    uniforms.showPressure.value = pressure ? 1 : 0;
    uniforms.showLine.value = waterline ? 1 : 0;
    uniforms.below.value = glass ? 1 : 0;
    uniforms.pressureTop.value = top;
    this.extra.visible = decoration;
  }

  setPressures(pose, sea, t, density) {
    const p = pressures(this.body.hull.points, pose, sea, t, density, this.kilopascals);
    const values = this.geometry.attributes.pressure;
    this.shape.faces.forEach((v, c) => {
      values.array[c] = p[v];
    });
    values.needsUpdate = true;
  }

  dispose() {
    this.group.traverse((o) => o.geometry?.dispose());
    this.material.dispose();
  }
}
