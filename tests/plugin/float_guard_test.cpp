// What a Bullet program does to bodies that float: take out, delete, hold, put to sleep, save.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "hydro/geometry/shapes/Shapes.h"
#include "plugin/AddedMassConstraint.h"
#include "tests/plugin/FloatScene.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

SeaState someWaves() {
  return SeaState({{.omega = 1.1, .amplitude = 0.5, .heading = 0.4},
                   {.omega = 2.3, .amplitude = 0.1, .phase = 1.0, .heading = -0.5}},
                  kStandardGravity, 2.0, WaveProfile::Wheeler);
}

struct Crates : FloatScene {
  explicit Crates(int count = 3, SeaState sea = someWaves()) : FloatScene(std::move(sea)) {
    for (int i = 0; i < count; ++i) seaway.addFloat(body(box, 500.0, {3.0 * i, 0.0, 0.4 * i}));
  }
  btBoxShape box{btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5))};
};

TEST(FloatGuard, WhatIsNoFloatIsRefused) {
  Crates scene(1);
  btRigidBody& crate = *scene.bodies.front();
  const auto add = [&](btRigidBody& body, const FloatSettings& settings = {}) {
    return [&scene, &body, settings] { scene.seaway.addFloat(body, settings); };
  };
  expectRefusal(Fault::BadArgument, {"addFloat", "already"}, add(crate));
  btRigidBody outside(1, nullptr, &scene.box, btVector3(1, 1, 1));
  expectRefusal(Fault::BadArgument, {"addFloat", "not in the world"}, add(outside));
  btTriangleMesh triangles;
  triangles.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  btBvhTriangleMeshShape terrain(&triangles, true);
  btScaledBvhTriangleMeshShape scaled(&terrain, btVector3(2, 2, 2));
  expectRefusal(Fault::BadArgument, {"SCALEDBVHTRIANGLEMESH", "FloatSettings::mesh"},
                add(scene.body(scaled, 0.0)));
  btCompoundShape crossed;
  for (const double x : {0.0, 0.5}) {
    crossed.addChildShape(
        btTransform(btQuaternion::getIdentity(), btVector3(static_cast<btScalar>(x), 0, 0)),
        &scene.box);
  }
  expectRefusal(Fault::BadArgument, {"overlap", "%"}, add(scene.body(crossed, 10.0)));
  btEmptyShape nothing;
  expectRefusal(Fault::BadArgument, {"no volume"}, add(scene.body(nothing, 0.0)));
  btRigidBody& plain = scene.body(scene.box, 1.0);
  FloatSettings open;
  open.mesh = closedSphere(1.0, 8, 8);
  open.mesh->faces.pop_back();
  expectRefusal(Fault::HullNotClosed, {"addFloat", "not closed"}, add(plain, open));
  FloatSettings inverted;
  inverted.mesh = turnedOver(closedSphere(1.0, 8, 8));
  expectRefusal(Fault::HullInverted, {"addFloat", "outwards"}, add(plain, inverted));
  expectRefusal(Fault::ValueOutOfRange, {"normalDrag", "-1"}, add(plain, {.normalDrag = -1.0}));
  expectRefusal(Fault::ValueOutOfRange, {"waterDensity"},
                add(plain, {.waterDensity = std::numeric_limits<double>::quiet_NaN()}));
  scene.world.world.setGravity(btVector3(0, btScalar(-9.8), 0));
  expectRefusal(Fault::ValueOutOfRange, {"gravity", "down"}, add(plain));
  EXPECT_EQ(scene.seaway.floats().size(), 1u);
  EXPECT_EQ(scene.seaway.floatOf(plain), nullptr);
  EXPECT_EQ(scene.seaway.floatOf(crate), scene.seaway.floats().front().get());
}

TEST(FloatGuard, AMeshMayStandForTheShape) {
  FloatScene scene;
  btBoxShape box(btVector3(1, 1, 1));
  FloatSettings settings;
  settings.mesh = closedSphere(1.0, 32, 32);
  Float& one = scene.seaway.addFloat(scene.body(box, 2000.0), settings);
  EXPECT_NEAR(one.volume(), 4.0 / 3.0 * kPi, 0.02);  // an inscribed ball, thinned
  scene.run(40.0);
  EXPECT_NEAR(one.wetVolume(), 2000.0 / kRho, 2e-3);
}

TEST(FloatGuard, BodiesAreTakenOutDeletedAndRemovedInAnyOrder) {
  for (int order = 0; order < 4; ++order) {
    Crates scene(4);
    btDiscreteDynamicsWorld& world = scene.world.world;
    scene.run(1.0);
    btRigidBody* second = scene.bodies[1].get();
    world.removeRigidBody(second);
    if (order == 0) scene.seaway.removeFloat(*scene.seaway.floatOf(*second));
    if (order < 3) scene.bodies.erase(scene.bodies.begin() + 1);  // deleted
    scene.run(0.5);
    if (order == 1) scene.seaway.removeFloat(*scene.seaway.floats()[1]);
    if (order == 3) world.addRigidBody(second);  // and put in again
    scene.run(0.5);
    EXPECT_EQ(world.getNumConstraints(), order == 3 ? 4 : 3);
    EXPECT_EQ(scene.seaway.floats()[1]->inWorld(), order != 2);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
  }
}

TEST(FloatGuard, ARemovedFloatFallsAndItsWorldGoesOn) {
  Crates scene(2);
  scene.run(5.0);
  scene.seaway.removeFloat(*scene.seaway.floats()[0]);
  scene.run(2.0);
  EXPECT_LT(scene.place(*scene.bodies[0]).z(), -10.0);  // ½ g t²
  EXPECT_GT(scene.place(*scene.bodies[1]).z(), -1.0);
  EXPECT_EQ(scene.world.world.getNumConstraints(), 1);
}

TEST(FloatGuard, ConstraintsThatAreTakenOutOrDeletedAreMadeAnew) {
  for (const bool deleted : {false, true}) {
    Crates scene;
    scene.run(2.0);
    btDiscreteDynamicsWorld& world = scene.world.world;
    while (world.getNumConstraints() > 0) {
      btTypedConstraint* constraint = world.getConstraint(0);
      world.removeConstraint(constraint);
      if (deleted) delete constraint;
    }
    scene.run(1.0);
    EXPECT_EQ(world.getNumConstraints(), 3);
    EXPECT_EQ(scene.seaway.faults(), deleted ? kStepOk : kConstraintRemoved);
    for (const auto& body : scene.bodies) EXPECT_GT(scene.place(*body).z(), -2.0);
  }
}

// Nothing of the world, of bodies or of the sea is touched after its end, whichever goes first.
TEST(FloatGuard, SeaBodiesAndWorldEndInAnyOrder) {
  for (int order = 0; order < 4; ++order) {
    auto world = std::make_unique<TestWorld>(kStandardGravity);
    btBoxShape box(btVector3(1, 1, 1));
    auto body = std::make_unique<btRigidBody>(btScalar(1000), nullptr, &box, btVector3(9, 9, 9));
    auto seaway = std::make_unique<Seaway>(world->world, someWaves());
    world->world.addRigidBody(body.get());
    seaway->addFloat(*body);
    const auto step = [&] { world->world.stepSimulation(kTick, 1, kTick); };
    step();
    if (order == 0) {  // the sea goes, and the world steps on without the body
      seaway.reset();
      step();
      world->world.removeRigidBody(body.get());
      body.reset();
      step();
    } else if (order == 1) {  // bodies declared last
      world->world.removeRigidBody(body.get());
      body.reset();
      seaway.reset();
      step();
    } else if (order == 2) {  // the world first
      world.reset();
      body.reset();
      seaway.reset();
    } else {
      world.reset();
      seaway->removeFloat(*seaway->floats().front());
      seaway.reset();
    }
  }
}

TEST(FloatGuard, AWorldThatIsClearedLeavesFloatsWithoutBodies) {
  TestWorld world(kStandardGravity);
  Seaway seaway(world.world, someWaves());
  btBoxShape box(btVector3(1, 1, 1));
  auto* body = new btRigidBody(btScalar(1000), nullptr, &box, btVector3(9, 9, 9));
  world.world.addRigidBody(body);
  seaway.addFloat(*body);
  const auto step = [&] { world.world.stepSimulation(kTick, 1, kTick); };
  step();
  btTypedConstraint* constraint = world.world.getConstraint(0);
  world.world.removeConstraint(constraint);
  delete constraint;
  world.world.removeRigidBody(body);
  delete body;
  step();
  EXPECT_FALSE(seaway.floats().front()->inWorld());
  EXPECT_EQ(seaway.faults(), kStepOk);
}

TEST(FloatGuard, HeldBodiesHaveNoLoadAndGoOnWhenTheyAreLetGo) {
  Crates scene(2);
  btRigidBody& held = *scene.bodies[0];
  btVector3 inertia;
  scene.box.calculateLocalInertia(500, inertia);
  held.setMassProps(0, btVector3(0, 0, 0));
  const Vec3 before = scene.place(held);
  scene.run(3.0);
  EXPECT_EQ((scene.place(held) - before).norm(), 0.0);
  held.setMassProps(500, inertia);
  held.setGravity(scene.world.world.getGravity());
  held.setCollisionFlags(held.getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT);
  held.activate(true);
  scene.run(20.0);
  EXPECT_NEAR(scene.place(held).z(), 0.0, 1.5);  // it rides the waves
  // Twice as heavy it goes down.
  held.setMassProps(1500, 3 * inertia);
  held.setGravity(scene.world.world.getGravity());
  scene.run(10.0);
  EXPECT_LT(scene.place(held).z(), -5.0);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
}

TEST(FloatGuard, BodiesSleepWhenTheyLieStillAndWakeInWaves) {
  Crates calm(1, SeaState());
  calm.run(200.0);
  EXPECT_EQ(calm.bodies[0]->getActivationState(), ISLAND_SLEEPING);
  calm.bodies[0]->activate(true);
  calm.bodies[0]->applyCentralImpulse(btVector3(0, 0, -2000));
  calm.run(0.5);
  EXPECT_LT(calm.place(*calm.bodies[0]).z(), -0.2);
  Crates rough(1);
  rough.run(20.0);
  rough.bodies[0]->forceActivationState(ISLAND_SLEEPING);
  rough.run(0.1);
  EXPECT_EQ(rough.bodies[0]->getActivationState(), ACTIVE_TAG);
}

TEST(FloatGuard, SleepersWakeWhereTheWaterHasGone) {
  Crates calm(1, SeaState());
  calm.run(200.0);
  EXPECT_EQ(calm.bodies[0]->getActivationState(), ISLAND_SLEEPING);
  calm.seaway.setCalmLevel(-5.0, HUGE_VAL);
  calm.run(20.0);
  EXPECT_LT(calm.place(*calm.bodies[0]).z(), 1.0);
  EXPECT_LT(fromBullet(calm.bodies[0]->getWorldTransform().getOrigin()).z(), -4.0);
}

// A character's capsule turns about no axis.
TEST(FloatGuard, ABodyWithoutInertiaFloatsUpright) {
  FloatScene scene(someWaves());
  btCapsuleShapeZ capsule(btScalar(0.25), btScalar(1.2));
  btRigidBody swimmer(80, nullptr, &capsule, btVector3(0, 0, 0));
  scene.world.world.addRigidBody(&swimmer);
  Float& one = scene.seaway.addFloat(swimmer);
  scene.run(30.0);
  EXPECT_GT(one.immersion(), 0.0);
  EXPECT_NEAR(fromBullet(swimmer.getWorldTransform().getBasis()).trace(), 3.0, 1e-5);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  scene.seaway.removeFloat(one);
  scene.world.world.removeRigidBody(&swimmer);
}

TEST(FloatGuard, WhatIsNotANumberIsMended) {
  Crates scene(2);
  scene.run(1.0);
  const auto nan = std::numeric_limits<btScalar>::quiet_NaN();
  scene.bodies[0]->setLinearVelocity(btVector3(nan, 0, 0));
  scene.bodies[1]->applyCentralForce(btVector3(0, nan, 0));
  scene.run(1.0);
  EXPECT_EQ(scene.seaway.faults(), kStateNotFinite | kLoadNotFinite);
  for (const auto& body : scene.bodies) EXPECT_LT(scene.place(*body).norm(), 20.0);
}

// The same bits however ticks are grouped, and after a snapshot through bytes.
TEST(FloatIdentity, GroupingOfTicksAndSnapshotsGiveTheSameBits) {
  Crates one, other;
  one.run(6.0);
  for (int i = 0; i < 96; ++i) other.world.world.stepSimulation(4 * kTick, 4, kTick);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(sameBits(*one.bodies[i], *other.bodies[i]));
  one.seaway.forgetContacts();
  const auto bytes = one.seaway.save().toBytes();
  one.run(4.0);
  std::vector<btTransform> poses;
  for (const auto& body : one.bodies) poses.push_back(body->getWorldTransform());
  one.seaway.forgetContacts();
  one.seaway.restore(Seaway::Snapshot::fromBytes(bytes));
  one.run(4.0);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(one.bodies[i]->getWorldTransform() == poses[i]) << i;
  Crates fewer(2);
  expectRefusal(Fault::BadArgument, {"floats", "2"},
                [&] { fewer.seaway.restore(Seaway::Snapshot::fromBytes(bytes)); });
}

}  // namespace
}  // namespace cutwater::test
