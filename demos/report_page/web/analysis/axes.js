// Axes of the figures of McTaggart, DRDC Atlantic TM 2003-104, in its units: [lower, upper]. Of its
// curves only these are known; a curve lies inside its axis. Table 2 beside them. Pure.

/** The report's ship and speed: lengths in m, 20 knots in m/s. */
export const REPORT = { length: 124.5, beam: 14.8, draught: 4.97, speed: 20 * 1852 / 3600 };

/** Figures 15 to 20 by mode: B_jj and U ∂A_jj/∂x in Δr²√(g/L). */
export const DAMPING = [
  { B: [0, 0.05], slope: [0, 0.03] },
  { B: [0, 3], slope: [-0.5, 0] },
  { B: [0, 5], slope: [0, 0.6] },
  { B: [0, 0.3], slope: [-0.1, 0.1] },
  { B: [0, 6], slope: [-1, 2] },
  { B: [0, 4], slope: [-2, 0] },
];

/** Figures 21 and 22 by heading: |F_j| in Δga/L (F₁ to F₃) and Δga. */
export const EXCITATION = {
  30: [[0, 2], [0, 2], [0, 40], [0, 0.04], [0, 5], [0, 0.6]],
  150: [[0, 3], [0, 4], [0, 40], [0, 0.06], [0, 6], [0, 1]],
};

/** Figures 23 and 24 by heading: |η_j| in a and ka. */
export const MOTIONS = {
  30: [[0, 3], [0, 2], [0, 1], [0, 0.6], [0, 1], [0, 0.5]],
  150: [[0, 0.8], [0, 0.4], [0, 1], [0, 6], [0, 1], [0, 0.3]],
};

/** Figures 31 and 32: as 23 and 24, with supplementary roll damping and yaw stiffness. */
export const DAMPED_MOTIONS = {
  30: [[0, 3], [0, 1.5], [0, 1], [0, 1.5], [0, 1], [0, 0.4]],
  150: [[0, 1], [0, 0.5], [0, 1.5], [0, 3], [0, 1], [0, 1]],
};

/** Figures 25 to 30 by mode: K_jj at rest and U² K^UU_jj in Δr²g/L. */
export const RETARDATION = [
  { K: [-0.1, 0.3] },
  { K: [-5, 15] },
  { K: [-5, 20] },
  { K: [-1, 2] },
  { K: [-10, 30], squared: [-0.4, 0.6] },
  { K: [-10, 20], squared: [-0.2, 0.6] },
];

/** Figures 34 to 36: force less the weight over Δg, arms in m. */
export const BUOYANCY = { heave: [-2, 3], roll: [-3, 3], pitch: [-60, 60] };

/** Table 2: [mesh, panels of the port side, ∇ m³, LCB aft of FP m, CB above waterline m, S m²]. */
export const TABLE2 = [
  ["coarse", 224, 4465.8, 64.663, -1.882, 1965.6],
  ["medium", 433, 4488.8, 64.665, -1.889, 1969.4],
  ["fine", 1040, 4500.6, 64.678, -1.893, 1971.2],
];
