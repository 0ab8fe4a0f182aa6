// Where a body is at any time: rows of a run, interpolated. Positions linearly, attitudes along the
// shortest turn between two quaternions. R_EB = R_z(yaw) R_y(pitch) R_x(roll); angles in degrees.

const RAD = Math.PI / 180;

/// Quaternion [x, y, z, w] of roll, pitch and yaw [rad].
export function quaternion(roll, pitch, yaw) {
  const [sr, cr] = [Math.sin(roll / 2), Math.cos(roll / 2)];
  const [sp, cp] = [Math.sin(pitch / 2), Math.cos(pitch / 2)];
  const [sy, cy] = [Math.sin(yaw / 2), Math.cos(yaw / 2)];
  return [
    cy * cp * sr - sy * sp * cr,
    cy * sp * cr + sy * cp * sr,
    sy * cp * cr - cy * sp * sr,
    cy * cp * cr + sy * sp * sr,
  ];
}

/// From a (f = 0) to b (f = 1) at constant speed of turn.
export function slerp(a, b, f) {
  let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = dot < 0 ? -1 : 1;
  dot = Math.min(1, Math.abs(dot));
  const angle = Math.acos(dot);
  const near = angle < 1e-4;
  const u = near ? 1 - f : Math.sin((1 - f) * angle) / Math.sin(angle);
  const v = sign * (near ? f : Math.sin(f * angle) / Math.sin(angle));
  const q = [0, 1, 2, 3].map((i) => u * a[i] + v * b[i]);
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

/// v turned by q: from ship axes to earth axes.
export function rotate(q, v) {
  const [x, y, z, w] = q;
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return [
    v[0] + w * tx + y * tz - z * ty,
    v[1] + w * ty + z * tx - x * tz,
    v[2] + w * tz + x * ty - y * tx,
  ];
}

/// Row i and fraction f so that t lies between rows i and i + 1; ends are held. times rise.
export function rowAt(times, t) {
  const last = times.length - 1;
  if (last < 1 || !(t > times[0])) return { i: 0, f: 0 };
  if (t >= times[last]) return { i: last - 1, f: 1 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return { i: low, f: (t - times[low]) / (times[high] - times[low]) };
}

/// Motion of a run from its columns: a map from name to numbers.
export function makeTrack(columns) {
  const need = ["t", "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"];
  const missing = need.filter((name) => !columns.has(name));
  if (missing.length > 0) throw new Error(`the run has no column ${missing.join(", ")}`);
  const c = Object.fromEntries(need.map((name) => [name, columns.get(name)]));
  const times = c.t;
  if (times.length < 1) throw new Error("the run has no rows");
  const attitude = (i) =>
    quaternion(c.roll_deg[i] * RAD, c.pitch_deg[i] * RAD, c.yaw_deg[i] * RAD);
  const mix = (values, i, f) => (f === 0 ? values[i] : values[i] + f * (values[i + 1] - values[i]));
  return {
    start: times[0],
    end: times[times.length - 1],
    columns,
    value(name, t) {
      const values = columns.get(name);
      if (!values) return NaN;
      const { i, f } = rowAt(times, t);
      return mix(values, i, f);
    },
    at(t) {
      const { i, f } = rowAt(times, t);
      const q = f === 0 ? attitude(i) : slerp(attitude(i), attitude(i + 1), f);
      return {
        position: [mix(c.x, i, f), mix(c.y, i, f), mix(c.z, i, f)],
        q,
        roll: mix(c.roll_deg, i, f),
        pitch: mix(c.pitch_deg, i, f),
        yaw: mix(c.yaw_deg, i, f),
      };
    },
  };
}

/// Motion of a ship without a run: at rest at x = y = 0, or with the linear answers to a sea,
/// xi_j(t) = r sum Re(a H_j e^{i (omega t + eps)}); answers[j] = {re, im} over the sea's
/// components.
export function makeLinearTrack(cogZ, sea, answers, duration) {
  const motion = (j, t) => {
    if (!answers) return 0;
    let sum = 0;
    for (let i = 0; i < sea.size; ++i) {
      const theta = sea.omega[i] * t + sea.phase[i];
      sum += sea.amplitude[i] *
        (answers[j].re[i] * Math.cos(theta) - answers[j].im[i] * Math.sin(theta));
    }
    return sum;
  };
  return {
    start: 0,
    end: duration,
    columns: new Map(),
    value: () => NaN,
    at(t) {
      const [x, y, z, roll, pitch, yaw] = [0, 1, 2, 3, 4, 5].map((j) => motion(j, t));
      return {
        position: [x, y, cogZ + z],
        q: quaternion(roll, pitch, yaw),
        roll: roll / RAD, pitch: pitch / RAD, yaw: yaw / RAD,
      };
    },
  };
}
