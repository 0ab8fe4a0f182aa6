// What Bullet programs do to a ship without asking it: locks, sleep, gravity, removal, moves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/linear/Restoring.h"
#include "plugin/AddedMassConstraint.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr btScalar kNan = std::numeric_limits<btScalar>::quiet_NaN();

btRigidBody& bodyOf(Scene& scene) { return scene.sphere->body(); }
double heaveOf(const Scene& scene) { return scene.sphere->motion()[Heave]; }
// Of a place of some metres, kept by a float for some hundred ticks.
constexpr double kStill = 1e4 * kEpsilon;

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
  for (const Mean mean : {Mean::Fixed, Mean::Filtered}) {
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
  Scene scene({}, waves(), slenderShip());
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

// What is ours in the world.

TEST(ShipGuard, AConstraintThatIsTakenOutIsPutBackAndSaid) {
  for (const bool deleted : {false, true}) {
    std::array<bool, 6> held{};
    held[Surge] = true;
    const ShipSettings settings{.start = {.offset = one(Heave, 1.0)},
                                .model = {.restrained = held}};
    Scene scene(settings), twin(settings);
    scene.run(40);
    twin.run(40);
    btDiscreteDynamicsWorld& world = scene.world.world;
    ASSERT_EQ(world.getNumConstraints(), 2);
    while (world.getNumConstraints() > 0) {  // as a level is cleared
      btTypedConstraint* constraint = world.getConstraint(0);
      world.removeConstraint(constraint);
      if (deleted) delete constraint;
    }
    scene.run(40);
    twin.run(40);
    EXPECT_EQ(scene.seaway.faults(), kConstraintRemoved);
    EXPECT_EQ(world.getNumConstraints(), 2);
    // A new constraint does not know the velocity before a blow that has not been solved for.
    EXPECT_NEAR(heaveOf(scene), heaveOf(twin), deleted ? 0.02 : kStill);
    scene.seaway.clearFaults();
    scene.run(5);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
  }
}

// The loop with which Bullet's examples end.
void clearWorld(btDiscreteDynamicsWorld& world) {
  for (int i = world.getNumConstraints() - 1; i >= 0; --i) {
    btTypedConstraint* constraint = world.getConstraint(i);
    world.removeConstraint(constraint);
    delete constraint;
  }
  for (int i = world.getNumCollisionObjects() - 1; i >= 0; --i) {
    btCollisionObject* object = world.getCollisionObjectArray()[i];
    btRigidBody* body = btRigidBody::upcast(object);
    if (body != nullptr && body->getMotionState() != nullptr) delete body->getMotionState();
    world.removeCollisionObject(object);
    delete object;
  }
}

TEST(ShipGuard, AWorldThatIsClearedAndStepsOnLeavesAShipWithoutABody) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}}, waves());
  scene.run(20);
  clearWorld(scene.world.world);
  scene.run(20);
  EXPECT_EQ(scene.seaway.faults(), kBodyNotInWorld);
  EXPECT_TRUE(scene.sphere->motion().allFinite());
  EXPECT_FALSE(bodyOf(scene).isInWorld());
  scene.sphere->reset({.x = 5});
  scene.run(2);
  scene.seaway.removeShip(*scene.sphere);
  Ship& next = scene.seaway.addShip(scene.coefficients, {.collision = {.shape = &scene.shape}});
  scene.seaway.clearFaults();
  scene.run(20);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  EXPECT_TRUE(next.body().isInWorld());
}

// Bodies alone are deleted, and the world steps on.
TEST(ShipGuard, ABodyThatIsDeletedTakesItsConstraintsOutOfTheWorld) {
  Scene scene;
  scene.run(5);
  btRigidBody* body = &bodyOf(scene);
  delete body->getMotionState();
  scene.world.world.removeRigidBody(body);
  delete body;
  scene.run(5);
  EXPECT_EQ(scene.seaway.faults(), kBodyNotInWorld);
  EXPECT_EQ(scene.world.world.getNumConstraints(), 0);
}

// All orders in which world, ships and sea may end.
TEST(ShipGuard, EveryOrderOfDestructionIsDefined) {
  const Coefficients ship = hemisphere();
  btSphereShape shape(5);
  const ShipSettings settings{.collision = {.shape = &shape}};
  struct Stage {
    std::unique_ptr<TestWorld> world;
    std::unique_ptr<Seaway> seaway;
    Ship* first = nullptr;
    void tick() { world->world.stepSimulation(kTick, 1, kTick); }
  };
  const std::vector<std::pair<const char*, void (*)(Stage&)>> orders{
      {"as it should be", [](Stage& s) { s.seaway.reset(); }},
      {"the world first", [](Stage& s) { s.world.reset(); }},
      {"cleared, then the sea", [](Stage& s) { clearWorld(s.world->world); }},
      {"cleared and ended, then the sea",
       [](Stage& s) {
         clearWorld(s.world->world);
         s.world.reset();
       }},
      {"taken out, not deleted",
       [](Stage& s) {
         s.world->world.removeRigidBody(&s.first->body());
         s.seaway.reset();
       }},
      {"the world first, then a body",
       [](Stage& s) {
         btRigidBody* body = &s.first->body();
         delete body->getMotionState();
         s.world.reset();
         delete body;
       }},
      {"the world first, then a ship",
       [](Stage& s) {
         s.world.reset();
         s.seaway->removeShip(*s.first);
       }},
      {"a constraint removed, put back, deleted",
       [](Stage& s) {
         btTypedConstraint* constraint = s.world->world.getConstraint(0);
         s.world->world.removeConstraint(constraint);
         s.tick();
         delete constraint;
         s.tick();
       }},
      {"a ship, then the world", [](Stage& s) {
         s.seaway->removeShip(*s.first);
         s.world.reset();
       }}};
  for (const auto& [name, end] : orders) {
    SCOPED_TRACE(name);
    Stage stage;
    stage.world = std::make_unique<TestWorld>(kSphereGravity);
    stage.seaway = std::make_unique<Seaway>(stage.world->world, waves());
    stage.first = &stage.seaway->addShip(ship, settings);
    stage.seaway->addShip(ship, {.start = {.x = 40}, .collision = {.shape = &shape}});
    stage.tick();
    end(stage);
    stage.seaway.reset();
    if (!stage.world) continue;
    for (int i = 0; i < 5; ++i) stage.tick();
    Seaway again(stage.world->world, waves());
    const Ship& next = again.addShip(ship, settings);
    for (int i = 0; i < 5; ++i) stage.tick();
    EXPECT_EQ(again.faults(), kStepOk);
    EXPECT_GT(next.lastTick().time, 0.0);
  }
}

// The user's own body in a world that is cleared: nothing of it is read any more.
TEST(ShipGuard, AUsersBodyThatWasClearedIsNotTouched) {
  btSphereShape shape(5);
  const auto inertia = static_cast<btScalar>(261800.0 * 2.5 * 2.5);
  for (const bool ticks : {false, true}) {
    TestWorld world(kSphereGravity);
    auto* body = new btRigidBody(btRigidBody::btRigidBodyConstructionInfo(
        261800, nullptr, &shape, btVector3(inertia, inertia, inertia)));
    world.world.addRigidBody(body);
    Seaway seaway(world.world);
    const Ship& ship = seaway.addShip(hemisphere(), *body);
    world.world.stepSimulation(kTick, 1, kTick);
    clearWorld(world.world);
    if (!ticks) continue;
    world.world.stepSimulation(kTick, 1, kTick);
    EXPECT_EQ(seaway.faults(), kBodyNotInWorld);
    EXPECT_TRUE(ship.motion().allFinite());
  }
}

// Held still, and its constraint deleted meanwhile.
TEST(ShipGuard, HeldStillByItsMassItKeepsItsCourse) {
  Scene scene({.start = {.speed = 6}}, {}, slenderShip());
  scene.run(10);
  const btScalar mass = bodyOf(scene).getMass();
  const btVector3 inertia = bodyOf(scene).getLocalInertia();
  bodyOf(scene).setMassProps(0, btVector3(0, 0, 0));
  btTypedConstraint* constraint = scene.world.world.getConstraint(0);
  scene.world.world.removeConstraint(constraint);
  delete constraint;
  scene.run(64 * 10);
  EXPECT_LT(scene.sphere->offCourse(), 0.5);
  bodyOf(scene).setMassProps(mass, inertia);
  bodyOf(scene).updateInertiaTensor();
  scene.run(64);
  EXPECT_LT(scene.sphere->offCourse(), 7.0);
  EXPECT_EQ(scene.seaway.faults(), kConstraintRemoved);
}

// Bullet's damping changes the rate that a locked heading was given; it is no order of the user's.
TEST(ShipGuard, ALockedYawIsHeldUnderDamping) {
  Scene scene({.start = {.offset = one(Roll, 0.2)}}, waves(), coupledShip());
  bodyOf(scene).setAngularFactor(btVector3(1, 1, 0));
  bodyOf(scene).setDamping(0, btScalar(0.3));
  scene.run(64 * 60);
  EXPECT_NEAR(scene.sphere->attitude()[2], 0.0, 1e-5);
}

TEST(ShipGuard, ANewWorldAtTheAddressOfOneThatIsGoneGetsASeaOfItsOwn) {
  alignas(TestWorld) unsigned char place[sizeof(TestWorld)];
  btSphereShape shape(5);
  const Coefficients ship = hemisphere();
  std::unique_ptr<Seaway> before;
  for (int i = 0; i < 3; ++i) {
    auto* world = new (place) TestWorld(kSphereGravity);
    auto next = std::make_unique<Seaway>(world->world);
    before = std::move(next);  // ends the one of the world that was here
    const Ship& sphere = before->addShip(
        ship, {.start = {.offset = one(Heave, 1.0)}, .collision = {.shape = &shape}});
    world->world.stepSimulation(kTick, 1, kTick);
    EXPECT_LT(sphere.velocity()[2], 0.0);
    EXPECT_EQ(before->faults(), kStepOk);
    world->~TestWorld();
  }
}

TEST(ShipGuard, AShipWithSomebodysJointIsNotRemoved) {
  Scene scene;
  btSphereShape ball(1);
  btRigidBody weight(
      btRigidBody::btRigidBodyConstructionInfo(1000, nullptr, &ball, btVector3(400, 400, 400)));
  scene.world.world.addRigidBody(&weight, 0, 0);
  btPoint2PointConstraint joint(weight, bodyOf(scene), btVector3(0, 0, 5), btVector3(0, 0, 0));
  scene.world.world.addConstraint(&joint);
  try {
    scene.seaway.removeShip(*scene.sphere);
    FAIL() << "removed";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::BadArgument);
    EXPECT_NE(std::string(error.what()).find("btPoint2PointConstraint"), std::string::npos);
  }
  scene.run(5);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  scene.world.world.removeConstraint(&joint);
  scene.seaway.removeShip(*scene.sphere);
  EXPECT_EQ(scene.seaway.ships().size(), 0u);
  scene.world.world.removeRigidBody(&weight);
}

// A sea that ends takes the joints of its ships' bodies out, so that the world does not read them.
TEST(ShipGuard, ASeaThatEndsTakesJointsOfItsShipsOut) {
  TestWorld world(kSphereGravity);
  btSphereShape shape(5), ball(1);
  btRigidBody weight(
      btRigidBody::btRigidBodyConstructionInfo(1000, nullptr, &ball, btVector3(400, 400, 400)));
  world.world.addRigidBody(&weight, 0, 0);
  std::unique_ptr<btPoint2PointConstraint> joint;
  {
    Seaway seaway(world.world);
    Ship& ship = seaway.addShip(hemisphere(), {.collision = {.shape = &shape}});
    joint = std::make_unique<btPoint2PointConstraint>(weight, ship.body(), btVector3(0, 0, 5),
                                                      btVector3(0, 0, 0));
    world.world.addConstraint(joint.get());
    world.world.stepSimulation(kTick, 1, kTick);
  }
  EXPECT_EQ(world.world.getNumConstraints(), 0);
  world.world.stepSimulation(kTick, 1, kTick);
  world.world.removeRigidBody(&weight);
}

TEST(ShipGuard, AUsersBodyIsGivenBackAsItWas) {
  TestWorld world(kSphereGravity);
  btSphereShape shape(5);
  const auto inertia = static_cast<btScalar>(261800.0 * 2.5 * 2.5);
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(261800, nullptr, &shape,
                                                            btVector3(inertia, inertia, inertia)));
  world.world.addRigidBody(&body);
  const int flags = body.getFlags();
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(hemisphere(), body);
  EXPECT_EQ(seaway.shipOf(body), &ship);
  EXPECT_EQ(body.getGravity().length(), 0);
  seaway.removeShip(ship);
  EXPECT_EQ(seaway.shipOf(body), nullptr);
  EXPECT_EQ(body.getFlags(), flags);
  world.world.stepSimulation(kTick, 1, kTick);
  EXPECT_NEAR(static_cast<double>(body.getLinearVelocity().z()), -kSphereGravity / 64, 1e-5);
  world.world.removeRigidBody(&body);
}

// Beginning again.

TEST(ShipGuard, AResetShipHasTheBitsOfANewOne) {
  const ShipStart moving{.x = 20,
                         .y = -7,
                         .heading = 0.4,
                         .speed = 4,
                         .offset = one(Roll, 0.1) + one(Heave, 0.4),
                         .velocity = one(Sway, 0.3)};
  for (const Mean mean : {Mean::Fixed, Mean::Filtered}) {
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
  Scene scene({.start = {.speed = 6},
               .model = {.mean = Mean::Filtered, .keepSpeed = SpeedKeeper{.speed = 6}}},
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
  for (const Mean mean : {Mean::Fixed, Mean::Filtered}) {
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
  for (const Mean mean : {Mean::Fixed, Mean::Filtered}) {
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

TEST(MotionAngles, AreEulersWhenUprightAndHaveNoJumpBeyond) {
  const auto rotation = [](double roll, double pitch, double yaw) {
    return Mat3((Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
                 Eigen::AngleAxisd(roll, Vec3::UnitX()))
                    .toRotationMatrix());
  };
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

// Shared among worlds.

TEST(ShipGuard, WaveLoadsLiveAsLongAsTheirHydrodynamics) {
  const auto hydro = std::make_shared<const Hydrodynamics>(slenderShip());
  const SeaTables first(hydro, std::make_shared<const SeaState>(waves()));
  const auto* table = first.following().get();
  const auto* course = first.exact(0.4, 0.0).get();
  // Other heights and phases of the same waves are the same loads per metre.
  const SeaState sea = waves();
  std::vector<WaveComponent> higher(sea.components().begin(), sea.components().end());
  for (WaveComponent& wave : higher) {
    wave.amplitude *= 2.0;
    wave.phase += 1.0;
  }
  const SeaTables second(hydro, std::make_shared<const SeaState>(higher, kSphereGravity));
  EXPECT_EQ(second.following().get(), table);
  EXPECT_EQ(second.exact(0.4, 0.0).get(), course);
  EXPECT_NE(second.exact(0.5, 0.0).get(), course);
  higher.front().heading += 0.1;
  const SeaTables other(hydro, std::make_shared<const SeaState>(higher, kSphereGravity));
  EXPECT_NE(other.following().get(), table);
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
