// What the cameras need to know of a scene and what the picture needs to know of a camera: the
// course that is followed, what is in view, a length that fits.
import * as THREE from "three";
import { niceAbove } from "./pressure.js";

/// Bearing [rad] of the bow, averaged over some 20 s about t: a camera that follows must not yaw
/// with each wave.
export function courseOf(track, t) {
  let [x, y] = [0, 0];
  for (let i = -5; i <= 5; ++i) {
    const yaw = (track.at(t + 2 * i).yaw * Math.PI) / 180;
    x += Math.cos(yaw);
    y += Math.sin(yaw);
  }
  return Math.atan2(y, x);
}

/// Bearings and depressions that the camera sees, for the second texture of slopes.
export function lookFrom(camera, sums) {
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
export function ruleOf(camera, pose, [width, height], { kind }) {
  if (kind === "bridge") return { pixels: 0, metres: 0 };
  const distance = camera.position.distanceTo(new THREE.Vector3(0, 0, pose.position[2]));
  const perMetre = height / (2 * Math.tan((camera.fov * Math.PI) / 360) * distance);
  const metres = niceAbove(Math.max(1e-3, (0.09 * width) / perMetre));
  return { pixels: metres * perMetre, metres };
}
