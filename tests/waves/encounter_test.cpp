#include "hydro/waves/Encounter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cutwater {
namespace {

constexpr double kG = 9.81;
/// The speed at which a following wave of 1 rad/s is neither met nor overtaken.
constexpr double kStandStill = kG;

CVec6 anyForce(double first) {
  CVec6 force;
  for (int j = 0; j < 6; ++j) force[j] = Complex(first + j, 0.5 * first - 2.0 * j);
  return force;
}

// ω′ = ω − (ω²/g) U cos β.
TEST(EncounterClosedForm, FrequencyHasTheSignOfTheMeeting) {
  const Encounter head(1.0, 5.0, kPi, kG);
  EXPECT_DOUBLE_EQ(head.signedFrequency(), 1.0 + 5.0 / kG);
  EXPECT_EQ(head.frequency(), head.signedFrequency());
  EXPECT_FALSE(head.overtaking());
  const Encounter following(1.0, 5.0, 0.0, kG);  // the wave is faster
  EXPECT_DOUBLE_EQ(following.signedFrequency(), 1.0 - 5.0 / kG);
  EXPECT_FALSE(following.overtaking());
  const Encounter overtaken(2.5, 5.0, 0.0, kG);  // the ship is faster
  EXPECT_DOUBLE_EQ(overtaken.signedFrequency(), 2.5 - 2.5 * 2.5 * 5.0 / kG);
  EXPECT_EQ(overtaken.frequency(), -overtaken.signedFrequency());
  EXPECT_TRUE(overtaken.overtaking());
  EXPECT_EQ(overtaken.speed(), 5.0);
  EXPECT_FALSE(Encounter(1.0, kStandStill, 0.0, kG).overtaking());
  EXPECT_EQ(Encounter(1.0, kStandStill, 0.0, kG).frequency(), 0.0);
  const AiryWave wave{2.5, 0.3, kG};
  EXPECT_EQ(Encounter(wave, 5.0).signedFrequency(), Encounter(2.5, 5.0, 0.3, kG).signedFrequency());
}

// ω′ = ω − k(U cos β − V sin β): waves travel towards (cos β, −sin β), leeway is to port, so that a
// beam sea from port (β = 90°, travelling to starboard) is met the oftener.
TEST(EncounterClosedForm, LeewayIsWayTowardsTheWavesToo) {
  EXPECT_DOUBLE_EQ(Encounter(1.0, 0.0, 0.5, kPi / 2, kG).signedFrequency(), 1.0 + 0.5 / kG);
  const double beta = 0.7, along = 5.0 * std::cos(beta) - 0.5 * std::sin(beta);
  EXPECT_NEAR(Encounter(0.9, 5.0, 0.5, beta, kG).signedFrequency(), 0.9 - 0.81 / kG * along, 1e-15);
  EXPECT_EQ(Encounter(0.9, 5.0, 0.0, beta, kG).signedFrequency(),
            Encounter(0.9, 5.0, beta, kG).signedFrequency());
  EXPECT_EQ(Encounter(0.9, 5.0, 0.5, beta, kG).speed(), 5.0);
}

// Re{a e^{iω′t}} is the same motion in time, and twice conjugated is as before.
TEST(EncounterIdentity, ConjugatedAmplitudesAreTheSameInTime) {
  const CVec6 a = anyForce(1.0);
  for (const double speed : {5.0, 30.0}) {
    const Encounter met(1.0, speed, 0.0, kG);
    ASSERT_EQ(met.overtaking(), speed > kStandStill);
    const CVec6 b = met.conjugatedIfOvertaking(a);
    EXPECT_EQ(b, met.overtaking() ? a.conjugate().eval() : a);
    EXPECT_EQ(met.conjugatedIfOvertaking(b), a);
    for (const double t : {0.0, 0.7, 5.0}) {
      const CVec6 x = a * std::polar(1.0, met.signedFrequency() * t);
      const CVec6 y = b * std::polar(1.0, met.frequency() * t);
      EXPECT_LT((x - y).real().norm(), 1e-13);  // round-off of numbers of order 10
    }
  }
}

// Of parts F^ω and F^U of one wave: with v the wave, F(v) linear in v and real operators, the parts
// of the conjugated wave are the conjugates as ω_e → 0. Just before and just after ω′ = 0 the force
// differs by what ω′ itself has changed, 2·1e-9·|F^ω|.
TEST(EncounterIdentity, DiffractionForceIsContinuousWhereTheShipKeepsUpWithTheWave) {
  const CVec6 omegaPart = anyForce(3.0), speedPart = anyForce(-1.0);
  const double step = 1e-9;
  const Encounter before(1.0, kStandStill * (1.0 - step), 0.0, kG);
  const Encounter after(1.0, kStandStill * (1.0 + step), 0.0, kG);
  ASSERT_FALSE(before.overtaking());
  ASSERT_TRUE(after.overtaking());
  const CVec6 slow = before.diffractionForce(omegaPart, speedPart);
  const CVec6 fast = after.diffractionForce(after.conjugatedIfOvertaking(omegaPart),
                                            after.conjugatedIfOvertaking(speedPart));
  EXPECT_LT((slow - kStandStill * speedPart).norm(), 2.0 * step * (omegaPart.norm() + kG * 20.0));
  EXPECT_LT((fast - slow).norm(), 4.0 * step * (omegaPart.norm() + kG * speedPart.norm()));
}

// Signs: ω_e F^ω + U F^U, and its conjugate where the ship overtakes.
TEST(EncounterClosedForm, DiffractionForceOfItsTwoParts) {
  const CVec6 a = anyForce(3.0), b = anyForce(-1.0);
  EXPECT_EQ(Encounter(0.8, 0.0, kPi, kG).diffractionForce(a, b), (0.8 * a).eval());
  const Encounter head(0.8, 6.0, kPi, kG), overtaken(2.5, 6.0, 0.0, kG);
  EXPECT_EQ(head.diffractionForce(a, b), (head.frequency() * a + 6.0 * b).eval());
  EXPECT_EQ(overtaken.diffractionForce(a, b),
            (overtaken.frequency() * a + 6.0 * b).conjugate().eval());
  // At rest F^U is not looked at.
  const CVec6 none = CVec6::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(Encounter(0.8, 0.0, kPi, kG).diffractionForce(a, none).allFinite());
}

}  // namespace
}  // namespace cutwater
