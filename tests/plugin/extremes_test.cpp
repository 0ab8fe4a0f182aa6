// Ships that begin anew, that are small, thrown, upside down, drawn between ticks.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/linear/Restoring.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

// Beginning again.

TEST(ShipGuard, AResetShipHasTheBitsOfANewOne) {
  const ShipStart moving{.x = 20,
                         .y = -7,
                         .heading = 0.4,
                         .speed = 4,
                         .offset = one(Roll, 0.1) + one(Heave, 0.4),
                         .velocity = one(Sway, 0.3)};
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    const ShipModel model{.mean = mean, .keepSpeed = SpeedKeeper{.speed = 5}};
    // The stand-in's waves are for a ship at rest.
    ShipStart start = moving;
    if (mean == Mean::Fixed) start.speed = 0.0;
    const SeaState sea = mean == Mean::Fixed ? waves() : SeaState();
    Scene used({.start = {.heading = 1.0}, .model = model}, sea, slenderShip());
    Scene fresh({.start = start, .model = model}, sea, slenderShip());
    used.run(200);
    bodyOf(used).applyCentralImpulse(btVector3(1e6, 1e5, 0));
    used.sphere->reset(start);
    fresh.run(200);  // the same moment of the sea; the ship is a new one
    fresh.seaway.removeShip(*fresh.sphere);
    fresh.sphere = &fresh.seaway.addShip(
        fresh.coefficients, {.start = start, .model = model, .collision = {.shape = &fresh.shape}});
    used.run(200);
    fresh.run(200);
    EXPECT_TRUE(sameBits(bodyOf(used), bodyOf(fresh)));
    EXPECT_EQ(used.sphere->lastTick().loads, fresh.sphere->lastTick().loads);
    EXPECT_EQ(used.seaway.faults(), kStepOk);
  }
}

TEST(ShipGuard, TwoEpisodesFromOnePlaceAreTheSameBits) {
  Scene scene(
      {.start = {.speed = 6}, .model = {.mean = Mean::Free, .keepSpeed = SpeedKeeper{.speed = 6}}},
      {}, slenderShip());
  btVector3 ends[2];
  for (btVector3& end : ends) {
    scene.sphere->placeAt(0, 0, 0, one(Heave, 0.3) + one(Roll, 0.05), 6);
    scene.run(64 * 20);
    end = bodyOf(scene).getCenterOfMassPosition();
  }
  EXPECT_EQ((ends[0] - ends[1]).length(), 0);
}

// Single precision.

// Where the product of three inertias is below a float's epsilon, in units of the world, Bullet's
// own gyroscopic term is gone: of a model, or, as here, in a world of millions of tonnes.
TEST(ShipGuard, SmallInertiasKeepTheirGyroscopicTerm) {
  btSphereShape shape(5);
  const auto turned = [&](double kilograms) {
    TestWorld world(kSphereGravity);
    Seaway seaway(world.world, {}, {.kilogramsPerUnit = kilograms});
    const ShipStart start{.velocity = one(Roll, 0.4) + one(Yaw, 0.3)};
    Ship& ship = seaway.addShip(slenderShip(), {.start = start, .collision = {.shape = &shape}});
    for (int i = 0; i < 320; ++i) world.world.stepSimulation(kTick, 1, kTick);
    return ship.attitude();
  };
  const Vec3 usual = turned(1.0), small = turned(1e12);
  EXPECT_GT(std::abs(usual[1]), 0.002);     // pitch comes from nothing but roll times yaw
  EXPECT_LT((small - usual).norm(), 1e-4);  // without the term pitch is 0.002 off
}

// Far outside the theory.

// From the air, and upside down in a storm: whatever it does, it comes back or stays bounded.
TEST(ShipGuard, ThrownFromAKilometreItComesToRest) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Scene scene({.start = {.offset = one(Heave, 1000) + one(Roll, 0.3) + one(Pitch, 0.2)},
                 .model = {.mean = mean}},
                {}, slenderShip());
    scene.run(64 * 600);
    EXPECT_EQ(scene.seaway.faults() & ~kWarningBits, kStepOk);
    EXPECT_NE(scene.seaway.faults() & kOutOfWater, kStepOk);
    EXPECT_LT(std::abs(scene.sphere->velocity()[2]), 0.01);
    EXPECT_LT(std::abs(scene.sphere->attitude()[0]), 0.01);
  }
}

// Rolled over and over without radiation and brake: restoring has a potential, so that the spin is
// what it was at each turn. A moment that jumped at 180 degrees would add to it turn by turn.
// Bound: what the scheme, of second order in the tick, leaves: (2.5/64)² of the spin a radian.
TEST(ShipGuard, RolledOverAndOverItGainsNoEnergy) {
  const auto spinAfterTurns = [](int mode) {
    Restoring restoring(slenderShip().ship);
    const ShipParticulars ship = slenderShip().ship;
    const double inertia = ship.massMatrix()(mode, mode);
    const double start = mode == Roll ? 2.5 : 5.0;
    double angle = 0.0, spin = start;
    int turns = 0;
    for (const double step = 1.0 / 64; turns < 20 && spin > 0.0;) {
      TickInput now;
      now.step = step;
      now.eta[mode] = std::remainder(angle, 2.0 * kPi);
      spin += step * restoring.evaluate(now).load[mode] / inertia;
      angle += step * spin;
      if (angle >= 2.0 * kPi * (turns + 1)) ++turns;
    }
    return spin / start;
  };
  for (const int mode : {Roll, Pitch}) {
    EXPECT_NEAR(spinAfterTurns(mode), 1.0, 0.02) << mode;
  }
}

// Upside down in steep waves for half an hour: no more than it had, and no more than waves give.
TEST(ShipGuard, CapsizedInAStormItStaysBounded) {
  const SeaState sea({{.omega = 0.6, .amplitude = 3.0, .heading = 1.6},
                      {.omega = 0.8, .amplitude = 2.0, .phase = 1.0, .heading = 1.2}},
                     kSphereGravity, 10.0);
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Scene scene({.start = {.offset = one(Roll, 2.9) + one(Pitch, 0.4)}, .model = {.mean = mean}},
                sea, slenderShip());
    double fastest = 0.0, highest = 0.0;
    for (int i = 0; i < 64 * (kDouble ? 1800 : 300); ++i) {
      scene.run(1);
      fastest = std::max(fastest, scene.sphere->velocity().tail<3>().norm());
      highest = std::max(highest, std::abs(heaveOf(scene)));
    }
    EXPECT_EQ(scene.seaway.faults() & ~kWarningBits, kStepOk);
    EXPECT_NE(scene.seaway.faults() & kAttitudeOutsideTheory, kStepOk);
    EXPECT_LT(fastest, 5.0);
    EXPECT_LT(highest, 30.0);
  }
}

Mat3 rotation(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
          Eigen::AngleAxisd(roll, Vec3::UnitX()))
      .toRotationMatrix();
}

TEST(MotionAngles, AreEulersWhenUprightAndHaveNoJumpBeyond) {
  EXPECT_EQ(motionAngles(rotation(0.3, -0.2, 2.0)), eulerAngles(rotation(0.3, -0.2, 2.0)));
  // Roll alone and pitch alone are themselves to ±180 degrees.
  for (const double angle : {-3.1, -1.6, -0.7, 0.6, 1.5, 1.7, 3.0}) {
    EXPECT_LT((motionAngles(rotation(angle, 0, 0.4)) - Vec3(angle, 0, 0.4)).norm(), 1e-12);
    EXPECT_LT((motionAngles(rotation(0, angle, 0.4)) - Vec3(0, angle, 0.4)).norm(), 1e-12);
  }
  // Over the bow, with some roll: no step is larger than a few times the turn.
  Vec3 before = motionAngles(rotation(0.2, 0.0, 0.3));
  for (int i = 1; i < 2800; ++i) {
    Vec3 step = motionAngles(rotation(0.2, 0.001 * i, 0.3)) - before;
    step.z() = std::remainder(step.z(), 2.0 * kPi);
    EXPECT_LT(step.norm(), 0.005) << i;
    before += step;
  }
}

// A ship that rolls over, its bow up and down a little as it goes.
TEST(BowAngles, AreEulersWhileTheBowIsLevelAndHaveNoJumpKeelUp) {
  for (int i = -314; i <= 314; ++i) {
    const double roll = 0.01 * i, pitch = 0.5 * std::sin(7.0 * roll);
    EXPECT_EQ(bowAngles(rotation(roll, pitch, 0.3)), eulerAngles(rotation(roll, pitch, 0.3)));
  }
  // motionAngles turn by 180 degrees in between.
  const Vec3 before(kPi - 0.01, 0.001, 0.3), after(kPi + 0.01, 0.001, 0.3);
  const auto heading = [](auto angles, const Vec3& at) {
    return angles(rotation(at.x(), at.y(), at.z())).z();
  };
  EXPECT_NEAR(heading(bowAngles, before), heading(bowAngles, after), 1e-12);
  EXPECT_GT(std::abs(heading(motionAngles, before) - heading(motionAngles, after)), 0.1);
  // A steep bow has the heading of motionAngles, which does not jump there.
  EXPECT_EQ(bowAngles(rotation(0.2, 1.5, 0.3)), motionAngles(rotation(0.2, 1.5, 0.3)));
}

// Shared among worlds.

TEST(ShipGuard, WaveLoadsLiveAsLongAsTheirHydrodynamics) {
  const auto hydro = std::make_shared<const Hydrodynamics>(slenderShip());
  const SeaTables first(hydro, std::make_shared<const SeaState>(waves()));
  const auto* table = first.following().front().get();
  const auto* course = first.exact(0.4, 0.0).get();
  // Other heights and phases of the same waves are the same loads per metre.
  const SeaState sea = waves();
  std::vector<WaveComponent> higher(sea.components().begin(), sea.components().end());
  for (WaveComponent& wave : higher) {
    wave.amplitude *= 2.0;
    wave.phase += 1.0;
  }
  const SeaTables second(hydro, std::make_shared<const SeaState>(higher, kSphereGravity));
  EXPECT_EQ(second.following().front().get(), table);
  EXPECT_EQ(second.exact(0.4, 0.0).get(), course);
  EXPECT_NE(second.exact(0.5, 0.0).get(), course);
  higher.front().heading += 0.1;
  const SeaTables other(hydro, std::make_shared<const SeaState>(higher, kSphereGravity));
  EXPECT_NE(other.following().front().get(), table);
}

// Drawing.

// 144 frames a second of a ship that makes 6 m/s, at 64 ticks: each frame moves on by 1/144 of it.
TEST(ShipGuard, TheHullIsDrawnWhereItIsBetweenTicks) {
  Scene scene({.start = {.speed = 6}}, {}, slenderShip());
  scene.run(10);
  double before = static_cast<double>(scene.sphere->hullTransform().getOrigin().x());
  for (int i = 0; i < 300; ++i) {
    scene.world.world.stepSimulation(btScalar(1) / 144, 4, kTick);
    const auto now = static_cast<double>(scene.sphere->hullTransform().getOrigin().x());
    if (i > 0) {
      EXPECT_NEAR(now - before, 6.0 / 144, 1e-3) << i;
    }
    before = now;
  }
  scene.sphere->placeAt(300, 0, 0);
  EXPECT_NEAR(static_cast<double>(scene.sphere->hullTransform().getOrigin().x()), 300.0, 1e-3);
}

}  // namespace
}  // namespace cutwater::test
