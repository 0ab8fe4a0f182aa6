// Who deletes what, and in which order: a ship's body, constraints, world and sea.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "plugin/AddedMassConstraint.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

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

}  // namespace
}  // namespace cutwater::test
