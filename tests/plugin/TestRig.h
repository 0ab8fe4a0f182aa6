#pragma once
#include <cmath>
#include <functional>
#include <memory>

#include "plugin/AddedMassConstraint.h"
#include "plugin/WorldHook.h"
#include "tests/plugin/TestWorld.h"

/// A body with an AddedMassConstraint and no other hydrodynamics.
namespace cutwater::test {

using Info = btRigidBody::btRigidBodyConstructionInfo;

inline constexpr double kH = 1.0 / 64;

// A body with added mass in a world, ticked as Seaway does.
struct Rig final : TickListener {
  Rig(TestWorld& owner, const btRigidBody::btRigidBodyConstructionInfo& info, const Mat6& addedMass,
      const btTransform& pose = btTransform::getIdentity())
      : world(owner.world), body(info) {
    body.setCenterOfMassTransform(pose);
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setFlags(0);  // the gyroscopic torque has a test of its own
    constraint = std::make_unique<AddedMassConstraint>(body, addedMass);
    world.addRigidBody(&body);
    world.addConstraint(constraint.get());
    hook = std::make_unique<WorldHook>(world, *this);
  }
  ~Rig() override {
    hook.reset();
    world.removeConstraint(constraint.get());
    world.removeRigidBody(&body);
  }
  void beforeTick(btScalar step) noexcept override {
    if (load) load();
    constraint->beginTick(step);
  }
  void afterTick(btScalar) noexcept override { constraint->endTick(); }
  void slotTaken() noexcept override {}
  void tick(int count = 1) {
    for (int i = 0; i < count; ++i) world.stepSimulation(kTick, 1, kTick);
  }

  btDiscreteDynamicsWorld& world;
  btRigidBody body;
  std::unique_ptr<AddedMassConstraint> constraint;
  std::unique_ptr<WorldHook> hook;
  std::function<void()> load;  // impulses of the pre-tick
};

// A frigate, and a boat of a tenth of its length.
struct Size {
  double length, mass;
  Vec3 inertia;
};
inline const Size kFrigate{100.0, 4.0e6, {1.4e8, 3.3e9, 3.4e9}};
inline const Size kBoat{10.0, 4.0e3, {1.4e3, 3.3e4, 3.4e4}};

inline Mat6 shipMass(const Size& ship = kFrigate) {
  Vec6 diagonal;
  diagonal << Vec3::Constant(ship.mass), ship.inertia;
  return diagonal.asDiagonal();
}

inline Info shipInfo(btCollisionShape& shape, const Size& ship = kFrigate) {
  return {static_cast<btScalar>(ship.mass), nullptr, &shape, toBullet(ship.inertia)};
}

inline btTransform someAttitude() {
  return btTransform(btQuaternion(btVector3(1, -2, 3).normalized(), btScalar(0.7)),
                     btVector3(3, -5, 2));
}

// Length of a velocity in the metric of M: metres and radians made one.
inline double size(const Mat6& mass, const Vec6& v) { return std::sqrt(v.dot(mass * v)); }

}  // namespace cutwater::test
