#include <gtest/gtest.h>

#include <cmath>

#include "hydro/forces/linear/HullLift.h"
#include "tests/forces/Predicted.h"

namespace cutwater {
namespace {

// Y = −e|U|v and N = −d|U|r of a ship's own leeway and turn, going ahead or astern.
TEST(HullLiftClosedForm, ResistsLeewayAndTurningInProportionToSpeed) {
  test::Predicted calm(SeaState{});
  HullLift lift(calm.motion);
  const HullLiftFactors& factors = calm.motion->response().lift();
  TickInput motion;
  motion.ownVelocityNow[Surge] = 11.0;  // lift is of the slow speed
  motion.ownVelocityNow[Sway] = 0.3;
  motion.ownVelocityNow[Yaw] = 0.02;
  for (const double speed : {10.0, -10.0}) {
    motion.speed = speed;
    const Vec6 force = lift.evaluate(motion).load;
    EXPECT_DOUBLE_EQ(force[Sway], -factors.side * 10.0 * 0.3);
    EXPECT_DOUBLE_EQ(force[Yaw], -factors.turn * 10.0 * 0.02);
    EXPECT_LT(force.dot(motion.ownVelocityNow), 0.0);
  }
  motion.ownVelocityNow.setZero();
  EXPECT_EQ(lift.evaluate(motion).load, Vec6::Zero().eval());
}

TEST(HullLift, GrowsNoMoreBeyondTheFastestSpeed) {
  test::Predicted calm(SeaState{});
  HullLift lift(calm.motion, 12.0), free(calm.motion);
  TickInput motion;
  motion.ownVelocityNow[Sway] = 0.3;
  motion.speed = 12.0;
  const Vec6 fastest = free.evaluate(motion).load;
  EXPECT_EQ(lift.evaluate(motion).load, fastest);
  motion.speed = -1000.0;
  EXPECT_EQ(lift.evaluate(motion).load, fastest);
}

// A hull that moves with the water of the waves feels none.
TEST(HullLiftIdentity, AnswersTheVelocityThroughTheWater) {
  test::Predicted waves(test::tableSea());
  HullLift lift(waves.motion);
  const HullLiftFactors& factors = waves.motion->response().lift();
  waves.renewAll({0.5, {6.0, 0.2}});
  waves.sumAt(3.0, 10.0, -4.0);
  const PredictedMotion::Sums& water = waves.motion->now();
  TickInput motion;
  motion.speed = 6.0;
  motion.ownVelocityNow[Sway] = water.orbitalAcross;
  motion.ownVelocityNow[Yaw] = water.orbitalTurn;
  EXPECT_EQ(lift.evaluate(motion).load, Vec6::Zero().eval());
  // And those sums are the waves', one by one.
  double across = 0.0, turn = 0.0;
  for (const WaveComponent& wave : waves.sea().components()) {
    const double k = wave.omega * wave.omega / test::kBoxGravity;
    const double phase = wave.omega * 3.0 -
                         k * (10.0 * std::cos(wave.heading) + 4.0 * std::sin(wave.heading)) +
                         wave.phase;
    const auto one = factors.orbital(wave.omega, k, wave.heading + 0.5);
    across += wave.amplitude * (one.side * std::polar(1.0, phase)).real();
    turn += wave.amplitude * (one.turn * std::polar(1.0, phase)).real();
  }
  EXPECT_NEAR(water.orbitalAcross, across, 1e-12);  // round-off of 40 components of 0.1 m/s
  EXPECT_NEAR(water.orbitalTurn, turn, 1e-13);
}

}  // namespace
}  // namespace cutwater
