// What an engineer asks for, over the picture: force arrows by part, G, the track over ground, a
// tow line, pressure on the wetted faces. Numbers are the run's; lengths and colours have their
// legend.
import * as THREE from "three";
import { rotate } from "./motion.js";
import { elevation } from "./wave.js";

/// Colours of force parts, told apart by colour-blind readers too (M. Okabe and K. Ito).
export const PART_COLOURS = [
  "#e69f00",
  "#56b4e9",
  "#2ee6a8",
  "#f0e442",
  "#4c8dff",
  "#ff7a33",
  "#e08bc0",
  "#ffffff",
  "#b0b0b0",
  "#a0e060",
  "#d0a070",
  "#80c0c0",
  "#c080ff",
  "#ff8080",
];

const onTop = { depthTest: false, depthWrite: false, transparent: true, toneMapped: false };

function makeArrow(colour) {
  const material = new THREE.MeshBasicMaterial({ color: colour, opacity: 0.95, ...onTop });
  const shaft = new THREE.Mesh(new THREE.CylinderGeometry(1, 1, 1, 10), material);
  const head = new THREE.Mesh(new THREE.ConeGeometry(1, 1, 14), material);
  const group = new THREE.Group();
  group.add(shaft, head);
  group.traverse((o) => {
    o.renderOrder = 20;
    o.frustumCulled = false;
  });
  const up = new THREE.Vector3(0, 1, 0);
  const direction = new THREE.Vector3();
  return {
    group,
    set(from, vector, thick) {
      const length = vector.length();
      group.visible = length > 1.5 * thick;
      if (!group.visible) return;
      const tip = Math.min(6 * thick, 0.5 * length);
      group.position.copy(from);
      group.quaternion.setFromUnitVectors(up, direction.copy(vector).divideScalar(length));
      shaft.scale.set(thick, length - tip, thick);
      shaft.position.y = 0.5 * (length - tip);
      head.scale.set(2.6 * thick, tip, 2.6 * thick);
      head.position.y = length - 0.5 * tip;
    },
  };
}

/// Track: `count` points of a body's run on the water, past and future apart by brightness.
function makeTrackLine(count) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
  geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(4 * count), 4));
  const line = new THREE.Line(
    geometry,
    new THREE.LineBasicMaterial({ vertexColors: true, ...onTop, depthTest: true }),
  );
  line.frustumCulled = false;
  line.renderOrder = 15;
  return line;
}

export function makeOverlay(bodies) {
  const group = new THREE.Group();
  const TRACK = 500;
  const perBody = bodies.map((body) => {
    const parts = body.run?.parts ?? [];
    const arrows = parts.map((_, i) => makeArrow(PART_COLOURS[i % PART_COLOURS.length]));
    arrows.forEach((a) => group.add(a.group));
    const line = makeTrackLine(TRACK);
    group.add(line);
    const mark = new THREE.Mesh(
      new THREE.SphereGeometry(1, 16, 12),
      new THREE.MeshBasicMaterial({ color: "#ffffff", ...onTop }),
    );
    mark.renderOrder = 19;
    const rope = new THREE.Mesh(
      new THREE.BufferGeometry(),
      new THREE.MeshBasicMaterial({ color: "#c9b27a", toneMapped: false }),
    );
    rope.frustumCulled = false;
    group.add(mark, rope);
    return { parts, arrows, line, mark, rope, forces: null, silent: [], loading: false };
  });

  const loadForces = async (entry, body, done) => {
    entry.loading = true;
    const forces = await Promise.all(
      entry.parts.map((part) =>
        Promise.all(
          [1, 2, 3].map(async (j) => {
            const column = body.run.columns.find(({ name }) => name === `${part}_F${j}`);
            return column ? (column.values ?? column.load()) : null;
          }),
        ),
      ),
    );
    entry.silent = forces.map((axes) => axes.every((v) => !v || v.every((f) => f === 0)));
    entry.forces = forces;
    done();
  };

  /// Force [N] of each part at row {i, f}, in axes that turn with the heading.
  const forcesAt = (entry, { i, f }) =>
    entry.forces.map((axes) =>
      axes.map((v) => (v ? v[i] + (f === 0 ? 0 : f * (v[i + 1] - v[i])) : 0)),
    );

  return {
    group,
    /// Brings all to time t. show: {forces, centre, track}; newtonsPerMetre scales arrows.
    /// Returns per body the force of each part, null of one that is 0 in all of the run, or null
    /// for all while they are being read.
    update({ t, sea, eye, origin, poses, show, rows, scaleOf, longest, changed }) {
      return perBody.map((entry, n) => {
        const body = bodies[n];
        const pose = poses[n];
        const place = new THREE.Vector3(
          pose.position[0] - origin[0],
          pose.position[1] - origin[1],
          pose.position[2],
        );
        entry.mark.visible = show.centre;
        entry.mark.position.copy(place);
        entry.mark.scale.setScalar(0.006 * body.length);
        entry.line.visible = show.track && body.track.end > body.track.start;
        if (entry.line.visible) updateTrack(entry.line, body, t, sea, origin, TRACK);
        updateRope(entry.rope, body, pose, poses, bodies, origin, eye);
        entry.arrows.forEach((a) => {
          a.group.visible = false;
        });
        if (!show.forces || entry.parts.length === 0) return null;
        if (!entry.forces) {
          if (!entry.loading) loadForces(entry, body, changed);
          return null;
        }
        const forces = forcesAt(entry, rows[n]);
        const yaw = (pose.yaw * Math.PI) / 180;
        const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
        forces.forEach(([x, y, z], i) => {
          const v = new THREE.Vector3(c * x - s * y, s * x + c * y, z)
            .divideScalar(scaleOf(n))
            .clampLength(0, longest * body.length);
          entry.arrows[i].set(place, v, 0.0045 * body.length);
        });
        return forces.map((f, i) => (entry.silent[i] ? null : f));
      });
    },
    dispose() {
      group.traverse((o) => {
        o.geometry?.dispose();
        o.material?.dispose();
      });
    },
  };
}

/// Times of the track's points: most of them within two minutes of t, the rest over the whole run.
function trackTimes({ start, end }, t, count) {
  const low = Math.max(start, t - 120);
  const high = Math.min(end, t + 120);
  const rest = Math.floor(count / 8);
  const near = count - 2 * rest;
  const between = (a, b, n) => Array.from({ length: n }, (_, i) => a + ((b - a) * i) / n);
  return [...between(start, low, rest), ...between(low, high, near), ...between(high, end, rest)];
}

function updateTrack(line, body, t, sea, origin, count) {
  const place = line.geometry.attributes.position;
  const colour = line.geometry.attributes.color;
  trackTimes(body.track, t, count).forEach((time, i) => {
    const [x, y] = body.track.at(time).position;
    const near = Math.abs(time - t) < 125;
    const z = (near ? elevation(sea, t, x, y) : 0) + 0.004 * body.length;
    place.setXYZ(i, x - origin[0], y - origin[1], z);
    const past = time <= t;
    colour.setXYZW(i, 1, past ? 0.8 : 1, past ? 0.3 : 1, past ? 0.95 : 0.4);
  });
  place.needsUpdate = true;
  colour.needsUpdate = true;
}

/// A line from a point of this body to a point of another, where the run says so:
/// tow = {to: name of the other run, from: [x, y, z], at: [x, y, z]}, points in each body's axes
/// about its G [m]. Drawn with some sag and at least a pixel wide: neither is the run's.
function updateRope(rope, body, pose, poses, bodies, origin, eye) {
  const other = body.tow ? bodies.findIndex(({ name }) => name === body.tow.to) : -1;
  rope.visible = other >= 0;
  if (!rope.visible) return;
  const end = (p, at) =>
    new THREE.Vector3(
      ...rotate(p.q, at).map((v, i) => v + p.position[i] - (i < 2 ? origin[i] : 0)),
    );
  const [a, b] = [end(pose, body.tow.from), end(poses[other], body.tow.at)];
  const middle = a.clone().lerp(b, 0.5);
  middle.z -= 0.03 * a.distanceTo(b);
  const curve = new THREE.QuadraticBezierCurve3(a, middle, b);
  const radius = Math.max(0.05, 0.0006 * middle.distanceTo(eye));
  rope.geometry.dispose();
  rope.geometry = new THREE.TubeGeometry(curve, 24, radius, 5);
}
