#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hydro/forces/linear/FreeRadiation.h"
#include "hydro/memory/RadiationModel.h"
#include "tests/forces/Predicted.h"

namespace cutwater {
namespace {

constexpr double kTick = 0.05;

struct Part {
  explicit Part(MemoryModel memory = MemoryModel::Exponential)
      : radiation(ship.hydrodynamics->radiation(), ship.motion, memory) {
    radiation.prepare(kTick);
  }
  Mat6 atRest() const { return ship.motion->response().addedMassAtRest(); }
  test::Predicted ship{SeaState{}};
  FreeRadiation radiation;
};

/// In calm water at this heading and pitch, with these velocities in own axes.
TickInput moving(double heading, double pitch, const Vec6& velocity) {
  TickInput now;
  now.step = now.lastStep = kTick;
  now.ownAxes = now.ownAxesBefore = now.attitude = ownAxes(heading, pitch);
  now.ownVelocity = now.ownVelocityNow = velocity;
  now.meanHeading = heading;
  now.speed = velocity[Surge];
  now.leeway = velocity[Sway];
  now.turnRate = velocity[Yaw];
  return now;
}

Vec6 way(double ahead, double leeway, double turn = 0.0) {
  Vec6 v = Vec6::Zero();
  v[Surge] = ahead;
  v[Sway] = leeway;
  v[Yaw] = turn;
  return v;
}

// A steady way feels the Munk moment of A(0) and nothing else, however long: the memory is that of
// a way that was there for ever.
TEST(FreeRadiationClosedForm, ASteadyWayFeelsMunksMoment) {
  for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
    Part part(memory);
    // A∞'s share of it goes with the added mass.
    const Mat6 A = part.atRest() - part.ship.hydrodynamics->radiation()->addedMassInf();
    TickInput now = moving(0.7, 0.0, way(3.0, 0.4));
    now.courseBegins = true;
    for (int n = 0; n < 200; ++n) {
      const Wrench wrench = part.radiation.evaluate(now);
      now.courseBegins = false;
      const Vec3 p = A.topLeftCorner<3, 3>() * Vec3(3.0, 0.4, 0.0);
      const double munk = -(3.0 * p.y() - 0.4 * p.x());
      EXPECT_EQ(wrench.axes, Axes::Earth);
      const double size = A(Sway, Sway) * 9.0;
      EXPECT_LT(wrench.load.head<3>().norm(), 1e-9 * size);  // round-off of momenta over a tick
      EXPECT_NEAR(wrench.load[Yaw], munk, 1e-9 * size);
    }
  }
}

// The impulses of a run are the momentum that is left in the water, for any motion and turning.
TEST(FreeRadiationIdentity, ImpulsesAddUpToTheMomentumLeft) {
  Part part;
  Vec3 impulse = Vec3::Zero();
  Mat3 before = ownAxes(0.2, 0.0);
  Vec3 first;
  double largest = 0.0;
  for (int n = 0; n < 400; ++n) {
    const double t = n * kTick;
    TickInput now = moving(0.2 + 0.1 * t, 0.1 * std::sin(t), way(2.0, 0.5 * std::sin(0.9 * t)));
    now.ownVelocity[Heave] = 0.8 * std::cos(1.1 * t);
    now.ownVelocity[Pitch] = 0.1 * std::cos(t);
    now.ownAxesBefore = before;
    now.courseBegins = n == 0;
    const Wrench wrench = part.radiation.evaluate(now);
    const Vec3 left = now.ownAxes * part.radiation.momentum().head<3>();
    if (n == 0) first = left;
    if (n > 0) impulse += kTick * wrench.load.head<3>();
    largest = std::max(largest, left.norm());
    EXPECT_LT((impulse + left - first).norm(), 1e-12 * (n + 1) * largest);
    before = now.ownAxes;
  }
}

// Turned by a right angle in one tick, with the velocity going on in E, momentum of surge becomes
// that of sway: what the axes lose of it the ship feels.
TEST(FreeRadiationIdentity, OwnAxesThatTurnKeepTheMomentumInTheEarth) {
  Part part;
  TickInput now = moving(0.0, 0.0, way(2.0, 0.0));
  now.courseBegins = true;
  part.radiation.evaluate(now);
  const Vec3 then = part.radiation.momentum().head<3>();
  now = moving(kPi / 2, 0.0, way(0.0, -2.0));
  now.ownAxesBefore = ownAxes(0.0, 0.0);
  const Wrench wrench = part.radiation.evaluate(now);
  const Vec3 left = now.ownAxes * part.radiation.momentum().head<3>();
  EXPECT_LT((kTick * wrench.load.head<3>() - (then - left)).norm(), 1e-12 * then.norm());
}

// Roll has no cross term: yaw and pitch of any size, without roll, make no roll moment of a hull
// whose roll is not coupled with them.
TEST(FreeRadiationIdentity, YawAndPitchMakeNoRollMoment) {
  Part part;
  const Mat6& A = part.ship.hydrodynamics->radiation()->addedMassInf();
  Mat3 before = ownAxes(0.0, 0.0);
  for (int n = 0; n < 100; ++n) {
    TickInput now = moving(0.02 * n, 0.1, Vec6::Zero());
    now.ownVelocity[Pitch] = now.ownVelocityNow[Pitch] = 0.05;
    now.ownVelocity[Yaw] = now.ownVelocityNow[Yaw] = 0.4;
    now.ownAxesBefore = before;
    now.courseBegins = n == 0;
    const Wrench wrench = part.radiation.evaluate(now);
    const Vec3 momentum = part.radiation.momentum().tail<3>();
    const double own = now.ownAxes.col(0).dot(wrench.load.tail<3>());
    const double coupled = std::abs(A(Roll, Yaw)) + std::abs(part.atRest()(Roll, Yaw));
    EXPECT_LT(std::abs(own), 1e-9 * (A(Yaw, Yaw) + momentum.norm()) + coupled);
    before = now.ownAxes;
  }
}

// A velocity that is set has always been there: no blow, and the waves of before go on.
TEST(FreeRadiationIdentity, AVelocityThatIsSetMakesNoBlow) {
  Part part, kept;
  TickInput now = moving(0.3, 0.0, way(1.0, 0.0));
  now.courseBegins = true;
  part.radiation.evaluate(now);
  now = moving(0.3, 0.0, way(4.0, 0.0));
  now.courseBegins = true;
  const Wrench wrench = part.radiation.evaluate(now);
  const Mat6 A = part.atRest();
  EXPECT_LT(wrench.load.head<3>().norm(), 1e-9 * A(Surge, Surge) * 4.0 / kTick);
  const Vec6 foreseen = kept.radiation.momentumOf({4.0, 0.0, 0.0});
  kept.radiation.evaluate(now);
  EXPECT_LT((part.radiation.momentum() - kept.radiation.momentum()).norm(),
            1e-12 * kept.radiation.momentum().norm());
  EXPECT_LT((kept.radiation.momentum() - foreseen).norm(), 1e-9 * foreseen.norm());
}

TEST(FreeRadiationIdentity, ASavedStateHasTheSameBitsEverAfter) {
  for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
    Part one(memory), other(memory);
    TickInput now = moving(0.3, 0.05, way(2.0, 0.2, 0.1));
    now.courseBegins = true;
    for (int n = 0; n < 30; ++n) {
      one.radiation.evaluate(now);
      now.courseBegins = false;
    }
    std::vector<double> state(one.radiation.stateSize());
    one.radiation.save(state);
    ASSERT_TRUE(other.radiation.fits(state));
    EXPECT_FALSE(other.radiation.fits(std::span<const double>(state).first(9)));
    other.radiation.restore(state);
    for (int n = 0; n < 30; ++n)
      EXPECT_EQ(one.radiation.evaluate(now).load, other.radiation.evaluate(now).load);
    one.radiation.reset();
    EXPECT_EQ(one.radiation.momentum(), Vec6::Zero().eval());
  }
}

}  // namespace
}  // namespace cutwater
