#include "hydro/bem/matrices/FormFactors.h"

#include <array>

#include "hydro/base/SimdMath.h"

namespace cutwater {

Eigen::Vector2d FormFactors::directionOf(int step) {
  constexpr int kQuadrant = kSteps / 4;
  const int quadrant = step / kQuadrant, within = step % kQuadrant;
  const double t = static_cast<double>(within) / kQuadrant;
  Eigen::Vector2d e(1.0 - t, t);
  for (int q = 0; q < quadrant; ++q) e = Eigen::Vector2d(-e.y(), e.x());
  return e.normalized();
}

namespace {

/// S of one panel on the first half of the circle, along (ex, ey).
CUTWATER_VECTOR void formFactors(const PanelMoments& panel, double K, const double* ex,
                                 const double* ey, std::size_t count, Complex* S) {
  const auto along = [&](const Vec3& axis, std::size_t i) {
    const Double4 level = axis.x() * load4(ex + i) + axis.y() * load4(ey + i);
    return ComplexDouble4{level * 0.0 + K * axis.z(), -K * level};
  };
  for (std::size_t i = 0; i < count; i += 4) {
    const ComplexDouble4 e = exponential(panel.logarithm(along(panel.u, i), along(panel.v, i)));
    for (std::size_t k = 0; k < 4; ++k) S[i + k] = Complex(e.re[k], e.im[k]);
  }
}

}  // namespace

FormFactors::FormFactors(const PanelPairs& pairs, int all, double K)
    : values_(static_cast<std::size_t>(all) * (kSteps + 1)) {
  constexpr int kHalf = kSteps / 2;
  std::array<double, kHalf> ex{}, ey{};
  for (int step = 0; step < kHalf; ++step) {
    const Eigen::Vector2d e = directionOf(step);
    ex[static_cast<std::size_t>(step)] = e.x();
    ey[static_cast<std::size_t>(step)] = e.y();
  }
  for (int panel = 0; panel < all; ++panel) {
    Complex* S = &values_[static_cast<std::size_t>(panel) * (kSteps + 1)];
    formFactors(pairs.moments(panel), K, ex.data(), ey.data(), kHalf, S);
    for (int step = 0; step < kHalf; ++step) S[step + kHalf] = std::conj(S[step]);
    S[kSteps] = S[0];
  }
}

}  // namespace cutwater
