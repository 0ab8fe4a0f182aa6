#include <gtest/gtest.h>

#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/incident/IncidentWaveForce.h"
#include "hydro/incident/LackingRestoring.h"

namespace cutwater {
namespace {

const Vec3 kG(-2.4, 0.0, 1.29);
constexpr double kDensity = 1025.0;

/// A coarse division of the frigate that stands for the fine one.
struct Coarse {
  SurfaceMesh hull = closedFrigate(80, 24), wet = wetFrigate(20, 4),
              whole = WetSurface(wet, true).whole();
  Mat6 hullsOwn = stiffness(displacingSurface({hull, true})), panelsOwn = stiffness(whole);
  LackingRestoring lacking{whole, {hull, true}, hullsOwn, kG, kDensity, kStandardGravity};

  static Mat6 stiffness(const SurfaceMesh& mesh) {
    return hydrostatics(mesh, kG, kDensity, kStandardGravity).restoring;
  }
  CVec6 force(const AiryWave& wave) const {
    return froudeKrylovForce(WetSurface(wet, true).faces(), wave, kG, kDensity) +
           lacking.force(wave);
  }
};

// A wave half a million times as long as the ship lifts it by its height and tilts it by its slope:
// F_I → C η of the hull, to the next order in the wave number, kL = 1e-5; of the panels, C differs
// by percents.
TEST(LackingRestoringIdentity, LongWavesMoveTheShipAsTheyMoveTheWater) {
  const Coarse coarse;
  EXPECT_GT(std::abs(coarse.panelsOwn(Roll, Roll) / coarse.hullsOwn(Roll, Roll) - 1.0), 0.01);
  for (const double beta : {kPi, 0.5 * kPi, 0.7}) {
    const AiryWave wave{1e-3, beta, kStandardGravity};
    const CVec6 force = coarse.force(wave);
    const Complex slope(0.0, wave.waveNumber());  // ζ = e^{−ik(x cos β − y sin β)}
    CVec6 water = CVec6::Zero();
    water[Heave] = 1.0;
    water[Roll] = slope * std::sin(beta);
    water[Pitch] = slope * std::cos(beta);
    const CVec6 expected = coarse.hullsOwn * water;
    EXPECT_NEAR(std::abs(force[Heave] / expected[Heave] - 1.0), 0.0, 1e-4);
    EXPECT_LT(std::abs(force[Roll] - expected[Roll]),
              1e-4 * std::abs(coarse.hullsOwn(Roll, Roll) * slope));
    // Heave at a distance from the waterplane's centre is the greater part of the moment.
    EXPECT_LT(std::abs(force[Pitch] - expected[Pitch]), 1e-4 * std::abs(expected[Pitch]));
    // Archimedes on a slope: −ρgV ∇ζ, at the centre of buoyancy.
    const Hydrostatics h =
        hydrostatics(displacingSurface({coarse.hull, true}), kG, kDensity, kStandardGravity);
    const double weight = kStandardGravity * h.displacement;
    const Complex alongX = -slope * std::cos(beta), alongY = slope * std::sin(beta);
    EXPECT_LT(std::abs(force[Surge] + weight * alongX), 1e-4 * weight * std::abs(slope));
    EXPECT_LT(std::abs(force[Sway] + weight * alongY), 1e-4 * weight * std::abs(slope));
    const double arm = h.buoyancy.x() - kG.x();
    EXPECT_LT(std::abs(force[Yaw] + weight * arm * alongY), 1e-4 * weight * std::abs(slope));
  }
}

// What is lacking is known as a plane's force. In waves shorter than the ship the plane is flat.
TEST(LackingRestoring, FadesInShortWaves) {
  const Coarse coarse;
  const auto share = [&](double omega) {
    const AiryWave wave{omega, kPi, kStandardGravity};
    return std::abs(coarse.lacking.force(wave)[Heave]) /
           std::abs(coarse.lacking.force({1e-3, kPi, kStandardGravity})[Heave]);
  };
  EXPECT_GT(share(0.3), 0.7);   // λ = 5.5 L
  EXPECT_LT(share(1.5), 0.15);  // λ = 0.22 L
}

TEST(LackingRestoring, NothingIsLackingOfTheHullItselfOrOfAnotherShipsRestoring) {
  const Coarse coarse;
  const AiryWave wave{0.5, 0.7, kStandardGravity};
  const auto force = [&](const SurfaceMesh& wet, const Hull& hull, const Mat6& restoring) {
    return LackingRestoring(wet, hull, restoring, kG, kDensity, kStandardGravity).force(wave);
  };
  const Hull hull{coarse.hull, true};
  EXPECT_EQ(force(displacingSurface(hull), hull, coarse.hullsOwn), CVec6::Zero());
  EXPECT_EQ(force(coarse.whole, hull, coarse.panelsOwn), CVec6::Zero());
  EXPECT_EQ(force(coarse.whole, {}, coarse.hullsOwn), CVec6::Zero());
  EXPECT_EQ(LackingRestoring().force(wave), CVec6::Zero());
}

}  // namespace
}  // namespace cutwater
