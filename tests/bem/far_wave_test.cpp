#include <gtest/gtest.h>

#include <random>

#include "tests/bem/Bodies.h"
#include "tests/support/Results.h"

// Wave terms of far pairs from one evaluation a pair, against brute force.
namespace cutwater::test {
namespace {

/// Potential and normal derivative of the wave part, port and mirrored panels, mean over the field
/// panel, with 7 × 7 points on either panel.
std::pair<Complex, Complex> bruteForce(const PanelPairs& pairs, int field, int source, double K) {
  Complex value = 0.0, along = 0.0;
  for (const bool mirrored : {false, true}) {
    const Vec3 e = pairs.direction({field, source, mirrored});
    const Panel& seen = pairs.panel(field);
    for (const QuadraturePoint& at : panelQuadrature(seen, 7))
      for (const QuadraturePoint& from : panelQuadrature(pairs.panel(source), 7)) {
        const Vec3 x = imageInY(at.x, mirrored);
        const double dx = from.x.x() - x.x(), dy = from.x.y() - x.y(), h = std::hypot(dx, dy);
        const WavePoint w(K, K * h, -K * (x.z() + from.x.z()));
        const double weight = at.weight * from.weight / seen.area;
        value += weight * w.value;
        along += weight * ((e.x() * dx + e.y() * dy) / h * w.slope - e.z() * w.rise);
      }
  }
  return {value, along};
}

/// Error of the wave part of R and L, root mean square over pairs that are far, of its size.
std::pair<double, double> errors(Formulation formulation, double K) {
  const FrigateDivision division = frigateDivision(433);
  const InfluenceSettings settings{formulation};
  const PanelMesh mesh = panels(wetFrigate(division.along, division.girth), true, false);
  const InfluenceMatrices matrices(mesh, settings);
  const PanelPairs pairs(mesh, settings);
  const auto at = matrices.atWaveNumber(K)[0];
  const auto rigid = matrices.atLimit(FrequencyLimit::Zero, Parity::Even);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, pairs.hull() - 1);
  double value = 0.0, valueSize = 0.0, along = 0.0, alongSize = 0.0;
  for (int count = 0; count < 300;) {
    const int i = any(random), j = any(random);
    if (pairs.isNear({i, j, false}) || pairs.isNear({i, j, true})) continue;
    ++count;
    const auto [R, L] = bruteForce(pairs, i, j, K);
    const double g = -4.0 * kPi;  // of G
    value += std::norm(g * (at.R(i, j) - rigid.R(i, j)) - R);
    along += std::norm(g * (at.L(i, j) - rigid.L(i, j)) - L);
    valueSize += std::norm(R);
    alongSize += std::norm(L);
  }
  return {std::sqrt(value / valueSize), std::sqrt(along / alongSize)};
}

// Panels of 4.5 m on a 120 m hull: second moments leave (size/distance)⁴ and what waves make of the
// third, (KL)³; at 3 rad/s a panel is two thirds of a wave and is resolved no longer by anything.
TEST(FarWaveConvergence, OneEvaluationAPairAgainstBruteForce) {
  for (const Formulation formulation : {Formulation::Potential, Formulation::Source})
    for (const auto& [omega, bound] :
         {std::pair{0.5, 4e-4}, {1.0, 6e-4}, {2.0, 3e-3}, {3.0, 1.5e-2}}) {
      const auto [value, along] = errors(formulation, omega * omega / kGravity);
      EXPECT_LT(value, bound) << omega;
      EXPECT_LT(along, bound) << omega;
      if (formulation == Formulation::Source) continue;
      recordResult("solver",
                   "wave part of far pairs, frigate 433 at " + std::to_string(omega).substr(0, 3) +
                       " rad/s, r.m.s. of an entry, %",
                   "7 x 7 x 7 x 7 points", 100.0 * std::max(value, along),
                   "<= " + std::to_string(100.0 * bound).substr(0, 4));
    }
}

// A rectangle: the product of two sin x/x. The cumulants leave the sixth, x⁶/2835 of each side.
TEST(FormFactorsClosedForm, RectangleOnTheSurfaceOfTheSea) {
  const double a = 1.5, b = 0.5;
  SurfaceMesh mesh{{{a, b, 0}, {-a, b, 0}, {-a, -b, 0}, {a, -b, 0}}, {Face{{0, 1, 2, 3}}}};
  const PanelPairs pairs(makePanels(mesh, false), {});
  const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; };
  for (const double K : {0.2, 0.5, 1.0}) {
    const FormFactors form(pairs, 1, K);
    for (int step = 0; step <= FormFactors::kSteps; ++step) {
      const double t = step % 32 / 32.0, quarter = 0.5 * kPi * (step / 32);
      const double angle = quarter + std::atan2(t, 1.0 - t);
      const double x = K * a * std::cos(angle), y = K * b * std::sin(angle);
      const double left = (std::pow(x, 6) + std::pow(y, 6)) / 2835.0;
      EXPECT_NEAR(form.of(0)[step].real(), sinc(x) * sinc(y), 1.3 * left + 1e-12);
      EXPECT_NEAR(form.of(0)[step].imag(), 0.0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
