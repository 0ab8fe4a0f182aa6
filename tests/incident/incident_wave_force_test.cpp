#include <gtest/gtest.h>

#include "hydro/geometry/panels/PanelQuadrature.h"
#include "tests/bem/Bodies.h"

namespace cutwater::test {
namespace {

/// ∫ e^{iκt} dt from a to b.
Complex exponential(double kappa, double a, double b) {
  if (kappa == 0.0) return b - a;
  const Complex i(0.0, 1.0);
  return (std::exp(i * kappa * b) - std::exp(i * kappa * a)) / (i * kappa);
}

// A box of panels as long as its sides in waves of 8 to ½ lengths. Force: the pressure
// −ρg e^{kz − i…} on bottom, ends and sides, products of exponentials.
TEST(FroudeKrylovClosedForm, BoxOfPanelsLongerThanTheWave) {
  const double l = 20.0, b = 6.0, t = 4.0;
  const PanelMesh mesh = makePanels(wetBox({l, b, t, 0.0}, 1, 1, 1), true);
  const Vec3 cog(1.5, 0.0, -0.7);
  for (const double waveLength : {160.0, 40.0, 10.0})
    for (const double heading : {0.0, 0.6, 2.2}) {
      const double k = 2.0 * kPi / waveLength;
      const AiryWave wave{std::sqrt(k * kGravity), heading, kGravity};
      const double kx = k * std::cos(heading), ky = k * std::sin(heading);
      const Complex shift = std::polar(1.0, kx * cog.x());
      const Complex alongX = exponential(-kx, -l / 2, l / 2) * shift;
      const Complex alongY = exponential(ky, -b / 2, b / 2);
      const double alongZ = (1.0 - std::exp(-k * t)) / k;
      const auto endX = [&](double x) { return std::polar(1.0, -kx * x) * shift; };
      const Complex surge = (endX(l / 2) - endX(-l / 2)) * alongY * alongZ;
      const Complex sway =
          (std::polar(1.0, ky * b / 2) - std::polar(1.0, -ky * b / 2)) * alongX * alongZ;
      const Complex heave = -std::exp(-k * t) * alongX * alongY;
      const CVec6 force = froudeKrylovForce(mesh, wave, cog, 1000.0) / (-1000.0 * kGravity);
      const double scale = 1e-6 * l * b;  // the accuracy stated in the header, of the largest area
      EXPECT_LT(std::abs(force[Surge] - surge), scale);
      EXPECT_LT(std::abs(force[Sway] - sway), scale);
      EXPECT_LT(std::abs(force[Heave] - heave), scale);
    }
}

// Waves much longer than the ship lift it as the sea rises: F_3 → ρg A_wp, F_5 → −ρg∫x dA = 0 here.
TEST(FroudeKrylovClosedForm, VeryLongWavesLiftLikeTheTide) {
  const PanelMesh mesh = makePanels(wetBox({20.0, 6.0, 4.0, 0.0}, 4, 2, 2), true);
  const CVec6 force =
      froudeKrylovForce(mesh, {1e-3, kPi, kGravity}, Vec3::Zero(), kSeaWaterDensity);
  const double expected = kSeaWaterDensity * kGravity * 120.0;
  EXPECT_NEAR(std::abs(force[Heave] / expected - 1.0), 0.0, 2e-6);  // k·draft = 4e-7
}

// Head seas meet the bow first: with the crest over G, the force on a forward hull leads.
TEST(FroudeKrylovIdentity, PhaseFollowsTheCentreOfGravity) {
  const PanelMesh mesh = makePanels(wetHalfEllipsoid({5.0, 2.0, 1.0}, 8, 5), true);
  const AiryWave wave{1.7, 2.4, kGravity};
  const Vec3 cog(0.8, 0.0, 0.0);
  const CVec6 here = froudeKrylovForce(mesh, wave, cog, 1.0);
  const CVec6 centre = froudeKrylovForce(mesh, wave, Vec3::Zero(), 1.0);
  const Complex shift = std::polar(1.0, wave.waveNumber() * cog.x() * std::cos(wave.heading));
  for (const int mode : {Surge, Sway, Heave, Roll})
    EXPECT_LT(std::abs(here[mode] - shift * centre[mode]), 1e-12 * here.norm());
}

TEST(IncidentVelocityIdentity, EvenAndOddPartsAddUpToBothSides) {
  const SurfaceMesh port = wetHalfEllipsoid({5.0, 2.0, 1.0}, 8, 5);
  const AiryWave wave{1.7, 1.1, kGravity};
  const auto halves = incidentNormalVelocity(makePanels(port, true), wave, Vec3::Zero());
  const auto all = incidentNormalVelocity(makePanels(bothHalves(port), false), wave, Vec3::Zero());
  const Eigen::Index n = halves.even.size();
  // Panels of the mirror image have the same corners in another order: round-off only.
  EXPECT_LT((halves.even + halves.odd - all.even.head(n)).norm(), 1e-12 * all.even.norm());
  EXPECT_LT((halves.even - halves.odd - all.even.tail(n)).norm(), 1e-12 * all.even.norm());
}

// In waves much longer than the ship the water moves as one: v = −iω(i cos β, 0, −1)·n e^{…}, the
// flux of surge and heave through the same vector areas. What is left is k·length = 4e-6.
TEST(IncidentVelocityIdentity, LongWavesHaveTheFluxOfSurgeAndHeave) {
  const PanelMesh mesh = makePanels(wetFrigate(24, 5), true);
  const AiryWave wave{6e-4, kPi, kGravity};
  const IncidentVelocity v = incidentNormalVelocity(mesh, wave, Vec3::Zero());
  const Eigen::Vector3cd kappa = wave.exponent();
  const Complex amplitude(0.0, -wave.gravity / wave.omega);
  double worst = 0.0;
  for (std::size_t i = 0; i < mesh.panels.size(); ++i) {
    const Vec3 n = mesh.patches[i].vectorArea / mesh.panels[i].area;
    const Complex expected = amplitude * (kappa.x() * n.x() + kappa.z() * n.z());
    worst = std::max(worst, std::abs(v.even[static_cast<Eigen::Index>(i)] - expected));
  }
  EXPECT_LT(worst, 1e-5 * wave.omega);
}

TEST(PanelQuadratureClosedForm, WeightsSumToTheAreaAndMomentsToTheCentroid) {
  for (const Panel& panel : makePanels(wetFrigate(12, 4), true).panels) {
    for (int n = 2; n <= 5; ++n) {
      double area = 0.0;
      Vec3 moment = Vec3::Zero();
      for (const QuadraturePoint& point : panelQuadrature(panel, n)) {
        area += point.weight;
        moment += point.weight * point.x;
      }
      EXPECT_NEAR(area, panel.area, 1e-12 * panel.area);
      EXPECT_LT((moment / area - panel.centroid).norm(), 1e-11 * panel.centroid.norm());
    }
    double parts = 0.0;
    for (const Panel& part : quarters(panel))
      for (const QuadraturePoint& point : panelQuadrature(part, 2)) parts += point.weight;
    EXPECT_NEAR(parts, panel.area, 1e-12 * panel.area);
  }
}

// On a parallelogram and a triangle, whose maps are linear: all powers up to the degree as 6 × 6
// points have them, to round-off. A triangle of three quadrilaterals is not among them.
TEST(PanelQuadratureClosedForm, FewPointsAreExactToTheirDegree) {
  const Vec3 a(0.3, 0.2, -0.5), b(2.1, 0.5, -0.7), c(1.8, 1.4, -1.6);
  for (const Panel& panel : {flatPanel({a, b, c}), flatPanel({a, b, c, a + c - b})})
    for (const int degree : {3, 5}) {
      const bool isGauss = degree == 3 && panel.corners == 4;
      const std::vector<QuadraturePoint> few =
          isGauss ? panelQuadrature(panel, 2) : sevenPoints(panel);
      EXPECT_LE(few.size(), 7u);
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j) {
          const auto integral = [&](const std::vector<QuadraturePoint>& points) {
            double sum = 0.0;
            for (const auto& [x, weight] : points)
              sum += weight * std::pow(x.x(), i) * std::pow(x.z(), j);
            return sum;
          };
          EXPECT_NEAR(integral(few), integral(panelQuadrature(panel, 6)),
                      1e-12 * std::pow(3.0, i + j))
              << degree << ": " << i << ' ' << j;
        }
    }
}

}  // namespace
}  // namespace cutwater::test
