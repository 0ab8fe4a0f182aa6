// Ships under way: on a fixed course, and free on one that follows them.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

// The slender ship in a world of its own.
struct Afloat {
  explicit Afloat(const ShipSettings& settings, SeaState sea = {})
      : seaway(world.world, std::move(sea)), ship(&seaway.addShip(coefficients, settings)) {}
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) world.world.stepSimulation(kTick, 1, kTick);
  }
  TestWorld world{kSphereGravity};
  Coefficients coefficients = slenderShip();
  Seaway seaway;
  Ship* ship;
};

ShipSettings underWay(double speed, Mean mean) {
  ShipSettings settings;
  settings.start.heading = 0.4;
  settings.start.speed = speed;
  settings.model.mean = mean;
  settings.model.resistance = false;  // in calm_drag_test.cpp
  return settings;
}

TEST(FreeShipIdentity, InCalmWaterItKeepsItsSpeedAndCourse) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Afloat scene(underWay(10.0, mean));
    scene.run(64 * 60);
    EXPECT_NEAR(scene.ship->velocity()[0], 10.0, 100 * kEpsilon);
    EXPECT_NEAR(scene.ship->attitude()[2], 0.4, 100 * kEpsilon);
    // In float 600 m are stored to 6e-5, and so is each tick's step.
    EXPECT_NEAR(scene.ship->position().head<2>().norm(), 600.0, kDouble ? 1e-9 : 0.2);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
  }
}

TEST(FreeShipIdentity, RestrainedOnAMovingCourseItStaysThere) {
  ShipSettings settings = underWay(8.0, Mean::Fixed);
  settings.model.restrained = {true, true, false, false, false, true};
  Afloat scene(settings);
  double away = 0.0;
  for (int i = 0; i < 640; ++i) {
    scene.ship->body().applyCentralForce(btVector3(2e5, -3e5, 0));
    scene.ship->body().applyTorque(btVector3(0, 0, 5e6));
    scene.run(1);
    const Vec6 eta = scene.ship->motion();
    away = std::max({away, std::abs(eta[Surge]), std::abs(eta[Sway]), std::abs(eta[Yaw])});
  }
  // Rows of Bullet's solver, ten sweeps against A(∞): 3e5 N h²/m = 2e-5 m a tick, a tenth of it
  // left.
  EXPECT_LT(away, kDouble ? 1e-4 : 2e-3);
}

// Trap of turning: a coasting hull that turns must not gain ½(A22 − A11)U². Pushed round by a
// moment, then left alone, it never has more than when it ended.
TEST(FreeShipIdentity, CoastingAndTurningItGainsNoEnergy) {
  Afloat scene(underWay(8.0, Mean::Free));
  for (int i = 0; i < 64 * 40; ++i) {
    scene.ship->body().applyTorque(btVector3(0, 0, 4e7));
    scene.run(1);
  }
  EXPECT_GT(std::abs(scene.ship->attitude()[2] - 0.4), 0.3);
  const double start = scene.ship->energy();
  double largest = 0.0, least = start, rise = 0.0;
  for (int i = 0; i < 64 * 600; ++i) {
    scene.run(1);
    const double now = scene.ship->energy();
    largest = std::max(largest, now);
    least = std::min(least, now);
    rise = std::max(rise, now - least);
  }
  EXPECT_LE(largest, start * (1.0 + 1e-4));  // 1e-4: the velocity is extrapolated to the tick
  // What the waves it made give back: ½v²(A(0) − A(∞)) of its leeway, and c(U)'s share of its yaw.
  EXPECT_LT(rise, 0.02 * start);
  EXPECT_GT(std::abs(scene.ship->velocity()[0]), 1.0);  // spun round, it ends going astern
  recordResult("Plugin", withPrecision("coasting, turning hull: largest energy over the first"),
               "1", largest / start, "1.0001");
}

// Without anything that damps leeway or yaw the ship is broadside in no time, but comes to a
// bounded motion.
TEST(FreeShip, WithoutHullLiftMunksMomentTurnsHer) {
  ShipSettings settings = underWay(8.0, Mean::Free);
  settings.start.velocity[Yaw] = 0.002;
  settings.model.hullLift = false;
  Afloat bare(settings);
  settings.model.hullLift = true;
  Afloat lifted(settings);
  bare.run(64 * 60);
  lifted.run(64 * 60);
  EXPECT_GT(std::abs(bare.ship->attitude()[2] - 0.4), 0.5);
  EXPECT_LT(std::abs(lifted.ship->attitude()[2] - 0.4), 0.05);
}

TEST(FreeShip, AutopilotsBringItToSpeedAndCourseWithinTheirLimits) {
  ShipSettings settings = underWay(0.0, Mean::Free);
  settings.model.keepSpeed = SpeedKeeper{.speed = 8.0};
  settings.model.keepCourse = CourseKeeper{.heading = 0.4};
  Afloat scene(settings);
  scene.run(64 * 400);
  EXPECT_NEAR(scene.ship->velocity()[0], 8.0, 0.05);
  EXPECT_NEAR(scene.ship->attitude()[2], 0.4, 1e-3);
  scene.ship->keepCourse({.heading = 0.4 + kPi / 2});
  double thrust = 0.0, moment = 0.0;
  for (int i = 0; i < 64 * 400; ++i) {
    scene.run(1);
    thrust = std::max(thrust, scene.ship->load("autopilots").head<2>().norm());
    moment = std::max(moment, std::abs(scene.ship->load("autopilots")[Yaw]));
  }
  EXPECT_NEAR(scene.ship->attitude()[2], 0.4 + kPi / 2, 0.01);
  EXPECT_NEAR(scene.ship->velocity()[0], 8.0, 0.1);
  EXPECT_NEAR(scene.ship->course().speed(), 8.0, 0.1);
  const double weight = 4.0e6 * kSphereGravity;
  EXPECT_LT(moment,
            0.02 * weight * 110.0 * 2.0);  // the helmsman's limit and the hull's own damping
}

// An hour of orders: no force jumps between two ticks by more than a trifle of the weight.
TEST(FreeShip, SpeedsUpTurnsAndStopsForAnHourWithoutAJump) {
  ShipSettings settings = underWay(5.0, Mean::Free);
  settings.model.keepSpeed = SpeedKeeper{.speed = 5.0};
  settings.model.keepCourse = CourseKeeper{.heading = 0.4};
  const SeaState sea({{.omega = 0.7, .amplitude = 0.5, .phase = 0.3, .heading = 2.0},
                      {.omega = 0.9, .amplitude = 0.4, .phase = 1.3, .heading = 2.6}},
                     kSphereGravity, 30.0);
  Afloat scene(settings, sea);
  const double weight = 4.0e6 * kSphereGravity;
  Vec3 before = Vec3::Zero(), change = before;
  double jump = 0.0;
  const int hour = kDouble ? 3600 : 600;
  for (int second = 0; second < hour; ++second) {
    if (second % 300 == 0) scene.ship->keepSpeed({.speed = 2.0 + 3.0 * (second / 300 % 3)});
    if (second % 200 == 100) scene.ship->keepCourse({.heading = 0.4 + 0.5 * (second / 200 % 5)});
    for (int i = 0; i < 64; ++i) {
      scene.run(1);
      const Ship& ship = *scene.ship;
      const Vec3 now =
          (ship.load("radiation") + ship.load("froude_krylov") + ship.load("diffraction"))
              .head<3>();
      if (second > 0) jump = std::max(jump, (now - before - change).norm() / weight);
      change = now - before;
      before = now;
    }
  }
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  // Second differences: waves of 0.3 of the weight met at 1.5 rad/s give 0.3 (1.5/64)² = 1.6e-4 of
  // it.
  EXPECT_LT(jump, 3e-4);
  EXPECT_LT(std::abs(scene.ship->position().z() - 1.0), 2.0);
  recordResult("Plugin", withPrecision("largest second difference of a force, over the weight"),
               "1.6e-4 of the waves", jump, "3e-4");
}

TEST(FreeShip, SnapshotsOfAFreeShipGiveTheSameBits) {
  ShipSettings settings = underWay(6.0, Mean::Free);
  settings.model.keepSpeed = SpeedKeeper{.speed = 7.0};
  settings.model.keepCourse = CourseKeeper{.heading = 1.4};
  Afloat scene(settings, waves()), twin(settings, waves());
  scene.run(500);
  Seaway::Snapshot saved;
  scene.seaway.save(saved);
  scene.run(300);
  twin.ship->prepare(static_cast<double>(kTick));
  twin.seaway.restore(saved);
  twin.run(300);
  EXPECT_TRUE(sameBits(scene.ship->body(), twin.ship->body()));
  EXPECT_EQ(scene.ship->course().speed(), twin.ship->course().speed());
  scene.seaway.restore(saved);
  scene.run(300);
  EXPECT_TRUE(sameBits(scene.ship->body(), twin.ship->body()));
}

// Rollback in the midst of a collision: Bullet's warm start is forgotten at both ends.
TEST(FreeShip, RollbackWhileTwoShipsTouchGivesTheSameBits) {
  Afloat scene(underWay(4.0, Mean::Free));
  ShipSettings other = underWay(-4.0, Mean::Free);
  other.start.x = 119.0 * std::cos(0.4);
  other.start.y = 119.0 * std::sin(0.4) + 2.0;
  Ship& second = scene.seaway.addShip(scene.coefficients, other);
  const auto touching = [&] {
    return scene.world.dispatcher.getNumManifolds() > 0 &&
           scene.world.dispatcher.getManifoldByIndexInternal(0)->getNumContacts() > 0;
  };
  for (int i = 0; i < 640 && !touching(); ++i) scene.run(1);
  ASSERT_TRUE(touching());
  scene.seaway.forgetContacts();
  const Seaway::Snapshot saved = scene.seaway.save();
  scene.run(200);
  const btTransform first = scene.ship->body().getWorldTransform();
  const btTransform then = second.body().getWorldTransform();
  scene.seaway.restore(saved);
  scene.seaway.forgetContacts();
  scene.run(200);
  EXPECT_TRUE(scene.ship->body().getWorldTransform() == first);
  EXPECT_TRUE(second.body().getWorldTransform() == then);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

TEST(FreeShip, BothMemoriesMoveItAlike) {
  ShipSettings settings = underWay(6.0, Mean::Free);
  settings.start.offset[Heave] = 1.0;
  settings.start.velocity[Yaw] = 0.01;
  Afloat fast(settings);
  settings.model.memory = MemoryModel::Convolution;
  Afloat oracle(settings);
  fast.run(64 * 30);
  oracle.run(64 * 30);
  const Vec3 apart = fast.ship->position() - oracle.ship->position();
  EXPECT_LT(apart.norm(), 0.05);  // of 180 m; 0.2 % of the radiation force's share
  EXPECT_LT((fast.ship->attitude() - oracle.ship->attitude()).norm(), 2e-3);
}

TEST(FreeShipClosedForm, PointsMoveAsPointsOfARigidBody) {
  ShipSettings settings = underWay(6.0, Mean::Fixed);
  settings.start.offset[Pitch] = 0.05;
  Afloat scene(settings);
  scene.run(100);
  const Vec3 bow(55, 0, 6);
  const PointMotion now = scene.ship->pointMotion(bow);
  scene.run(1);
  const PointMotion next = scene.ship->pointMotion(bow);
  const auto h = static_cast<double>(kTick);
  // Bullet's velocity after a tick moved the body over it, but for the chord of the arc: ½ω²rh.
  const double spin = scene.ship->velocity().tail<3>().norm();
  const double chord = 0.55 * spin * spin * 55 * h;
  EXPECT_LT(((next.position - now.position) / h - next.velocity).norm(),
            chord + 60 * kEpsilon / h * 4);
  EXPECT_LT(((next.velocity - now.velocity) / h - next.acceleration).norm(),
            0.02 + 8 * kEpsilon / h);
  EXPECT_NEAR(scene.ship->draught(scene.seaway.time(), 0.0), 5.0 - scene.ship->motion()[Heave],
              1e-2);
}

}  // namespace
}  // namespace cutwater::test
