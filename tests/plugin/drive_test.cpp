// A free ship with an engine and a rudder, through Bullet. Closed forms of the parts are in
// tests/forces/engine_test.cpp and rudder_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/plugin/TestScene.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

constexpr double kDegree = kPi / 180.0;

ShipSettings driven(double speed = 0.0) {
  ShipSettings settings;
  settings.start.speed = speed;
  settings.model.engine.emplace();
  settings.model.rudder.emplace();
  return settings;
}

/// The slender ship in a world of its own.
struct Sailing {
  explicit Sailing(const ShipSettings& settings, SeaState sea = {},
                   const Coefficients& coefficients = slenderShip())
      : seaway(world.world, std::move(sea)), ship(&seaway.addShip(coefficients, settings)) {}
  void run(double seconds) {
    const int ticks = static_cast<int>(std::lround(64.0 * seconds));
    for (int i = 0; i < ticks; ++i) world.world.stepSimulation(kTick, 1, kTick);
  }
  bool has(std::string_view part) const { return hasPart(*ship, part); }
  TestWorld world{kSphereGravity};
  Seaway seaway;
  Ship* ship;
};

TEST(Drive, AShipIsSailedWithoutANumber) {
  Sailing scene(driven());
  scene.ship->setThrottle(1.0);
  scene.run(120.0);
  EXPECT_GT(scene.ship->velocity()[Surge], 3.0);
  EXPECT_NEAR(scene.ship->attitude()[2], 0.0, 1e-6);
  scene.ship->setRudder(20.0 * kDegree);
  scene.run(60.0);
  EXPECT_GT(scene.ship->attitude()[2], 10.0 * kDegree);  // to port
  scene.ship->setRudder(0.0);
  scene.ship->setThrottle(-1.0);
  scene.run(300.0);
  EXPECT_LT(scene.ship->velocity()[Surge], 0.0);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

TEST(Drive, OnlyShipsThatWereGivenThemHaveThem) {
  Sailing without({});
  EXPECT_FALSE(without.has("engine"));
  EXPECT_FALSE(without.has("rudder"));
  Coefficients database = slenderShip();
  database.ship.rudder.emplace();
  Sailing with({}, {}, database);
  EXPECT_FALSE(with.has("engine"));
  EXPECT_TRUE(with.has("rudder"));
  with.ship->setRudder(0.1);
  expectRefusal(Fault::BadArgument, {"Ship::setThrottle", "no engine", "[engine]"},
                [&] { with.ship->setThrottle(0.5); });
  expectRefusal(Fault::BadArgument, {"Ship::setRudder", "no rudder", "[rudder]"},
                [&] { without.ship->setRudder(0.5); });
}

TEST(Drive, OrdersAreRefusedByName) {
  Sailing scene(driven());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  expectRefusal(Fault::ValueOutOfRange, {"Ship::setThrottle: nan"},
                [&] { scene.ship->setThrottle(nan); });
  expectRefusal(Fault::ValueOutOfRange, {"Ship::setRudder: -inf"},
                [&] { scene.ship->setRudder(-inf); });
  ShipSettings fixed;
  fixed.model.mean = Mean::Fixed;
  Coefficients database = slenderShip();
  database.ship.engine.emplace();
  database.ship.rudder.emplace();
  Sailing tank(fixed, {}, database);
  EXPECT_FALSE(tank.has("engine"));
  expectRefusal(Fault::BadArgument, {"Ship::setThrottle", "fixed course", "Mean::Free"},
                [&] { tank.ship->setThrottle(0.5); });
  expectRefusal(Fault::BadArgument, {"Ship::setRudder", "fixed course", "Mean::Free"},
                [&] { tank.ship->setRudder(0.5); });
  fixed.model.rudder.emplace();
  expectRefusal(Fault::BadArgument, {"model.rudder", "fixed course"},
                [&] { tank.seaway.addShip(database, fixed); });
  ShipSettings bad = driven();
  bad.model.engine->astern = 3.0;
  expectRefusal(Fault::ValueOutOfRange, {"addShip", "[engine] astern = 3"},
                [&] { tank.seaway.addShip(database, bad); });
}

TEST(Drive, AutopilotsSteerByEngineAndRudder) {
  ShipSettings settings = driven(4.0);
  settings.model.keepSpeed = SpeedKeeper{.speed = 6.0};
  settings.model.keepCourse = CourseKeeper{.heading = 60.0 * kDegree};
  Sailing scene(settings);
  scene.run(600.0);
  EXPECT_NEAR(scene.ship->velocity()[Surge], 6.0,
              0.03);  // the rudder's drag, which is not foreseen
  EXPECT_NEAR(scene.ship->attitude()[2], 60.0 * kDegree, 0.5 * kDegree);
  EXPECT_TRUE(scene.ship->load("autopilots").isZero(0.0));
  EXPECT_GT(scene.ship->load("engine")[Surge], 0.0);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

// A hand on the throttle ends keeping the speed, one on the helm keeping the course.
TEST(Drive, AnOrderEndsTheAutopilots) {
  ShipSettings settings = driven(6.0);
  settings.model.keepSpeed = SpeedKeeper{.speed = 6.0};
  settings.model.keepCourse = CourseKeeper{};
  Sailing scene(settings);
  scene.run(10.0);
  scene.ship->setThrottle(0.0);
  scene.run(120.0);
  EXPECT_NEAR(scene.ship->load("engine")[Surge], 0.0,
              1e-3 * std::abs(scene.ship->load("resistance")[Surge]));
  EXPECT_NEAR(scene.ship->attitude()[2], 0.0, 0.1 * kDegree);
  scene.ship->setRudder(35.0 * kDegree);
  scene.run(120.0);
  EXPECT_GT(scene.ship->attitude()[2], 10.0 * kDegree);
}

// Rudder hard over, then back, the engine stopped: it only takes energy.
TEST(DriveIdentity, ARudderGivesNoEnergy) {
  Sailing scene(driven(4.0));
  scene.ship->setRudder(35.0 * kDegree);
  const double first = scene.ship->energy();
  double before = first, risen = 0.0;
  for (int i = 0; i < 400; ++i) {
    if (i == 200) scene.ship->setRudder(-35.0 * kDegree);
    scene.run(1.0);
    risen = std::max(risen, scene.ship->energy() - before);
    before = scene.ship->energy();
  }
  // energy() lacks what the memory of the radiated waves holds, which swings.
  EXPECT_LT(risen, 1e-3 * first);
  EXPECT_LT(scene.ship->energy(), 0.5 * first);
}

// An engine that is switched off pushes no water over the rudder either.
TEST(Drive, WithoutItsEngineTheRudderHasNoJet) {
  Sailing scene(driven());
  scene.ship->setThrottle(1.0);
  scene.ship->setRudder(0.3);
  scene.run(20.0);
  EXPECT_GT(std::abs(scene.ship->load("rudder")[Sway]), 1e3);
  scene.ship->setEnabled("engine", false);
  scene.ship->resetVelocity(Vec3::Zero(), Vec3::Zero());
  scene.run(kTick);
  EXPECT_LT(std::abs(scene.ship->load("rudder")[Sway]), 1.0);
}

TEST(DriveIdentity, SnapshotsHoldOrdersAndWhatFollowsThem) {
  ShipSettings settings = driven(5.0);
  settings.model.keepCourse = CourseKeeper{.heading = 1.0};
  Sailing scene(settings, waves());
  scene.ship->setThrottle(0.8);
  scene.run(8.0);
  Seaway::Snapshot snapshot = scene.seaway.save();
  scene.run(8.0);
  const Vec3 place = scene.ship->position();
  const Vec6 rudder = scene.ship->load("rudder");
  scene.ship->setThrottle(-1.0);
  scene.run(3.0);
  scene.seaway.restore(snapshot);
  scene.run(8.0);
  EXPECT_EQ(scene.ship->position(), place);
  EXPECT_EQ(scene.ship->load("rudder"), rudder);
}

// Orders stay, the engine and the rudder begin anew.
TEST(DriveIdentity, AResetShipIsANewOne) {
  Sailing used(driven(5.0)), fresh(driven(5.0));
  const auto order = [](Sailing& scene) {
    scene.ship->setThrottle(0.8);
    scene.ship->setRudder(0.4);
  };
  order(used);
  order(fresh);
  used.run(30.0);
  used.ship->reset(driven(5.0).start);
  used.run(10.0);
  fresh.run(10.0);
  EXPECT_TRUE(sameBits(used.ship->body(), fresh.ship->body()));
}

}  // namespace
}  // namespace cutwater::test
