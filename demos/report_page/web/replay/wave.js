// The sea of a run, in double precision: elevation, slope and the pressure below it. The shaders of
// surface.js sum the same components; this module is what they are tested against.
//
//     zeta(t, x, y) = r(t) sum a cos(theta),   theta = omega t - k (x cos b - y sin b) + eps
//     k = omega^2/g,   r = (1 - cos(pi t/ramp))/2 until t = ramp, then 1
//
// x, y [m] in earth axes, z up, b the heading: waves travel towards (cos b, -sin b).
import { jonswap } from "../analysis/sea.js";

const TURN = 2 * Math.PI;

/// The components as arrays: omega [rad/s], amplitude [m], phase [rad], heading [rad]; wave numbers
/// [1/m] where they are not omega^2/g, as of a steep wave's harmonics.
export function makeSea(omega, amplitude, phase, heading, gravity, ramp = 0, profile = "wheeler",
                        waveNumbers = null) {
  const n = omega.length;
  const kx = new Float64Array(n);
  const ky = new Float64Array(n);
  const k = new Float64Array(n);
  for (let i = 0; i < n; ++i) {
    k[i] = waveNumbers ? waveNumbers[i] : (omega[i] * omega[i]) / gravity;
    kx[i] = k[i] * Math.cos(heading[i]);
    ky[i] = -k[i] * Math.sin(heading[i]);
  }
  return {
    size: n, gravity, ramp, profile, k, kx, ky,
    omega: Float64Array.from(omega), amplitude: Float64Array.from(amplitude),
    phase: Float64Array.from(phase), heading: Float64Array.from(heading),
  };
}

export function calmSea(gravity = 9.80665) {
  return makeSea([], [], [], [], gravity);
}

/// Share of the waves at time t [s] while they are faded in.
export function rampAt(sea, t) {
  if (!(sea.ramp > 0) || t >= sea.ramp) return 1;
  return t <= 0 ? 0 : 0.5 * (1 - Math.cos((Math.PI * t) / sea.ramp));
}

/// theta/2 pi of each component at t and x, y, within -1/2 .. 1/2.
export function turnsAt(sea, t, x, y, out = new Float64Array(sea.size)) {
  for (let i = 0; i < sea.size; ++i) {
    const turns = (sea.omega[i] * t - sea.kx[i] * x - sea.ky[i] * y + sea.phase[i]) / TURN;
    out[i] = turns - Math.round(turns);
  }
  return out;
}

/// zeta [m] at t [s] and x, y [m].
export function elevation(sea, t, x, y) {
  let sum = 0;
  for (let i = 0; i < sea.size; ++i) {
    sum += sea.amplitude[i] *
      Math.cos(sea.omega[i] * t - sea.kx[i] * x - sea.ky[i] * y + sea.phase[i]);
  }
  return rampAt(sea, t) * sum;
}

/// d zeta/dx, d zeta/dy [-].
export function slope(sea, t, x, y) {
  const r = rampAt(sea, t);
  let sx = 0;
  let sy = 0;
  for (let i = 0; i < sea.size; ++i) {
    const s = sea.amplitude[i] *
      Math.sin(sea.omega[i] * t - sea.kx[i] * x - sea.ky[i] * y + sea.phase[i]);
    sx += sea.kx[i] * s;
    sy += sea.ky[i] * s;
  }
  return [r * sx, r * sy];
}

/// zeta and the pressure head H [m] at x, y, z: the pressure is rho g (H - z), and 0 above the
/// water. The profile says at which height e^{kz} is taken (see "Wave profiles" in THEORY.md).
export function waterAt(sea, t, x, y, z) {
  const r = rampAt(sea, t);
  const heights = waterAt.scratch.length >= sea.size
    ? waterAt.scratch : (waterAt.scratch = new Float64Array(sea.size));
  let zeta = 0;
  for (let i = 0; i < sea.size; ++i) {
    heights[i] = r * sea.amplitude[i] *
      Math.cos(sea.omega[i] * t - sea.kx[i] * x - sea.ky[i] * y + sea.phase[i]);
    zeta += heights[i];
  }
  const surface = sea.profile === "constant" ? Math.min(zeta, 0) : zeta;
  const level = sea.profile === "wheeler" ? Math.min(z, zeta) - zeta : Math.min(z, surface);
  let head = 0;
  for (let i = 0; i < sea.size; ++i) head += heights[i] * Math.exp(sea.k[i] * level);
  return { zeta, head };
}
waterAt.scratch = new Float64Array(0);

/// 4 sqrt(m0) [m] of the components, of the sea whose ramp is over.
export function significantHeight(sea) {
  let sum = 0;
  for (let i = 0; i < sea.size; ++i) sum += 0.5 * sea.amplitude[i] * sea.amplitude[i];
  return 4 * Math.sqrt(sum);
}

/// The shortest wave [m] that carries weight: 99.5 % of the slope's variance is in longer ones.
export function shortestLength(sea) {
  const order = Array.from(sea.k.keys()).sort((a, b) => sea.k[a] - sea.k[b]);
  const part = (i) => (sea.k[i] * sea.amplitude[i]) ** 2;
  const total = order.reduce((sum, i) => sum + part(i), 0);
  let sum = 0;
  for (const i of order) {
    sum += part(i);
    if (total > 0 && sum >= 0.995 * total) return TURN / sea.k[i];
  }
  return Infinity;
}

/// A JONSWAP sea of n components from one direction [rad], for a ship that has no run. Phases come
/// from a small generator with a seed, so that the page shows the same sea each time.
export function jonswapSea(hs, tp, headingRad, gravity, n = 80, seed = 1) {
  const peak = TURN / tp;
  const density = jonswap(hs, tp, 3.3);
  const low = 0.55 * peak;
  const step = (3.2 * peak - low) / n;
  let state = seed >>> 0;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
  const omega = [];
  const variance = [];
  for (let i = 0; i < n; ++i) {
    omega.push(low + (i + random()) * step);
    variance.push(density(omega[i]) * step);
  }
  const scale = hs / 4 / Math.sqrt(variance.reduce((a, b) => a + b, 0));
  const amplitude = variance.map((v) => scale * Math.sqrt(2 * v));
  const phase = omega.map(() => TURN * random());
  return makeSea(omega, amplitude, phase, omega.map(() => headingRad), gravity);
}
