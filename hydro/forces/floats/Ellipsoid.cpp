#include "hydro/forces/floats/Ellipsoid.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kRound = 1e-9;  // difference of squares, below which two axes are one

// R_D(x, y, z) = 3/2 ∫_0^∞ dt/(√(t + x) √(t + y) (t + z)^{3/2}), by duplication and the series of
// fifth order about the mean [Carlson79]; what is left out is 3 times 1e-3 to the sixth power.
double carlsonRd(double x, double y, double z) noexcept {
  constexpr double kNear = 1e-3;
  double sum = 0.0, scale = 1.0;
  for (;;) {
    const double mean = (x + y + 3.0 * z) / 5.0;
    const double dx = (mean - x) / mean, dy = (mean - y) / mean, dz = (mean - z) / mean;
    if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < kNear) {
      const double ea = dx * dy, eb = dz * dz, ec = ea - eb, ed = ea - 6.0 * eb, ef = ed + 2.0 * ec;
      const double series = 1.0 + ed * (-3.0 / 14.0 + 9.0 / 88.0 * ed - 9.0 / 52.0 * dz * ef) +
                            dz * (1.0 / 6.0 * ef + dz * (-9.0 / 22.0 * ec + dz * 3.0 / 26.0 * ea));
      return 3.0 * sum + scale * series / (mean * std::sqrt(mean));
    }
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double step = rx * (ry + rz) + ry * rz;
    sum += scale / (rz * (z + step));
    scale *= 0.25;
    x = 0.25 * (x + step);
    y = 0.25 * (y + step);
    z = 0.25 * (z + step);
  }
}

}  // namespace

Vec3 ellipsoidIntegrals(const Vec3& semiAxes) noexcept {
  const Vec3 square = semiAxes.cwiseAbs2();
  const double abc = semiAxes.prod();
  Vec3 alpha;
  for (int i = 0; i < 3; ++i)
    alpha[i] = 2.0 / 3.0 * abc * carlsonRd(square[(i + 1) % 3], square[(i + 2) % 3], square[i]);
  return alpha;
}

EllipsoidMass ellipsoidMass(const Vec3& semiAxes, double density) noexcept {
  const Vec3 alpha = ellipsoidIntegrals(semiAxes), square = semiAxes.cwiseAbs2();
  const double displaced = density * 4.0 / 3.0 * kPi * semiAxes.prod();
  EllipsoidMass mass;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    mass.linear[i] = displaced * alpha[i] / (2.0 - alpha[i]);
    const double difference = square[j] - square[k], sum = square[j] + square[k];
    if (std::abs(difference) <= kRound * sum) continue;
    const double below = 2.0 * difference + sum * (alpha[j] - alpha[k]);
    const double each = displaced / 5.0 * difference * (alpha[k] - alpha[j]) / below;
    mass.angular[i] = difference * each;
    mass.straining[i] = sum * each;
  }
  return mass;
}

}  // namespace cutwater
