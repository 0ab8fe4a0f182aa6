#include <gtest/gtest.h>

#include <cmath>

#include "hydro/excitation/WaveExcitation.h"
#include "hydro/response/FrequencyResponse.h"
#include "tests/excitation/BoxShip.h"

namespace cutwater {
namespace {

using test::boxShip, test::kBoxDensity, test::kBoxGravity;

TEST(FrequencyResponseClosedForm, LongWavesCarryTheShipLikeARaft) {
  // ω → 0: heave 1, pitch = wave slope: head wave ζ = cos(ωt + kx), bow-down pitch −∂ζ/∂x = k sin:
  // phase −90°... with η5 = −∂ζ/∂x = k sin(ωt) = Re{−ik e^{iωt}}. Restoring and wave pressure
  // balance to order kL.
  // The made-up diffraction has no moment arm and does not vanish beside pitch's: left out. G is
  // amidships: the 1e-3 by which heave's inertia lifts the ship is 6 % of this slope at half a
  // metre of lever.
  Coefficients ship = boxShip(Vec3(0.0, 0.0, 0.3));
  for (auto& vectors : ship.adjoint) vectors.setZero();
  const double k = 2e-4, omega = std::sqrt(k * kBoxGravity);
  const CVec6 eta = FrequencyResponse(ship).at(omega, kPi);
  EXPECT_NEAR(std::abs(eta[Heave] - 1.0), 0.0, 0.01);
  EXPECT_NEAR(std::abs(eta[Pitch] - Complex(0.0, -k)) / k, 0.0, 0.02);
}

TEST(FrequencyResponseIdentity, SolvesTheEquationOfMotion) {
  Coefficients ship = boxShip();
  ship.ship.supplementary.damping[Roll] = 1e5;
  ship.ship.supplementary.stiffness[Yaw] = 2e6;
  const double omega = 1.2;  // a node of the grid: A and B are the data themselves
  const CVec6 eta = FrequencyResponse(ship).at(omega, 0.8);
  Mat6 inertia = ship.ship.massMatrix() + ship.addedMass[11], damping = ship.damping[11];
  Mat6 stiffness = ship.ship.restoring;
  damping(Roll, Roll) += 1e5;
  stiffness(Yaw, Yaw) += 2e6;
  const CVec6 left = (-omega * omega * inertia + stiffness).cast<Complex>() * eta +
                     Complex(0, omega) * (damping.cast<Complex>() * eta);
  const CVec6 force = WaveExcitation(ship).at(omega, 0.8).total();
  EXPECT_LT((left - force).norm(), 1e-9 * force.norm());
}

TEST(FrequencyResponse, RestrainedModesDoNotMove) {
  const Coefficients ship = boxShip();
  const CVec6 eta = FrequencyResponse(ship, {true, false, false, false, false, true}).at(1.0, 0.5);
  EXPECT_EQ(eta[Surge], Complex(0.0));
  EXPECT_EQ(eta[Yaw], Complex(0.0));
  EXPECT_GT(std::abs(eta[Heave]), 0.0);
}

TEST(FrequencyResponse, RefusesAFreeRotationWithoutRadiusOfGyration) {
  Coefficients ship = boxShip();
  ship.ship.gyradii = Vec3::Zero();
  EXPECT_ANY_THROW(FrequencyResponse{ship});
  EXPECT_NO_THROW(FrequencyResponse(ship, {false, false, false, true, true, true}));
}

}  // namespace
}  // namespace cutwater
