#include <gtest/gtest.h>

#include <random>

#include "hydro/bem/matrices/FormFactors.h"

// How much of a wave a panel feels; a rectangle on the surface is in far_wave_test.cpp.
namespace cutwater::test {
namespace {

PanelPairs pairsOf(std::vector<Panel> panels) {
  PanelMesh mesh;
  mesh.panels = std::move(panels);
  return PanelPairs(std::move(mesh), {});
}

/// (1/A) ∫ e^{K s_z − iK ê·s} dS with 12 × 12 points, exact to round-off for panels of less than a
/// wave.
Complex integratedForm(const Panel& panel, double K, const Eigen::Vector2d& e) {
  Complex sum = 0.0;
  for (const QuadraturePoint& at : panelQuadrature(panel, 12)) {
    const Vec3 s = at.x - panel.centroid;
    sum +=
        at.weight / panel.area * std::exp(Complex(K * s.z(), -K * (e.x() * s.x() + e.y() * s.y())));
  }
  return sum;
}

Complex formAt(const FormFactors& form, int panel, const Eigen::Vector2d& e) {
  return FormFactors::between(form.of(panel), FormFactors::placeOf(e.x(), e.y()));
}

const Panel kHullSide = flatPanel({{0, 1, -1}, {2, 1.3, -1}, {1.9, 1.17, -2}, {0.1, 0.9, -2}});
const Panel kTriangle = flatPanel({{0, 0, -1}, {2, 1, -2}, {-0.5, 1.5, -1}});

TEST(FormFactorsIdentity, PlacesAndDirectionsAreInverse) {
  for (int step = 0; step < FormFactors::kSteps; ++step) {
    const Eigen::Vector2d e = FormFactors::directionOf(step);
    EXPECT_NEAR(e.norm(), 1.0, 1e-15);
    // Round-off of a place up to 128.
    EXPECT_NEAR(FormFactors::placeOf(e.x(), e.y()), step, 1e-12) << step;
  }
  double before = -1.0;  // once round, the place rises all the way
  for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.01) {
    const double place = FormFactors::placeOf(std::cos(angle), std::sin(angle));
    EXPECT_GT(place, before) << angle;
    EXPECT_LE(place, FormFactors::kSteps) << angle;
    before = place;
  }
}

// Fifth cumulants are left out: θ⁵ and higher, θ = K·(half the panel's length).
TEST(FormFactorsConvergence, BruteForceIsMetToTheFifthPower) {
  const PanelPairs pairs = pairsOf({kHullSide, kTriangle});
  for (int panel = 0; panel < 2; ++panel) {
    const auto error = [&](double K) {
      const FormFactors form(pairs, 2, K);
      double worst = 0.0;
      for (int step = 0; step <= FormFactors::kSteps; ++step) {
        const Eigen::Vector2d e = FormFactors::directionOf(step % FormFactors::kSteps);
        worst = std::max(worst,
                         std::abs(form.of(panel)[step] - integratedForm(pairs.panel(panel), K, e)));
      }
      return worst;
    };
    EXPECT_GT(std::log2(error(0.4) / error(0.2)), 4.7) << panel;
    EXPECT_LT(error(0.4), 1e-3) << panel;
  }
}

// A strip along x, waves along it: sin θ/θ. Cumulants leave the sixth, θ⁶/2835: 6e-6 at 0.5, 0.4 %
// of 1 at θ = 1.5, 2 % at θ = 2; where the panel is much longer than a wave nothing is felt.
TEST(FormFactorsClosedForm, AlongAStripAsTheHeaderSays) {
  const double half = 1.0;
  const PanelPairs pairs = pairsOf(
      {flatPanel({{half, 0.01, 0}, {-half, 0.01, 0}, {-half, -0.01, 0}, {half, -0.01, 0}})});
  for (const auto& [theta, bound] : {std::pair{0.5, 6e-6}, {1.5, 4e-3}, {2.0, 2e-2}}) {
    const Complex S = FormFactors(pairs, 1, theta / half).of(0)[0];
    EXPECT_NEAR(S.real(), std::sin(theta) / theta, bound) << theta;
    EXPECT_NEAR(S.imag(), 0.0, 1e-12) << theta;
  }
  EXPECT_LT(std::abs(FormFactors(pairs, 1, 6.0).of(0)[0]), 1e-3);
}

// A wall of height 2b and width 2a, waves at an angle to it: the product of both means,
// sinh Kb/Kb · sin(Ka cos)/(Ka cos), to the sixth cumulants x⁶/2835.
TEST(FormFactorsClosedForm, WallFeelsTheDecayWithDepth) {
  const double a = 1.0, b = 0.5;
  const PanelPairs pairs = pairsOf({flatPanel({{a, 0, -1}, {-a, 0, -1}, {-a, 0, -2}, {a, 0, -2}})});
  for (const double K : {0.2, 0.6, 1.0}) {
    const FormFactors form(pairs, 1, K);
    for (int step = 0; step <= FormFactors::kSteps; step += 8) {
      const double x = K * a * FormFactors::directionOf(step % FormFactors::kSteps).x();
      const double along = std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x;
      const double exact = along * std::sinh(K * b) / (K * b);
      const double left = 1.3 * (std::pow(x, 6) + std::pow(K * b, 6)) / 2835.0 + 1e-13;
      EXPECT_LT(std::abs(form.of(0)[step] - exact), left) << K << ' ' << step;
    }
  }
}

// A wave that comes from the other side is the conjugate; a panel mirrored in y feels what comes
// mirrored.
TEST(FormFactorsIdentity, OppositeDirectionsAndMirrorImages) {
  std::vector<Vec3> mirrored(kHullSide.corner.rbegin(), kHullSide.corner.rend());
  for (Vec3& corner : mirrored) corner.y() *= -1.0;
  const PanelPairs pairs = pairsOf({kHullSide, flatPanel(mirrored), kTriangle});
  const FormFactors form(pairs, 3, 0.8);
  for (int step = 0; step <= FormFactors::kSteps; ++step) {
    const int opposite = (step + FormFactors::kSteps / 2) % FormFactors::kSteps;
    for (int panel = 0; panel < 3; ++panel)
      EXPECT_EQ(form.of(panel)[step], std::conj(form.of(panel)[opposite])) << step;
    // Round-off of corners in another order.
    EXPECT_LT(std::abs(form.of(0)[step] - form.of(1)[FormFactors::kSteps - step]), 1e-13) << step;
  }
}

// Linear between steps: 2e-4 θ² at any direction, θ = 0.5 K times the diameter.
TEST(FormFactorsConvergence, BetweenTheSteps) {
  const PanelPairs pairs = pairsOf({kHullSide});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * kPi);
  for (const double K : {0.1, 0.3}) {  // where the cumulants leave less
    const FormFactors form(pairs, 1, K);
    const double theta = 0.5 * K * diameter(kHullSide);
    for (int i = 0; i < 200; ++i) {
      const double a = angle(random);
      const Eigen::Vector2d e(std::cos(a), std::sin(a));
      EXPECT_LT(std::abs(formAt(form, 0, e) - integratedForm(kHullSide, K, e)),
                2e-4 * theta * theta)
          << a;
    }
  }
}

}  // namespace
}  // namespace cutwater::test
