// What Bullet programs do to a ship without asking it: locks, sleep, gravity, removal, moves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "plugin/AddedMassConstraint.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr btScalar kNan = std::numeric_limits<btScalar>::quiet_NaN();

// Ticks.

// The last good state is where the ship goes on from, and one bit says what was wrong.
TEST(ShipGuard, AVelocityOrForceThatIsNotANumberIsTakenBack) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}}), twin({.start = {.offset = one(Heave, 1.0)}});
  const auto both = [&](int ticks) {
    scene.run(ticks);
    twin.run(ticks);
  };
  both(40);
  bodyOf(scene).setLinearVelocity(btVector3(0, kNan, 0));
  both(1);
  EXPECT_EQ(scene.seaway.faults(), kStateNotFinite);
  scene.seaway.clearFaults();
  bodyOf(scene).applyCentralForce(btVector3(kNan, 0, 0));
  both(1);
  EXPECT_EQ(scene.seaway.faults(), kLoadNotFinite);
  scene.seaway.clearFaults();
  btTransform nowhere = bodyOf(scene).getWorldTransform();
  nowhere.setOrigin(btVector3(0, 0, kNan));
  bodyOf(scene).setWorldTransform(nowhere);
  both(50);
  EXPECT_EQ(scene.seaway.faults(), kStateNotFinite);
  EXPECT_TRUE(sameBits(bodyOf(scene), bodyOf(twin)));
  EXPECT_TRUE(scene.sphere->pointMotion(Vec3::Zero()).acceleration.allFinite());
}

// A part that pushes with what is no number at the end of the tick, behind our back.
struct NanAction final : btActionInterface {
  explicit NanAction(btRigidBody& body) : target(body) {}
  void updateAction(btCollisionWorld*, btScalar) override {
    target.setAngularVelocity(btVector3(kNan, 0, 0));
  }
  void debugDraw(btIDebugDraw*) override {}
  btRigidBody& target;
};

TEST(ShipGuard, AnActionThatBreaksTheBodyEachTickDoesNotStopIt) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}}), twin({.start = {.offset = one(Heave, 1.0)}});
  NanAction action(bodyOf(scene));
  scene.world.world.addAction(&action);
  scene.run(64);
  twin.run(64);
  scene.world.world.removeAction(&action);
  EXPECT_EQ(scene.seaway.faults(), kStateNotFinite);
  EXPECT_NEAR(heaveOf(scene), heaveOf(twin), kStill);
}

// One second at once, 1.4 of the half sphere's own time 1/ω: said, bounded, and it settles.
TEST(ShipGuard, AHitchIsSaidAndTheShipGoesOnWhereItWas) {
  Scene scene({.start = {.offset = one(Heave, 0.3)}});
  scene.run(30);
  scene.world.world.stepSimulation(1, 0);
  EXPECT_EQ(scene.seaway.faults(), kTickTooLong);
  scene.seaway.clearFaults();
  EXPECT_LT(std::abs(heaveOf(scene)), 1.0);
  scene.run(64 * 30);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  EXPECT_LT(std::abs(heaveOf(scene)), 0.02);
  EXPECT_LT(std::abs(scene.sphere->motion()[Surge]), kStill);
}

// Locks.

TEST(ShipGuard, AHeaveThatIsLockedStays) {
  Scene scene({.start = {.heading = 0.4}}, waves(), slenderShip());
  bodyOf(scene).setLinearFactor(btVector3(1, 1, 0));
  scene.run(64 * 30);
  EXPECT_EQ(heaveOf(scene), 0.0);
  EXPECT_GT(std::abs(scene.sphere->motion()[Sway]), 1e-3);  // the others go on
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

/// The slender ship with sway, roll and yaw coupled by the water's inertia.
Coefficients coupledShip() {
  Coefficients ship = slenderShip();
  Mat6& added = ship.addedMass.atInfinity;
  added(Sway, Roll) = added(Roll, Sway) = 4e6;
  added(Roll, Yaw) = added(Yaw, Roll) = 5e7;
  return ship;
}

// A yaw that is locked is a yaw restrained: the roll of both is the same but for the solver's error
// in the restraint, a hundredth of it. A ship that did not heed the lock turned over.
TEST(ShipGuard, AYawThatIsLockedIsAYawRestrained) {
  std::array<bool, 6> held{};
  held[Yaw] = true;
  const ShipStart start{.offset = one(Roll, 0.2)};
  Scene locked({.start = start}, waves(), coupledShip());
  Scene tied({.start = start, .model = {.restrained = held}}, waves(), coupledShip());
  Scene loose({.start = start}, waves(), coupledShip());
  bodyOf(locked).setAngularFactor(btVector3(1, 1, 0));
  double differs = 0.0, turned = 0.0;
  for (int i = 0; i < 64 * 60; ++i) {
    for (Scene* scene : {&locked, &tied, &loose}) scene->run(1);
    const double roll = tied.sphere->attitude()[0];
    differs = std::max(differs, std::abs(locked.sphere->attitude()[0] - roll));
    turned = std::max(turned, std::abs(loose.sphere->attitude()[2]));
  }
  EXPECT_GT(turned, 1e-3);
  EXPECT_LT(differs, 0.002);
  EXPECT_NEAR(locked.sphere->attitude()[2], 0.0, 1e-5);  // roll and pitch make a turn of 2nd order
}

// Bullet's damping changes the rate that a locked heading was given; it is no order of the user's.
TEST(ShipGuard, ALockedYawIsHeldUnderDamping) {
  Scene scene({.start = {.offset = one(Roll, 0.2)}}, waves(), coupledShip());
  bodyOf(scene).setAngularFactor(btVector3(1, 1, 0));
  bodyOf(scene).setDamping(0, btScalar(0.3));
  scene.run(64 * 60);
  EXPECT_NEAR(scene.sphere->attitude()[2], 0.0, 1e-5);
}

// A lock is P(M + A)P: one blow on the locked body gives (M + A)_ff⁻¹ P. Coupled added mass.
TEST(AddedMassClosedForm, ALockedBodyMovesWithWhatIsLeftOfMassAndAddedMass) {
  TestWorld world;
  btSphereShape shape(1);
  btRigidBody body(
      btRigidBody::btRigidBodyConstructionInfo(2, nullptr, &shape, btVector3(3, 5, 4)));
  world.world.addRigidBody(&body);
  Mat6 mass = Mat6::Zero();
  mass.diagonal() << 2, 2, 2, 3, 5, 4;
  std::mt19937 random(7);
  Vec6 ratios;
  ratios << 1.5, 1.2, 0.9, 0.6, 0.4, 0.2;
  const Mat6 added = randomAddedMass(mass, ratios, random);
  body.setFlags(0);  // without Bullet's gyroscopic term
  AddedMassConstraint constraint(body, added);
  world.world.addConstraint(&constraint);
  const std::array<bool, 6> isFree{true, false, true, true, true, false};
  body.setLinearFactor(btVector3(1, 0, 1));
  body.setAngularFactor(btVector3(1, 1, 0));
  const Vec6 blow = randomVector(random);
  body.applyCentralImpulse(toBullet(blow.head<3>()));
  body.applyTorqueImpulse(toBullet(blow.tail<3>()));
  constraint.beginTick(kTick);
  world.world.stepSimulation(kTick, 1, kTick);
  Mat6 all = mass + 0.5 * (added + added.transpose());
  Vec6 right = blow;
  for (int i = 0; i < 6; ++i) {
    if (isFree.at(static_cast<std::size_t>(i))) continue;
    all.row(i).setZero();
    all.col(i).setZero();
    all(i, i) = 1.0;
    right[i] = 0.0;
  }
  right = all.ldlt().solve(right);
  // Rows are orthogonal in M, so one sweep of the solver is exact.
  EXPECT_LT((velocityOf(body) - right).norm(), 100 * kEpsilon * right.norm());
  world.world.removeConstraint(&constraint);
  world.world.removeRigidBody(&body);
}

// Sleep.

TEST(ShipGuard, AShipThatIsPutToSleepAtRestDoesNotMove) {
  for (const int state : {ISLAND_SLEEPING, DISABLE_SIMULATION}) {
    Scene scene;
    scene.run(64);
    for (int i = 0; i < 3; ++i) {
      bodyOf(scene).forceActivationState(state);
      scene.run(5);
      EXPECT_EQ(scene.sphere->velocity().norm(), 0.0);
      bodyOf(scene).forceActivationState(ACTIVE_TAG);
      scene.run(5, kTick, 5);
      EXPECT_EQ(scene.sphere->velocity().norm(), 0.0);
    }
    EXPECT_EQ(heaveOf(scene), 0.0);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
  }
}

// It stays asleep until it is woken: nobody drives it meanwhile, and time goes on.
TEST(ShipGuard, AShipThatSleepsStaysWhereItIsUntilItIsWoken) {
  Scene scene({.start = {.speed = 3.0}});
  scene.run(64);
  bodyOf(scene).forceActivationState(DISABLE_SIMULATION);
  const btVector3 place = bodyOf(scene).getCenterOfMassPosition();
  scene.run(128);
  EXPECT_EQ((bodyOf(scene).getCenterOfMassPosition() - place).length(), 0);
  EXPECT_LT(scene.sphere->offCourse(), 0.5);  // its mean course waits for it
  EXPECT_NEAR(scene.seaway.time(), 3.0, 1e-6);
  bodyOf(scene).forceActivationState(ACTIVE_TAG);
  scene.run(64);
  EXPECT_GT((bodyOf(scene).getCenterOfMassPosition() - place).length(), 2);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

// Woken in the middle of a stepSimulation, in which Bullet has put no weight on it.
TEST(ShipGuard, AShipThatIsWokenBetweenTwoTicksOfOneStepDoesNotJump) {
  Scene scene;
  scene.run(10);
  bodyOf(scene).forceActivationState(ISLAND_SLEEPING);
  struct Wake final : btActionInterface {
    void updateAction(btCollisionWorld*, btScalar) override { body->activate(true); }
    void debugDraw(btIDebugDraw*) override {}
    btRigidBody* body = nullptr;
  } wake;
  wake.body = &bodyOf(scene);
  scene.world.world.addAction(&wake);
  scene.run(8, kTick, 8);
  scene.world.world.removeAction(&wake);
  EXPECT_EQ(scene.sphere->velocity().norm(), 0.0);
}

// Gravity, mass, damping.

TEST(ShipGuard, GravityThatIsSwitchedOffOrTiltedIsSaidAndThrowsNothing) {
  for (const btVector3& gravity : {btVector3(0, 0, 0), btVector3(3, 0, -9)}) {
    Scene scene;
    scene.run(10);
    scene.world.world.setGravity(gravity);
    scene.run(64);
    EXPECT_EQ(scene.seaway.faults(), kGravityChanged);
    EXPECT_LT(scene.sphere->motion().norm(), kStill);
  }
}

TEST(ShipGuard, AMassThatIsChangedIsSaid) {
  Scene scene;
  const btVector3 inertia = bodyOf(scene).getLocalInertia();
  bodyOf(scene).setMassProps(bodyOf(scene).getMass(), inertia);
  scene.run(2);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  bodyOf(scene).setMassProps(btScalar(1.2) * bodyOf(scene).getMass(), inertia);
  scene.run(2);
  EXPECT_EQ(scene.seaway.faults(), kMassChanged);
  EXPECT_LT(scene.sphere->motion().norm(), kStill);
}

// Bullet multiplies the velocity by (1 − d)^h; A∞ resists that as it does any blow.
TEST(ShipGuard, DampingOfTheBodyIsHonoured) {
  Scene free, damped;
  bodyOf(damped).setDamping(btScalar(0.3), 0);
  for (Scene* scene : {&free, &damped}) {
    scene->sphere->setEnabled("radiation", false);
    scene->sphere->setEnabled("resistance", false);
    scene->sphere->resetVelocity(Vec3(2, 0, 0), Vec3::Zero());
    scene->run(64 * 4);
  }
  EXPECT_NEAR(free.sphere->velocity()[0], 2.0, 1e-4);
  const double share = 1.0 / (1.0 + 0.2732);  // M/(M + A11), A11 = .2732 of ρV = M
  EXPECT_NEAR(damped.sphere->velocity()[0] / 2.0, std::pow(0.7, 4.0 * share), 0.01);
  EXPECT_EQ(bodyOf(damped).getLinearDamping(), btScalar(0.3));
}

TEST(ShipGuard, ASeaOrAWorldOfAnotherGravityIsRefused) {
  btSphereShape shape(5);
  const ShipSettings settings{.collision = {.shape = &shape}};
  const auto refusal = [&](double gravity, double seaGravity, const WorldFrame& frame) {
    TestWorld world(gravity);
    Seaway seaway(world.world, SeaState({{.omega = 1.0, .amplitude = 0.5}}, seaGravity), frame);
    try {
      seaway.addShip(hemisphere(), settings);
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
      EXPECT_EQ(seaway.ships().size(), 0u);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(9.81, 9.81, {}), "");
  EXPECT_EQ(refusal(10.0, 9.80665, {}), "");
  EXPECT_NE(refusal(1.62, 1.62, {}).find("the world's gravity"), std::string::npos);
  EXPECT_NE(refusal(9.81, 1.62, {}).find("the sea's gravity 1.62"), std::string::npos);
  EXPECT_NE(refusal(9.81, 9.81, {.metresPerUnit = 0.01}).find("981"), std::string::npos);
  EXPECT_EQ(refusal(981, 9.81, {.metresPerUnit = 0.01}), "");
}

// Moves.

TEST(ShipGuard, AShipThatIsSetElsewhereBeginsItsCourseThere) {
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Scene scene({.start = {.heading = 0.3, .speed = 3.0}, .model = {.mean = mean}}, {},
                slenderShip());
    scene.run(64);
    btTransform there = bodyOf(scene).getWorldTransform();
    there.setOrigin(there.getOrigin() + btVector3(1400, 300, 0));
    bodyOf(scene).setWorldTransform(there);
    scene.run(64);
    EXPECT_EQ(scene.seaway.faults(), kCourseBegan);
    EXPECT_LT(scene.sphere->offCourse(), 1.0);
    EXPECT_NEAR(scene.sphere->course().heading(), 0.3, 0.02);
    EXPECT_NEAR(scene.sphere->course().speed(), 3.0, 0.1);
    // A correction of a metre is none.
    scene.seaway.clearFaults();
    there = bodyOf(scene).getWorldTransform();
    there.setOrigin(there.getOrigin() + btVector3(1, 0, 0));
    bodyOf(scene).setWorldTransform(there);
    scene.run(4);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
  }
}

TEST(ShipGuard, FarFromItsFixedCourseItSaysSoAndHowFar) {
  Scene scene({.model = {.mean = Mean::Fixed}}, waves(), slenderShip());
  scene.run(64 * 3);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  // Pushed by hand, a few metres at a time: below what is taken for another place.
  for (int i = 0; i < 10; ++i) {
    btTransform there = bodyOf(scene).getWorldTransform();
    there.setOrigin(there.getOrigin() + btVector3(0, 8, 0));
    bodyOf(scene).setWorldTransform(there);
    scene.run(1);
  }
  EXPECT_EQ(scene.seaway.faults(), kFarFromCourse);
  EXPECT_NEAR(scene.sphere->offCourse(), 80.0, 1.0);
}

TEST(ShipGuard, TiltedOrOutOfTheWaterItSaysSo) {
  const Coefficients ship = slenderShip();  // keel at -5 m, deck at 6 m
  const auto faults = [&](const Vec6& offset) {
    Scene scene({.start = {.offset = offset}}, {}, ship);
    scene.run(1);
    return scene.seaway.faults();
  };
  EXPECT_EQ(faults(one(Roll, 0.5)), kStepOk);
  EXPECT_EQ(faults(one(Roll, 0.55)), kAttitudeOutsideTheory);
  EXPECT_EQ(faults(one(Pitch, -0.55)), kAttitudeOutsideTheory);
  EXPECT_EQ(faults(one(Heave, 4.9)), kStepOk);
  EXPECT_EQ(faults(one(Heave, 5.1)), kOutOfWater);
  EXPECT_EQ(faults(one(Heave, -6.1)), kOutOfWater);
  EXPECT_EQ(kWarningBits & kOutOfWater, kOutOfWater);
}

}  // namespace
}  // namespace cutwater::test
