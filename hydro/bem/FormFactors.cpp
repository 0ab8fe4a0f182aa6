#include "hydro/bem/FormFactors.h"

namespace cutwater {

Eigen::Vector2d FormFactors::directionOf(int step) {
  constexpr int kQuadrant = kSteps / 4;
  const int quadrant = step / kQuadrant, within = step % kQuadrant;
  const double t = static_cast<double>(within) / kQuadrant;
  Eigen::Vector2d e(1.0 - t, t);
  for (int q = 0; q < quadrant; ++q) e = Eigen::Vector2d(-e.y(), e.x());
  return e.normalized();
}

FormFactors::FormFactors(const PanelPairs& pairs, int all, double K)
    : values_(static_cast<std::size_t>(all) * (kSteps + 1)) {
  std::vector<Eigen::Vector3cd> wave;
  for (int step = 0; step < kSteps / 2; ++step) {
    const Eigen::Vector2d e = directionOf(step);
    wave.emplace_back(Complex(0.0, -K * e.x()), Complex(0.0, -K * e.y()), Complex(K, 0.0));
  }
  for (int panel = 0; panel < all; ++panel) {
    Complex* S = &values_[static_cast<std::size_t>(panel) * (kSteps + 1)];
    for (int step = 0; step < kSteps / 2; ++step) {
      S[step] = std::exp(pairs.moments(panel).logarithm(wave[static_cast<std::size_t>(step)]));
      S[step + kSteps / 2] = std::conj(S[step]);
    }
    S[kSteps] = S[0];
  }
}

}  // namespace cutwater
