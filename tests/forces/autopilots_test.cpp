#include "hydro/forces/linear/Autopilots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hydro/Errors.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {
namespace {

constexpr double kMass = 4e6, kLength = 120.0;

ShipParticulars keptShip() {
  ShipParticulars ship;
  ship.mass = kMass;
  ship.gyradii = Vec3(6.0, 30.0, 30.0);
  return ship;
}

Mat6 addedMass() {
  Vec6 diagonal;
  diagonal << 2e5, 3e6, 5e6, 1e8, 3e9, 2e9;
  return diagonal.asDiagonal();
}

Autopilots keepers() { return {keptShip(), addedMass(), kLength}; }

const double kSurging = kMass + 2e5, kYawing = kMass * 900.0 + 2e9;

/// A ship of mass m' under its keeper and a drag: the speed after each tick, semi-implicit as
/// Bullet does it.
template <class See>
double sail(Autopilots& keepers, double speed, double drag, double step, double duration, See see) {
  TickInput motion;
  motion.step = motion.lastStep = step;
  for (int n = 0; n * step < duration; ++n) {
    motion.time = n * step;
    motion.speed = speed;
    see(motion.time, speed);
    speed += step * (keepers.evaluate(motion).load[Surge] - drag) / kSurging;
  }
  return speed;
}

double speedError(double step) {
  Autopilots k = keepers();
  k.hold(SpeedKeeper{5.0, 1e12, 0.05});
  double error = 0.0;
  sail(k, 3.0, 0.0, step, 200.0, [&](double t, double speed) {
    error = std::max(error, std::abs(5.0 - speed - 2.0 * (1.0 - 0.05 * t) * std::exp(-0.05 * t)));
  });
  return error;
}

// m' dv/dt = m'(2ν e + ν²∫e): e = e₀ (1 − νt) e^{−νt}.
TEST(AutopilotsConvergence, SpeedComesBackAsADoublePoleDoes) {
  const double coarse = speedError(0.2), fine = speedError(0.1);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.1);  // one tick's delay
  EXPECT_LT(fine, 3.0 * 0.05 * 0.1 * 2.0);          // of the steepest slope, 3ν e₀
}

TEST(AutopilotsIdentity, TheIntegralCarriesASteadyDrag) {
  Autopilots k = keepers();
  k.hold(SpeedKeeper{5.0, 0.0, 0.05});
  const double drag = 5e5;  // below the default limit, 3 % of 3.9e7 N
  const double speed = sail(k, 5.0, drag, 0.1, 600.0, [](double, double) {});
  EXPECT_NEAR(speed, 5.0, 1e-8);  // e^{−30} of the start
  EXPECT_NEAR(k.integral(), drag / (kSurging * 0.05 * 0.05), 1e-4);
}

// From rest to 10 m/s at the limit of thrust: had the integral wound up over the 100 s, it would
// shoot past by metres per second; a double pole started at the limit overshoots by e^{−2}, 13.5 %,
// of 2/ν seconds of it.
TEST(Autopilots, ThrustKeepsItsLimitAndTheIntegralDoesNotWindUp) {
  Autopilots k = keepers();
  constexpr double kLimit = 4e5;
  k.hold(SpeedKeeper{10.0, kLimit, 0.05});
  double fastest = 0.0, most = 0.0;
  TickInput motion;
  for (int n = 0; n < 6000; ++n) {
    motion.time = 0.1 * n;
    const double thrust = k.evaluate(motion).load[Surge];
    most = std::max(most, std::abs(thrust));
    motion.speed += 0.1 * thrust / kSurging;
    fastest = std::max(fastest, motion.speed);
  }
  EXPECT_LE(most, kLimit);
  EXPECT_LT(fastest, 10.0 + 0.135 * 2.0 / 0.05 * kLimit / kSurging);
  EXPECT_NEAR(motion.speed, 10.0, 1e-3);
}

TEST(AutopilotsClosedForm, ThrustActsAlongTheBow) {
  Autopilots k = keepers();
  k.hold(SpeedKeeper{5.0, 1e9, 0.05});
  TickInput motion;
  motion.speed = 4.0;
  motion.etaDotNow[Surge] = 0.5;
  motion.eta[Yaw] = 0.3;  // bow to port, y to port
  const Vec6 force = k.evaluate(motion).load;
  EXPECT_NEAR(force[Surge], kSurging * 2.0 * 0.05 * 0.5 * std::cos(0.3), 1e-6);
  EXPECT_NEAR(force[Sway], kSurging * 2.0 * 0.05 * 0.5 * std::sin(0.3), 1e-6);
}

/// Heading error after t on a ship at rest, from e₀ = 0.2.
double headingError(double step) {
  Autopilots k = keepers();
  k.hold(CourseKeeper{1.0, 1e15, 0.1});
  TickInput motion;
  motion.meanHeading = 0.7;
  motion.eta[Yaw] = 0.1;
  double error = 0.0;
  for (int n = 0; n * step < 80.0; ++n) {
    const double t = motion.time = n * step;
    const double exact = 1.0 - 0.2 * (1.0 + 0.1 * t) * std::exp(-0.1 * t);
    error = std::max(error, std::abs(motion.meanHeading + motion.eta[Yaw] - exact));
    motion.etaDotNow[Yaw] += step * k.evaluate(motion).load[Yaw] / kYawing;
    motion.eta[Yaw] += step * motion.etaDotNow[Yaw];
  }
  return error;
}

// I'ψ̈ = k e − 2√(kI') r: critically damped at √(k/I') = ν at rest.
TEST(AutopilotsConvergence, HeadingComesBackCriticallyDamped) {
  const double coarse = headingError(0.2), fine = headingError(0.1);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.1);
  EXPECT_LT(fine, 0.2 * 0.1 * 0.1);  // a tick of the steepest slope, e₀ν/e, and some
}

// −U²A₂₂ of Munk's moment is met by +U²A₂₂: what is left is I'ν².
TEST(AutopilotsClosedForm, StiffnessOutweighsTheMunkMoment) {
  Autopilots k = keepers();
  k.hold(CourseKeeper{0.0, 1e15, 0.1});
  TickInput motion;
  motion.speed = 8.0;
  motion.eta[Yaw] = 0.01;
  const double munk = 64.0 * 3e6 * 0.01;
  EXPECT_NEAR(k.evaluate(motion).load[Yaw] + munk, -kYawing * 0.01 * 0.01, 1e-3);
}

TEST(Autopilots, MomentKeepsItsLimit) {
  Autopilots k = keepers();
  k.hold(CourseKeeper{3.0, 0.0, 0.1});
  TickInput motion;
  motion.speed = 10.0;
  const Vec6 force = k.evaluate(motion).load;
  EXPECT_DOUBLE_EQ(force[Yaw], 0.02 * kMass * keptShip().gravity * kLength);
  EXPECT_EQ(force[Sway], 0.0);
}

// A free ship's keepers see its slow motion alone: its surge and yaw in waves are not answered.
TEST(AutopilotsIdentity, OnAFreeShipTheyDoNotSeeWhatTheWavesDo) {
  Autopilots still(keptShip(), addedMass(), kLength, true), tossed = still;
  TickInput motion;
  motion.speed = 4.0;
  motion.meanHeading = 0.3;
  motion.turnRate = 0.01;
  TickInput inWaves = motion;
  inWaves.eta[Yaw] = 0.05;
  inWaves.etaDotNow[Surge] = 0.5;
  inWaves.etaDotNow[Yaw] = 0.02;
  for (Autopilots* k : {&still, &tossed}) {
    k->hold(SpeedKeeper{5.0, 1e9, 0.05});
    k->hold(CourseKeeper{0.0, 1e15, 0.1});
  }
  const Vec6 force = still.evaluate(motion).load;
  EXPECT_EQ(tossed.evaluate(inWaves).load, force);
  EXPECT_NEAR(force[Surge], kSurging * 2.0 * 0.05, 1e-6);
  EXPECT_EQ(force[Sway], 0.0);
  EXPECT_LT(force[Yaw], 0.0);
}

TEST(Autopilots, TurnsTheShorterWay) {
  Autopilots k = keepers();
  k.hold(CourseKeeper{3.0, 0.0, 0.1});
  TickInput motion;
  motion.meanHeading = -3.0;
  EXPECT_LT(k.evaluate(motion).load[Yaw], 0.0);  // 16° to starboard, not 344° to port
}

TEST(Autopilots, RestoredStateGivesTheSameBitsAndReleasedOnesAreSilent) {
  Autopilots one = keepers(), other = keepers();
  one.hold(SpeedKeeper{5.0, 0.0, 0.05});
  one.hold(CourseKeeper{0.3, 0.0, 0.1});
  const auto drive = [](Autopilots& k, int from, int to) {
    Vec6 sum = Vec6::Zero();
    TickInput motion;
    for (int n = from; n < to; ++n) {
      motion.time = 0.1 * n;
      motion.speed = 4.0 + std::sin(0.05 * n);
      motion.etaDotNow[Yaw] = 0.01 * std::cos(0.1 * n);
      sum += k.evaluate(motion).load;
    }
    return sum;
  };
  drive(one, 0, 300);
  std::vector<double> state(one.stateSize());
  one.save(state);
  ASSERT_TRUE(other.fits(state));
  other.restore(state);
  const Vec6 a = drive(one, 300, 500), b = drive(other, 300, 500);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0);
  one.releaseSpeed();
  one.releaseCourse();
  EXPECT_EQ(drive(one, 500, 510), Vec6::Zero().eval());
  one.hold(SpeedKeeper{5.0, 0.0, 0.05});
  EXPECT_EQ(one.integral(), 0.0);  // begins anew
}

TEST(Autopilots, RefusesNonsense) {
  Autopilots k = keepers();
  const double nan = std::nan("");
  EXPECT_THROW(k.hold(SpeedKeeper{nan, 0.0, 0.1}), HydroError);
  EXPECT_THROW(k.hold(SpeedKeeper{1.0, -1.0, 0.1}), HydroError);
  EXPECT_THROW(k.hold(SpeedKeeper{1.0, 0.0, 0.0}), HydroError);
  EXPECT_THROW(k.hold(CourseKeeper{HUGE_VAL, 0.0, 0.1}), HydroError);
  EXPECT_THROW(k.hold(CourseKeeper{1.0, nan, 0.1}), HydroError);
  EXPECT_THROW(Autopilots(keptShip(), addedMass(), 0.0), HydroError);
  EXPECT_FALSE(k.holdsSpeed());
  EXPECT_FALSE(k.holdsCourse());
  k.hold(SpeedKeeper{5.0, 0.0, 0.1});
  TickInput motion;
  motion.speed = nan;  // one bad tick leaves no trace
  k.evaluate(motion);
  EXPECT_EQ(k.integral(), 0.0);
}

}  // namespace
}  // namespace cutwater
