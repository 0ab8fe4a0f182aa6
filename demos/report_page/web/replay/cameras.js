// Three cameras: one follows the ship and turns with its course, one orbits with a fixed bearing,
// one stands on the bridge and heels with the ship. Drag turns, wheel and pinch change the
// distance.
import * as THREE from "three";

export const CAMERAS = ["follow", "orbit", "bridge"];
const RAD = Math.PI / 180;

export function makeCameras(camera, canvas, changed) {
  const state = {
    kind: "follow",
    length: 100,
    scale: 1,
    follow: { turn: -34 * RAD, lift: 8 * RAD, distance: 1.25 },
    orbit: { turn: 60 * RAD, lift: 14 * RAD, distance: 1.5 },
    bridge: { turn: 0, lift: -4 * RAD, distance: 1 },
  };
  const target = new THREE.Vector3();
  const clamp = (v, low, high) => Math.min(high, Math.max(low, v));

  const turnBy = (dx, dy) => {
    const s = state[state.kind];
    const inside = state.kind === "bridge";
    s.turn += (inside ? 0.22 : -0.3) * dx * RAD * (inside ? 1 : 1);
    s.lift = inside
      ? clamp(s.lift + 0.2 * dy * RAD, -70 * RAD, 60 * RAD)
      : clamp(s.lift + 0.22 * dy * RAD, -6 * RAD, 88 * RAD);
    changed();
  };
  const scaleBy = (factor) => {
    const s = state[state.kind];
    s.distance = clamp(
      s.distance * factor,
      state.kind === "bridge" ? 0.35 : 0.16,
      state.kind === "bridge" ? 1.6 : 40,
    );
    changed();
  };

  const pointers = new Map();
  const spread = () => {
    const [a, b] = Array.from(pointers.values());
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  const listeners = {
    pointerdown(event) {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    },
    pointermove(event) {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const before = pointers.size === 2 ? spread() : 0;
      const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (pointers.size === 2) scaleBy(before / Math.max(1, spread()));
      else turnBy(dx, dy);
    },
    pointerup(event) {
      pointers.delete(event.pointerId);
    },
    pointercancel(event) {
      pointers.delete(event.pointerId);
    },
    wheel(event) {
      event.preventDefault();
      scaleBy(Math.exp(0.0012 * event.deltaY * (event.deltaMode === 1 ? 30 : 1)));
    },
  };
  for (const [name, act] of Object.entries(listeners)) {
    canvas.addEventListener(name, act, { passive: false });
  }

  return {
    state,
    turnBy,
    scaleBy,
    /// pose: {place: Vector3 of G in local axes, yaw [rad], q: Quaternion, calm height of G};
    /// eye: the bridge in ship axes; floor(x, y): the least height of the camera.
    set(pose, eye, floor) {
      const s = state[state.kind];
      camera.fov = 40;
      camera.near = clamp(0.004 * state.length, 0.05, 0.6);
      if (state.kind === "bridge") {
        camera.fov = clamp(58 * s.distance, 20, 95);
        camera.near = 0.05 + 0.0005 * state.length;
        camera.position
          .set(...eye)
          .applyQuaternion(pose.q)
          .add(pose.place);
        const ahead = new THREE.Vector3(
          Math.cos(s.lift) * Math.cos(-s.turn),
          Math.cos(s.lift) * Math.sin(-s.turn),
          Math.sin(s.lift),
        );
        camera.up.set(0, 0, 1).applyQuaternion(pose.q);
        target.copy(ahead).applyQuaternion(pose.q).add(camera.position);
      } else {
        const bearing = s.turn + (state.kind === "follow" ? pose.yaw : 0);
        const d = s.distance * state.length;
        camera.up.set(0, 0, 1);
        target.set(pose.place.x, pose.place.y, 0.045 * state.length * Math.min(1, s.distance));
        camera.position.set(
          target.x + d * Math.cos(s.lift) * Math.cos(bearing),
          target.y + d * Math.cos(s.lift) * Math.sin(bearing),
          target.z + d * Math.sin(s.lift),
        );
        camera.position.z = Math.max(
          camera.position.z,
          floor(camera.position.x, camera.position.y),
        );
      }
      camera.lookAt(target);
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
    },
    dispose() {
      for (const [name, act] of Object.entries(listeners)) canvas.removeEventListener(name, act);
    },
  };
}
