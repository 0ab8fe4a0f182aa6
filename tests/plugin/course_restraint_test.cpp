#include <gtest/gtest.h>

#include "plugin/CourseRestraint.h"
#include "tests/plugin/TestWorld.h"

namespace cutwater::test {
namespace {

// A body pulled and spun on every axis, held in surge, heave and yaw: these have the velocity asked
// for after the tick, whatever the pull; the others move as if free. Round-off of one solver row
// each.
TEST(CourseRestraintIdentity, HeldModesHaveTheVelocityAskedForAndTheOthersAreFree) {
  TestWorld world;
  btSphereShape shape(1);
  btRigidBody held(100, nullptr, &shape, btVector3(40, 50, 60)),
      free(100, nullptr, &shape, btVector3(40, 50, 60));
  free.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(50, 0, 0)));
  CourseRestraint restraint(held, {true, false, true, false, false, true});
  for (btRigidBody* body : {&held, &free}) {
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setFlags(0);
    world.world.addRigidBody(body);
  }
  world.world.addConstraint(&restraint);
  restraint.aim(btMatrix3x3::getIdentity(), btMatrix3x3::getIdentity(),
                {btScalar(0.5), 9, btScalar(-0.25), 9, 9, btScalar(0.125)});
  for (btRigidBody* body : {&held, &free}) {
    body->applyCentralForce(btVector3(1000, 2000, 3000));
    body->applyTorque(btVector3(100, 200, 300));
  }
  world.world.stepSimulation(kTick, 1, kTick);
  const Vec6 a = velocityOf(held), b = velocityOf(free);
  EXPECT_NEAR(a[Surge], 0.5, 10 * kEpsilon);
  EXPECT_NEAR(a[Heave], -0.25, 10 * kEpsilon);
  EXPECT_NEAR(a[Yaw], 0.125, 10 * kEpsilon);
  EXPECT_NEAR(a[Sway], b[Sway], 10 * kEpsilon);
  EXPECT_NEAR(a[Roll], b[Roll], 10 * kEpsilon);
  EXPECT_NEAR(a[Pitch], b[Pitch], 10 * kEpsilon);
  world.world.removeConstraint(&restraint);
  for (btRigidBody* body : {&held, &free}) world.world.removeRigidBody(body);
}

}  // namespace
}  // namespace cutwater::test
