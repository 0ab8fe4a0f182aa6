// The sea of a spectrum, and how a ship with way on meets it. Pure.

export const GRAVITY = 9.80665;

/** ω_e = ω − ω² U cos β / g; below 0 where the ship overtakes the waves. */
export function encounter(omega, speed, headingDeg, gravity = GRAVITY) {
  return omega - omega * omega * speed * Math.cos(headingDeg * Math.PI / 180) / gravity;
}

/**
 * Where waves are met more slowly than this [rad/s], linear theory has no surge, sway and yaw:
 * nothing holds them, and they grow without bound.
 */
export const SLOWEST = 0.1;

/** Is the motion of a mode (from 0) at ω_e one that linear theory has? */
export const isHeld = (mode, omegaE) => (mode > 1 && mode < 5) || Math.abs(omegaE) >= SLOWEST;

// Bretschneider's form times the peak's enhancement, of any height.
function shape(omega, peak, gamma) {
  if (!(omega > 0)) return 0;
  const ratio = omega / peak, width = ratio <= 1 ? 0.07 : 0.09;
  return ratio ** -5 * Math.exp(-1.25 * ratio ** -4)
    * gamma ** Math.exp(-((ratio - 1) ** 2) / (2 * width * width));
}

/** JONSWAP spectrum S(ω) [m² s], made so that ∫ S dω = Hs²/16, as in hydro/waves. */
export function jonswap(hs, tp, gamma) {
  const peak = 2 * Math.PI / tp, steps = 4000, most = 20;
  let sum = 0;
  for (let i = 0; i < steps; ++i) sum += shape((i + 0.5) * most / steps, 1, gamma);
  const height = hs * hs / 16 / (sum * most / steps * peak);
  return (omega) => height * shape(omega, peak, gamma);
}

/** Weights of equal bins of the spectrum between ascending ω; Σ weight S(ω) = ∫ S dω. */
export function trapezoid(omega) {
  const n = omega.length;
  return Float64Array.from({ length: n }, (_, i) =>
    0.5 * ((omega[Math.min(i + 1, n - 1)] ?? 0) - omega[Math.max(i - 1, 0)]));
}

/** cos² weights of directions around the mean, on a circle of steps [deg]; Σ = 1. */
export function cosineSquared(stepDeg) {
  const reach = Math.floor(90 / stepDeg);
  const weights = [];
  for (let i = -reach; i <= reach; ++i) {
    weights.push({ steps: i, weight: Math.cos(i * stepDeg * Math.PI / 180) ** 2 });
  }
  const sum = weights.reduce((total, { weight }) => total + weight, 0);
  return weights.map(({ steps, weight }) => ({ steps, weight: weight / sum }));
}
