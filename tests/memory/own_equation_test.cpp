#include <gtest/gtest.h>

#include <cmath>

#include "hydro/memory/OwnEquation.h"
#include "hydro/memory/SpeedStability.h"

namespace cutwater {
namespace {

/// A ship of 5 m (volume 1 m³) without memory: masses and inertias 1, C₃₃ = 9, C₄₄ = 4, C₅₅ = 25,
/// A constant, in Tuck's form.
Coefficients plainShip() {
  Coefficients c;
  c.ship.mass = 1.0;
  c.ship.volume = 1.0;
  c.ship.gravity = 5.0;  // √(g/L) = 1 rad/s
  c.ship.symmetric = true;
  c.ship.restoring.diagonal() << 0, 0, 9, 4, 25, 0;
  c.omega = {0.5, 1.0, 1.5, 2.0};
  const Mat6 A = Vec6(0.1, 0.5, 1.0, 0.2, 0.5, 0.5).asDiagonal();
  c.addedMass.values.assign(4, A);
  c.addedMass.atZero = c.addedMass.atInfinity = A;
  c.damping.values.assign(4, Mat6::Zero());
  return c;
}

std::vector<GrowingMotion> growing(const Coefficients& c, double speed, bool lift = false) {
  const RadiationModel model(c, c.forwardSpeed);
  return OwnEquation(c, model).growing(speed, lift);
}

SpeedStability stabilityOf(const Coefficients& c, double last) {
  return speedStability(c, RadiationModel(c, c.forwardSpeed), last);
}

// s = (b ± √(b² − 4mC))/(2m) of m η̈ − b η̇ + C η = 0, m = 2, C = 9.
TEST(OwnEquationClosedForm, NegativeDampingGrowsAtItsRate) {
  Coefficients c = plainShip();
  EXPECT_TRUE(growing(c, 0.0).empty());
  c.ship.supplementary.damping[Heave] = -0.4;
  const auto found = growing(c, 0.0);
  ASSERT_EQ(found.size(), 2u);
  const Complex s = 0.1 + Complex(0.0, std::sqrt(4.5 - 0.01));
  EXPECT_LT(std::abs(Complex(found[0].s.real(), std::abs(found[0].s.imag())) - s), 1e-6);
  EXPECT_LT(std::abs(found[0].s - std::conj(found[1].s)), 1e-6);
  EXPECT_EQ(found[0].mode, Heave);
  c.ship.supplementary.damping[Heave] = 0.4;
  EXPECT_TRUE(growing(c, 0.0).empty());
}

TEST(OwnEquationClosedForm, AShipThatIsNotStableUprightFallsOver) {
  Coefficients c = plainShip();
  c.ship.restoring(Roll, Roll) = -1.2;
  const auto found = growing(c, 0.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].s.real(), 1.0, 1e-6);  // √(1.2/(1 + 0.2))
  EXPECT_EQ(found[0].mode, Roll);
  // Rightly, and at rest: no speed is to blame. A stiffness that the user adds holds it.
  EXPECT_FALSE(stabilityOf(c, 1.0).ahead.speed.has_value());
  EXPECT_TRUE(describe(stabilityOf(c, 1.0)).empty());
  c.ship.supplementary.stiffness[Roll] = 2.0;
  EXPECT_TRUE(growing(c, 0.0).empty());
}

TEST(SpeedStability, WhatGrowsAtRestAgainstItsStiffnessIsOutsideTheTheory) {
  Coefficients c = plainShip();
  c.ship.supplementary.damping[Roll] = -0.1;
  const SpeedStability s = stabilityOf(c, 1.0);
  EXPECT_EQ(s.ahead.speed, 0.0);
  EXPECT_EQ(s.ahead.mode, Roll);
}

// Tuck's c₅₅ is −U²A₃₃: the pitch of a fast ship has no stiffness left from U = √(C₅₅/A₃₃) = 5 on.
// Heave moves with it by b₃₅ and b₅₃, which do no work.
TEST(SpeedStabilityClosedForm, PitchDivergesWhereMunksMomentEatsItsStiffness) {
  Coefficients c = plainShip();
  EXPECT_FALSE(stabilityOf(c, 4.5).ahead.speed.has_value());
  c.ship.restoring(Heave, Heave) = 1e6;  // no heave: nothing else holds the pitch
  const SpeedStability s = stabilityOf(c, 10.0);
  ASSERT_TRUE(s.ahead.speed.has_value());
  EXPECT_NEAR(*s.ahead.speed, 5.0, 0.02);  // found to a thousandth of 10, growth above σ alone
  EXPECT_EQ(s.ahead.mode, Pitch);
  EXPECT_EQ(s.checkedTo, 10.0);
}

// Munk's moment turns a hull without a helm, at every speed: that is no fault of the theory. The
// lift of the hull keeps it on its course.
TEST(SpeedStability, ASlowTurnIsTheCoursesAlone) {
  const Coefficients c = plainShip();
  const auto found = growing(c, 2.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].mode == Sway || found[0].mode == Yaw);
  EXPECT_TRUE(growing(c, 2.0, true).empty());
  const SpeedStability s = stabilityOf(c, 4.5);
  EXPECT_FALSE(s.ahead.speed.has_value());
  EXPECT_FALSE(s.astern.speed.has_value());
  EXPECT_FALSE(s.course.has_value());
  EXPECT_TRUE(describe(s).empty());
}

TEST(SpeedStability, NothingIsCheckedWithoutRadiiOfGyration) {
  Coefficients c = plainShip();
  c.ship.gyradii = Vec3::Zero();
  EXPECT_EQ(stabilityOf(c, 4.5).checkedTo, 0.0);
}

}  // namespace
}  // namespace cutwater
