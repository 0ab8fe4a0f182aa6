// Ships in nonlinear mode that stand, hang, run aground and are too heavy: what holds them up
// carries the weight that the water does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/geometry/shapes/Shapes.h"
#include "tests/plugin/Shore.h"
#include "tests/support/BareHull.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr const char* kTopic = "16 Survival";  // of the results page
constexpr std::array<btScalar, 2> kSteps{btScalar(1) / 60, btScalar(1) / 240};
constexpr BoxShape kBarge{12.0, 4.0, 0.8, 1.2};  // [m]

std::shared_ptr<const Hydrodynamics> barge() {
  static const auto ship = bareShip({.closed = closedBox(kBarge, 12, 2, 2),
                                     .cog = Vec3(0.0, 0.0, 0.2),
                                     .gyradii = Vec3(1.4, 3.4, 3.4)});
  return ship;
}

ShipSettings withKeelAt(double height) {
  ShipSettings settings;
  settings.start.offset[Heave] = height + kBarge.draft;
  return settings;
}

double volumeOf(double draught) { return kBarge.length * kBarge.breadth * draught; }

std::string named(const char* what) { return withPrecision(std::string("barge of 39 t ") + what); }

// Acceptance is 1 %. Here the barge comes to rest, and the sum of contacts and pressure is the
// weight to what a float makes of it, 1e-5. Where the trailer stands deeper the water carries the
// rest.
TEST(AshoreClosedForm, ATrailerCarriesWhatTheWaterDoesNot) {
  btBoxShape trailer(btVector3(4, 1, btScalar(0.5)));
  double worst = 0.0;
  for (const btScalar step : kSteps) {
    for (const double top : {3.0, -0.4}) {
      const btVector3 at(0, 0, static_cast<btScalar>(top - 0.5));
      Shore shore(barge(), withKeelAt(top + 0.05), &trailer,
                  btTransform(btQuaternion::getIdentity(), at));
      shore.run(60.0, step, 2);
      const Shore::Balance mean = shore.balance(5.0, step);
      worst = std::max(worst, std::abs(mean.carried - mean.lacking) / shore.weight());
      // Bullet keeps the margin of the barge's shape between the two, a hundredth of its half beam.
      const double deep = top < 0.0 ? -top - 0.02 : 0.0;
      EXPECT_NEAR(shore.ship.wetted()->volume, volumeOf(deep), volumeOf(0.005));
      EXPECT_EQ(shore.seaway.faults(), deep > 0.0 ? kStepOk : kOutOfWater);
    }
  }
  recordResult(kTopic, named("on a trailer: weight carried, off, of m g"), "m g - rho g V", worst,
               "1e-4");
  EXPECT_LT(worst, 1e-4);
}

TEST(AshoreClosedForm, AHookCarriesWhatTheWaterDoesNot) {
  double worst = 0.0;
  for (const btScalar step : kSteps) {
    for (const double keel : {3.0, -0.4}) {
      Shore shore(barge(), withKeelAt(keel));
      shore.hangFrom(3.0);
      shore.run(60.0, step, 2);
      const double carried = shore.balance(5.0, step).carried;
      const double expected =
          shore.weight() * (1.0 - volumeOf(std::max(0.0, -keel)) / volumeOf(kBarge.draft));
      worst = std::max(worst, std::abs(carried - expected) / shore.weight());
    }
  }
  recordResult(kTopic, named("on a hook: weight carried, off, of m g"), "m g - rho g V", worst,
               "1e-4");
  EXPECT_LT(worst, 1e-4);
}

// A beach that rises 1 in 8, its waterline at x = 20 m, as a box or as two triangles.
struct Beach {
  Beach() {
    const auto corner = [](btScalar x, btScalar y) { return btVector3(x, y, 5); };
    mesh.addTriangle(corner(-40, -20), corner(40, -20), corner(40, 20));
    mesh.addTriangle(corner(-40, -20), corner(40, 20), corner(-40, 20));
    triangles = std::make_unique<btBvhTriangleMeshShape>(&mesh, true);
    const btQuaternion tilt(btVector3(0, 1, 0), static_cast<btScalar>(-slope));
    place = btTransform(tilt, btVector3(20, 0, 0) - quatRotate(tilt, corner(0, 0)));
  }
  double slope = std::atan(1.0 / 8.0);
  btBoxShape box{btVector3(40, 20, 5)};
  btTriangleMesh mesh;
  std::unique_ptr<btBvhTriangleMeshShape> triangles;
  btTransform place;
};

constexpr double kFriction = 0.4;

// Runs onto the beach at 3 m/s and lies there.
void runAground(Shore& shore, btScalar step) {
  shore.ship.body().setFriction(btScalar(kFriction));
  double fastest = 0.0, gained = 0.0, first = 0.0;
  for (int i = 0; static_cast<double>(step) * i < 120.0; ++i) {
    shore.tick(step);
    if (i == 0) first = shore.ship.energy();
    fastest = std::max(fastest, shore.ship.velocity().head<3>().norm());
    gained = std::max(gained, shore.ship.energy() - first);
  }
  EXPECT_LT(fastest, 3.0 + 1e-3);  // nothing throws it; it heaves a little as it begins
  EXPECT_LT(gained, 1e-4 * shore.weight() * kBarge.breadth);
  EXPECT_GT(shore.lacks(), 0.1 * shore.weight());
}

// On the slope α with friction tan φ a level pull at G moves a ship at W tan(φ − α), W what of its
// weight the beach carries: no glue. Bullet's friction is a box along two directions, the pull is
// along one of them but for the yaw of some degrees that the ship lies at: 10 % to either side.
double movedByPull(Shore& shore, const Beach& beach, double share, btScalar step) {
  const double from = shore.ship.position().x();
  for (int i = 0; static_cast<double>(step) * i < 20.0; ++i) {
    const double pull = share * shore.lacks() * std::tan(std::atan(kFriction) - beach.slope);
    shore.ship.body().applyCentralForce(btVector3(static_cast<btScalar>(-pull), 0, 0));
    shore.tick(step);
  }
  return from - shore.ship.position().x();
}

TEST(AshoreClosedForm, ABeachHoldsAShipByFrictionAlone) {
  Beach beach;
  double worst = 0.0;
  for (btCollisionShape* const shape : {static_cast<btCollisionShape*>(&beach.box),
                                        static_cast<btCollisionShape*>(beach.triangles.get())}) {
    for (const btScalar step : kSteps) {
      if (!fullSize() && step != kSteps.front()) continue;
      Shore shore(barge(), {.start = {.speed = 3.0}}, shape, beach.place);
      runAground(shore, step);
      const Shore::Balance mean = shore.balance(20.0, step);  // it rocks a little for long
      worst = std::max(worst, std::abs(mean.carried / mean.lacking - 1.0));
      EXPECT_LT(movedByPull(shore, beach, 0.9, step), 0.05);
      EXPECT_GT(movedByPull(shore, beach, 1.1, step), 0.5);
      shore.run(20.0, step);
      while (shore.touching().norm() > 0.0 && shore.seaway.time() < 300.0)
        movedByPull(shore, beach, 1.1, step);
      EXPECT_EQ(shore.touching().norm(), 0.0);
      shore.run(120.0, step);
      EXPECT_NEAR(shore.ship.wetted()->volume, volumeOf(kBarge.draft), 0.02 * volumeOf(0.8));
      EXPECT_EQ(shore.seaway.faults(), kStepOk);
    }
  }
  recordResult(kTopic, named("on a beach: weight carried, off, of it"), "m g - rho g V", worst,
               "1e-4");
  EXPECT_LT(worst, 1e-4);  // it rocks; single precision has its momentum to 1e-5 of weight x 1 s
}

void makeHeavier(Shore& shore, double times) {
  btRigidBody& body = shore.ship.body();
  const Vec3 inertia = times * fromBullet(body.getInvInertiaDiagLocal()).cwiseInverse();
  body.setMassProps(static_cast<btScalar>(times * shore.particulars.mass), toBullet(inertia));
}

// Twice the mass, at twice the draught. The bare hull's waves damp its slow bobbing by a few
// percent a cycle: the mean of two minutes, after two. 1 cm: half a cycle that is left over of it.
TEST(AshoreClosedForm, TwiceTheMassIsTwiceTheDraught) {
  Shore shore(barge(), {});
  makeHeavier(shore, 2.0);
  constexpr btScalar kStep = btScalar(1) / 60;
  shore.run(120.0, kStep);
  double height = 0.0;
  constexpr int kTicks = 7200;
  for (int i = 0; i < kTicks; ++i) {
    shore.tick(kStep);
    height += shore.ship.position().z() / kTicks;
  }
  const double sunk = shore.particulars.cog.z() - height;
  recordResult(kTopic, named("with its mass doubled: sunk [m]"), "0.8", sunk, "+- 0.01");
  EXPECT_NEAR(sunk, kBarge.draft, 0.01);
  EXPECT_EQ(shore.seaway.faults() & ~kOutOfWater, kMassChanged);
}

// Three times the mass is more than the whole hull's water. It goes under, for good, at the speed
// at which drag carries what the water does not (Resistance.h). 1 %: it is not level all the way.
TEST(AshoreClosedForm, WhatTheHullCannotCarrySinks) {
  Shore shore(barge(), {});
  makeHeavier(shore, 3.0);
  constexpr btScalar kStep = btScalar(1) / 60;
  shore.run(30.0, kStep);
  const double before = shore.ship.position().z();
  shore.run(10.0, kStep);
  const double speed = (before - shore.ship.position().z()) / 10.0;
  const ShipParticulars& ship = shore.particulars;
  const double water = ship.density * volumeOf(kBarge.draft + kBarge.freeboard);
  const double force = (3.0 * ship.mass - water) * ship.gravity;
  const double drag = 0.5 * ship.density * ship.drag.crossFlow * kBarge.length * kBarge.breadth;
  char expected[60];
  std::snprintf(expected, sizeof expected, "drag: %.3f", std::sqrt(force / drag));
  recordResult(kTopic, named("with three times its mass: sinks at [m/s]"), expected, speed,
               "+- 1 %");
  EXPECT_NEAR(speed / std::sqrt(force / drag), 1.0, 0.01);
  EXPECT_EQ(shore.seaway.faults(), kMassChanged | kOutOfWater | kFoundered);
}

}  // namespace
}  // namespace cutwater::test
