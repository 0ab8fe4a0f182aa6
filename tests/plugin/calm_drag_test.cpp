// What slows a free ship in calm water, through Bullet. Closed forms of the part itself are in
// tests/forces/resistance_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

/// The slender ship, free, in a world of its own.
struct FreeShip {
  explicit FreeShip(double speed = 0.0, bool resistance = true)
      : seaway(world.world), ship(&seaway.addShip(slenderShip(), settings(speed, resistance))) {}
  static ShipSettings settings(double speed, bool resistance) {
    ShipSettings settings;
    settings.start.speed = speed;
    settings.start.heading = 0.7;
    settings.model.resistance = resistance;
    return settings;
  }
  template <class Each>
  void run(double seconds, Each each) {
    const int ticks = static_cast<int>(std::lround(64.0 * seconds));
    for (int i = 0; i < ticks; ++i) {
      each();
      world.world.stepSimulation(kTick, 1, kTick);
    }
  }
  bool has(std::string_view part) const { return hasPart(*ship, part); }
  TestWorld world{kSphereGravity};
  Seaway seaway;
  Ship* ship;
};

// Without a mesh of its wet surface its side is L × V/(L B) (hydro/ship/ShipParticulars.h).
double lateralArea(const ShipParticulars& ship) { return ship.volume / ship.beam(); }

TEST(CalmDragClosedForm, APushFromAbeamEndsAtTheCrossFlowBalance) {
  FreeShip scene;
  const double force = 3e5;
  const ShipParticulars& particulars = scene.ship->coefficients().ship;
  const double balance = std::sqrt(2.0 * force / (particulars.density * lateralArea(particulars)));
  scene.run(900.0, [&] {
    const Mat3 axes = fromBullet(scene.ship->body().getWorldTransform().getBasis());
    scene.ship->body().applyCentralForce(toBullet(Vec3(force * axes.col(1))));
  });
  const double speed = std::hypot(scene.ship->velocity()[Surge], scene.ship->velocity()[Sway]);
  recordResult("free ship", withPrecision("slender ship pushed abeam by 300 kN: speed [m/s]"),
               "sqrt(2F/(rho C_D L T)) = " + std::to_string(balance), speed, "0.5 %");
  // A few degrees of heel take their cosine of the push, and yaw is not quite still.
  EXPECT_NEAR(speed, balance, 5e-3 * balance);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

// I dr/dt = −k r²: what is left after t is at most I/(k t), whatever it began with; 1.1 for the
// sway that its uneven added mass gives it.
TEST(CalmDragClosedForm, ASpunShipComesToRest) {
  FreeShip scene;
  scene.ship->resetVelocity(Vec3::Zero(), Vec3(0.0, 0.0, 0.1));
  const ShipParticulars& particulars = scene.ship->coefficients().ship;
  const double length = particulars.length(), draught = particulars.draught();
  const double k = 0.5 * particulars.density * draught * std::pow(length, 4) / 32.0;
  const double inertia =
      particulars.massMatrix()(Yaw, Yaw) + scene.ship->coefficients().addedMass.atZero(Yaw, Yaw);
  scene.run(500.0, [] {});
  const double rate = std::abs(scene.ship->velocity()[Yaw]);
  EXPECT_LT(rate, 1.1 * inertia / (k * 500.0));
}

// A ship under way stops; with the part off it coasts for ever.
TEST(CalmDrag, AShipUnderWayStops) {
  FreeShip with(6.0), without(6.0, false);
  with.run(600.0, [] {});
  without.run(600.0, [] {});
  EXPECT_LT(with.ship->velocity()[Surge], 4.0);
  EXPECT_GT(with.ship->velocity()[Surge], 1.0);
  EXPECT_NEAR(without.ship->velocity()[Surge], 6.0, 1e-3);
  EXPECT_TRUE(with.has("resistance"));
  EXPECT_FALSE(without.has("resistance"));
}

TEST(CalmDragIdentity, PushedSpunAndLeftAloneItOnlyLosesEnergy) {
  FreeShip scene(4.0);
  scene.run(20.0, [&] { scene.ship->body().applyTorque(btVector3(0, 0, 2e6)); });
  double before = scene.ship->energy(), risen = 0.0;
  const double first = before;
  scene.run(400.0, [&] {
    risen = std::max(risen, scene.ship->energy() - before);
    before = scene.ship->energy();
  });
  // energy() is of the middle of the last tick and without what the memory holds, which swings.
  EXPECT_LT(risen, 1e-3 * first);
  EXPECT_LT(scene.ship->energy(), 0.7 * first);
}

TEST(CalmDrag, AFixedCourseHasNone) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  ShipSettings settings;
  settings.model.mean = Mean::Fixed;
  const Ship& ship = seaway.addShip(slenderShip(), settings);
  for (const std::string_view part : ship.parts()) EXPECT_NE(part, "resistance");
}

}  // namespace
}  // namespace cutwater::test
