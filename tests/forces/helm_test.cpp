// Autopilots that steer by an engine and a rudder.
#include "hydro/forces/Helm.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/forces/linear/Autopilots.h"

namespace cutwater {
namespace {

constexpr double kMass = 4e6, kLength = 120.0, kRounding = 1e-12;

Autopilots keepers(const std::shared_ptr<Helm>& helm) {
  ShipParticulars ship;
  ship.mass = kMass;
  ship.gyradii = Vec3(6.0, 30.0, 30.0);
  Vec6 added;
  added << 2e5, 3e6, 5e6, 1e8, 3e9, 2e9;
  Autopilots autopilots(ship, Mat6(added.asDiagonal()), kLength, true);
  autopilots.steerBy(helm);
  return autopilots;
}

const double kSurging = kMass + 2e5, kYawing = kMass * 900.0 + 2e9;

TickInput at(double speed, double heading = 0.0, double rate = 0.0) {
  TickInput now;
  now.step = now.lastStep = 0.02;
  now.speed = speed;
  now.meanHeading = heading;
  now.turnRate = rate;
  return now;
}

std::shared_ptr<Helm> helmOf(bool engine, bool rudder) {
  return std::make_shared<Helm>(Helm{.engine = engine,
                                     .rudder = rudder,
                                     .thrustAhead = 6e5,
                                     .thrustAstern = 3e5,
                                     .noThrustSpeed = 20.0,
                                     .rudderLimit = 0.6});
}

TEST(HelmClosedForm, FullThrustIsALine) {
  const auto helm = helmOf(true, false);
  EXPECT_EQ(helm->fullThrust(false, 0.0), 6e5);
  EXPECT_NEAR(helm->fullThrust(false, 5.0), 4.5e5, kRounding * 6e5);
  EXPECT_EQ(helm->fullThrust(false, -5.0), 6e5);
  EXPECT_NEAR(helm->fullThrust(true, -5.0), 2.25e5, kRounding * 6e5);
  EXPECT_EQ(helm->fullThrust(true, 30.0), 3e5);
  EXPECT_EQ(helm->fullThrust(false, 30.0), 0.0);
}

// T = R + m' 2ν e in the first tick, as a share of what the engine has at this speed.
TEST(HelmClosedForm, ASpeedIsHeldByTheThrottle) {
  const auto helm = helmOf(true, false);
  Autopilots autopilots = keepers(helm);
  autopilots.hold(SpeedKeeper{.speed = 5.0, .rate = 0.02}, 1e5);
  EXPECT_TRUE(autopilots.evaluate(at(4.0)).load.isZero(0.0));
  const double thrust = 1e5 + kSurging * 2.0 * 0.02 * 1.0;
  EXPECT_NEAR(helm->throttle, thrust / (6e5 * (1.0 - 4.0 / 20.0)), kRounding);
  autopilots.evaluate(at(30.0));  // far too fast: full astern, no more
  EXPECT_EQ(helm->throttle, -1.0);
  autopilots.evaluate(at(-30.0));
  EXPECT_EQ(helm->throttle, 1.0);
}

// At the speed wanted the thrust is the drag that is expected there, with an engine or without.
TEST(HelmClosedForm, TheExpectedDragIsThereFromTheStart) {
  for (const bool engine : {true, false}) {
    const auto helm = helmOf(engine, false);
    Autopilots autopilots = keepers(helm);
    autopilots.hold(SpeedKeeper{.speed = 5.0}, 9e4);
    const double push = autopilots.evaluate(at(5.0)).load[Surge];
    EXPECT_NEAR(engine ? helm->throttle * helm->fullThrust(false, 5.0) : push, 9e4, 1e-6);
  }
}

// δ = N/(dN/dδ).
TEST(HelmClosedForm, ACourseIsHeldByTheRudder) {
  const auto helm = helmOf(false, true);
  Autopilots autopilots = keepers(helm);
  autopilots.hold(CourseKeeper{.heading = 0.1, .rate = 0.1});
  const double least = kYawing * 0.01, k = least + 3e6 * 36.0;
  const double moment = k * 0.02 - 2.0 * std::sqrt(k * kYawing) * 1e-4;
  helm->momentPerAngle = 2.0 * least;
  EXPECT_TRUE(autopilots.evaluate(at(6.0, 0.08, 1e-4)).load.isZero(0.0));
  EXPECT_NEAR(helm->angle, moment / (2.0 * least), kRounding);
  helm->momentPerAngle = -2.0 * least;  // the water comes from astern
  autopilots.evaluate(at(6.0, 0.08, 1e-4));
  EXPECT_NEAR(helm->angle, -moment / (2.0 * least), kRounding);
  helm->momentPerAngle = 0.5 * least;  // it hardly bites
  autopilots.evaluate(at(6.0, 0.08, 1e-4));
  EXPECT_NEAR(helm->angle, 0.5 * moment / least, kRounding);
  helm->momentPerAngle = 0.0;
  autopilots.evaluate(at(6.0, 0.08, 1e-4));
  EXPECT_EQ(helm->angle, 0.0);
  helm->momentPerAngle = least;
  autopilots.evaluate(at(6.0, -1.5));
  EXPECT_EQ(helm->angle, 0.6);  // its limit
}

// With an engine alone a ship is turned by the moment, with a rudder alone pushed by the thrust.
TEST(Helm, WhatIsNotThereIsPushedByHand) {
  Autopilots one = keepers(helmOf(true, false)), other = keepers(helmOf(false, true));
  for (Autopilots* autopilots : {&one, &other}) {
    autopilots->hold(SpeedKeeper{.speed = 5.0});
    autopilots->hold(CourseKeeper{.heading = 0.1});
  }
  const Vec6 engine = one.evaluate(at(4.0)).load, rudder = other.evaluate(at(4.0)).load;
  EXPECT_EQ(engine[Surge], 0.0);
  EXPECT_GT(engine[Yaw], 0.0);
  EXPECT_GT(rudder[Surge], 0.0);
  EXPECT_EQ(rudder[Yaw], 0.0);
}

TEST(Helm, TheExpectedDragIsPartOfTheState) {
  const auto helm = helmOf(true, false);
  Autopilots a = keepers(helm), b = keepers(helmOf(false, false));
  a.hold(SpeedKeeper{.speed = 5.0}, 7e4);
  std::array<double, 11> state{};
  ASSERT_EQ(a.stateSize(), state.size());
  a.save(state);
  b.restore(state);
  EXPECT_NEAR(b.evaluate(at(5.0)).load[Surge], 7e4, 1e-6);
}

}  // namespace
}  // namespace cutwater
