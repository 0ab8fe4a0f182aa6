// What a curve of righting levers says. Pure.

/**
 * {gm: slope at 0 [m], greatest: {heelDeg, gz}, vanishingDeg: first angle beyond the greatest lever
 * at which GZ falls to 0, or null}
 */
export function rightingFacts(heelDeg, gz) {
  const zero = heelDeg.findIndex((heel) => Math.abs(heel) < 1e-9);
  const gm = zero >= 0 && zero + 2 < heelDeg.length ? slopeAt(heelDeg, gz, zero) : null;
  let top = 0;
  gz.forEach((lever, i) => {
    if (lever > gz[top]) top = i;
  });
  let vanishingDeg = null;
  for (let i = top + 1; i < gz.length && vanishingDeg === null; ++i) {
    if (gz[i - 1] > 0 && gz[i] <= 0) {
      const share = gz[i - 1] / (gz[i - 1] - gz[i]);
      vanishingDeg = heelDeg[i - 1] + share * (heelDeg[i] - heelDeg[i - 1]);
    }
  }
  return { gm, greatest: parabolaTop(heelDeg, gz, top), vanishingDeg };
}

// Odd curve a φ + b φ³ through the first two points beyond 0: its slope at 0 [m/rad].
function slopeAt(heelDeg, gz, zero) {
  const [p, q] = [1, 2].map((i) => heelDeg[zero + i] * Math.PI / 180);
  const [a, b] = [gz[zero + 1] / p, gz[zero + 2] / q];
  return (a * q * q - b * p * p) / (q * q - p * p);
}

// Top of the parabola through the greatest lever and its neighbours.
function parabolaTop(x, y, top) {
  if (top === 0 || top === y.length - 1) return { heelDeg: x[top], gz: y[top] };
  const h = (x[top + 1] - x[top - 1]) / 2;
  const slope = (y[top + 1] - y[top - 1]) / 2, bend = y[top + 1] - 2 * y[top] + y[top - 1];
  const away = bend < 0 ? -slope / bend : 0;
  return { heelDeg: x[top] + away * h, gz: y[top] + away * slope / 2 };
}
