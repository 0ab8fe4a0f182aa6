// Calm water that rises and falls: the same motion in it as without, and a dock that is drained.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/geometry/shapes/Shapes.h"
#include "tests/plugin/Shore.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/BareHull.h"
#include "tests/support/Refusal.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr const char* kTopic = "23 Loading and flooding";
constexpr BoxShape kBarge{12.0, 4.0, 0.8, 1.2};  // [m]
constexpr btScalar kStep = btScalar(1) / 60;

std::shared_ptr<const Hydrodynamics> barge(double damping = 0.0) {
  Coefficients c = bareCoefficients({.closed = closedBox(kBarge, 12, 2, 2),
                                     .cog = Vec3(0.0, 0.0, 0.2),
                                     .gyradii = Vec3(1.4, 3.4, 3.4)});
  c.ship.supplementary.damping = damping * Vec6(c.ship.massMatrix().diagonal());
  return std::make_shared<const Hydrodynamics>(std::move(c));
}
std::shared_ptr<const Hydrodynamics> plain() {
  static const auto ship = barge();
  return ship;
}

ShipSettings swinging(Mean mean) {
  ShipSettings settings;
  settings.model.mean = mean;
  settings.start.speed = mean == Mean::Fixed ? 2.0 : 0.0;
  settings.start.offset << 0.0, 0.0, 0.1, 0.1, 0.05, 0.0;
  return settings;
}

SeaState someWaves() {
  return SeaState({{.omega = 1.2, .amplitude = 0.2, .heading = 2.0}}, 9.81, 2.0);
}

// In water that rises at a constant rate everything is as in water that stands: E is another frame
// that does not accelerate. Whole ticks of 1/64 s and a rate of 1/32 m/s: rounding alone.
TEST(CalmLevelIdentity, MotionInWaterThatRisesIsThatInWaterThatStands) {
  for (const Mean mean : {Mean::Free, Mean::Fixed}) {
    TestWorld a(9.81), b(9.81);
    Seaway still(a.world, someWaves()), rising(b.world, someWaves());
    Ship& one = still.addShip(plain(), swinging(mean));
    Ship& other = rising.addShip(plain(), swinging(mean));
    rising.setCalmLevel(5.0, 1.0 / 32.0);
    b.world.stepSimulation(kTick, 1, kTick);  // it rises now
    other.reset(swinging(mean).start);
    a.world.stepSimulation(kTick, 1, kTick);
    one.reset(swinging(mean).start);
    double worst = 0.0, high = 0.0;
    for (int i = 0; i < 20 * 64; ++i) {
      a.world.stepSimulation(kTick, 1, kTick);
      b.world.stepSimulation(kTick, 1, kTick);
      worst = std::max(worst, (one.position() - other.position()).norm());
      worst = std::max(worst, (one.attitude() - other.attitude()).norm());
      worst = std::max(worst, (one.velocity() - other.velocity()).norm());
      high = std::max(high, one.position().z());
    }
    EXPECT_NEAR(rising.calmLevel(), (20.0 + 1.0 / 64.0) / 32.0, 1e-12);
    EXPECT_NEAR(static_cast<double>(other.body().getWorldTransform().getOrigin().z()),
                other.position().z() + rising.calmLevel(), 1e-6);
    // 20 s of motion; surge, sway and yaw of a ship that nothing holds make a rounding grow.
    const double bound = kDouble ? 1e-10 : 5e-3;
    EXPECT_LT(worst, bound);
    recordResult(kTopic, withPrecision("motion in rising water less that in still water [m]"), "0",
                 worst, "rounding");
    EXPECT_EQ(still.faults(), rising.faults());
  }
}

// A ship at rest follows a lock of 3 m in 100 s by its own buoyancy: nothing jumps, and it lies as
// deep afterwards. Drag of its own motion against the water alone: 1 cm at most.
TEST(CalmLevel, AShipAtRestFollowsALock) {
  static const auto ship = barge(1.0);
  Shore shore(ship, {});
  const double rest = shore.ship.position().z();
  shore.seaway.setCalmLevel(3.0, 0.03);
  double most = 0.0, before = 0.0;
  while (shore.seaway.time() < 160.0) {
    shore.tick(kStep);
    const double speed = static_cast<double>(shore.ship.body().getLinearVelocity().z());
    EXPECT_LT(std::abs(speed - before), 0.03 * 9.81 * static_cast<double>(kStep));
    before = speed;
    most = std::max(most, std::abs(shore.ship.position().z() - rest));
  }
  EXPECT_LT(most, 0.02);
  EXPECT_EQ(shore.seaway.calmLevel(), 3.0);
  EXPECT_NEAR(shore.ship.position().z(), rest, 1e-4);
  EXPECT_NEAR(static_cast<double>(shore.ship.body().getWorldTransform().getOrigin().z()),
              rest + 3.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(shore.seaway.waterAt(btVector3(4, 5, 6)).z()), 3.0, 1e-6);
  EXPECT_EQ(shore.seaway.faults(), kStepOk);
}

// A dock that is drained: the ship takes the ground, and all of its weight.
TEST(CalmLevelClosedForm, ADrainedDockCarriesTheWholeWeight) {
  static const auto ship = barge(1.0);
  btStaticPlaneShape floor(btVector3(0, 0, 1), btScalar(-2));
  Shore shore(ship, {}, &floor);
  shore.seaway.setCalmLevel(-2.5, 0.05);
  shore.run(90.0, kStep);
  const Shore::Balance mean = shore.balance(5.0, kStep);
  EXPECT_EQ(shore.ship.wetted()->volume, 0.0);
  EXPECT_NEAR(mean.carried / shore.weight(), 1.0, 1e-4);
  recordResult(kTopic, withPrecision("drained dock: weight carried, off, of m g"), "m g",
               mean.carried / shore.weight() - 1.0, "1e-4");
  EXPECT_EQ(shore.seaway.faults() & ~kWarningBits, 0u);
  // And afloat again.
  shore.seaway.setCalmLevel(0.0, 0.05);
  shore.run(120.0, kStep);
  EXPECT_NEAR(shore.ship.wetted()->volume, kBarge.length * kBarge.breadth * kBarge.draft, 0.02);
}

// Rewound while it rises, the same bits again; in a world with y up and feet.
TEST(CalmLevelIdentity, ASnapshotHoldsTheLevel) {
  TestWorld world(0.0);
  world.world.setGravity(btVector3(0, btScalar(-9.81 / 0.3048), 0));
  Seaway seaway(world.world, someWaves(),
                {.up = WorldFrame::Up::Y, .metresPerUnit = 0.3048, .seaLevel = 7.0});
  Ship& ship = seaway.addShip(plain(), swinging(Mean::Free));
  seaway.setCalmLevel(1.0, 0.05);
  const auto run = [&] {
    for (int i = 0; i < 300; ++i) world.world.stepSimulation(kTick, 1, kTick);
    return ship.body().getWorldTransform();
  };
  run();
  const Seaway::Snapshot snapshot = seaway.save();
  const btTransform first = run();
  const double level = seaway.calmLevel();
  seaway.restore(snapshot);
  const btTransform second = run();
  EXPECT_EQ(seaway.calmLevel(), level);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(first.getOrigin()[i], second.getOrigin()[i]);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(first.getBasis()[i][k], second.getBasis()[i][k]);
  }
}

TEST(CalmLevelRefusals, NameTheValue) {
  TestWorld world(9.81);
  Seaway seaway(world.world);
  expectRefusal(Fault::ValueOutOfRange, {"setCalmLevel", "height = nan"},
                [&] { seaway.setCalmLevel(std::nan(""), 1.0); });
  expectRefusal(Fault::ValueOutOfRange, {"setCalmLevel", "rate = -1"},
                [&] { seaway.setCalmLevel(1.0, -1.0); });
  seaway.setCalmLevel(2.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(seaway.calmLevel(), 2.0);
}

}  // namespace
}  // namespace cutwater::test
