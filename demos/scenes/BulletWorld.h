#pragma once
#include <btBulletDynamicsCommon.h>

namespace cutwater {

/// A stock Bullet world, z up, with everything it needs.
struct BulletWorld {
  explicit BulletWorld(double gravity = 9.80665) {
    world.setGravity(btVector3(0, 0, static_cast<btScalar>(-gravity)));
  }
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

}  // namespace cutwater
