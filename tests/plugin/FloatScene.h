#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "plugin/Seaway.h"
#include "tests/plugin/TestWorld.h"

namespace cutwater::test {

inline constexpr double kRho = 1025.0;  // FloatSettings::waterDensity

// A world with a sea and bodies that float in it.
struct FloatScene {
  explicit FloatScene(SeaState sea = {}, const WorldFrame& frame = {},
                      double gravity = kStandardGravity)
      : world(gravity / frame.metresPerUnit), seaway(world.world, std::move(sea), frame) {
    world.world.setGravity(frame.length(Vec3(0.0, 0.0, -gravity)));
  }
  ~FloatScene() {
    for (const auto& body : bodies) world.world.removeRigidBody(body.get());
  }
  // Mass [kg] and place [m] in E.
  btRigidBody& body(btCollisionShape& shape, double mass, const Vec3& at = Vec3::Zero(),
                    const Mat3& attitude = Mat3::Identity()) {
    const WorldFrame& frame = seaway.frame();
    const auto units = static_cast<btScalar>(mass / frame.kilogramsPerUnit);
    btVector3 inertia(0, 0, 0);
    shape.calculateLocalInertia(units, inertia);
    bodies.push_back(std::make_unique<btRigidBody>(units, nullptr, &shape, inertia));
    bodies.back()->setCenterOfMassTransform(btTransform(frame.rotation(attitude), frame.place(at)));
    world.world.addRigidBody(bodies.back().get());
    return *bodies.back();
  }
  void run(double seconds, double tick = 1.0 / 64, const std::function<void()>& each = {}) {
    const int ticks = static_cast<int>(std::lround(seconds / tick));
    for (int i = 0; i < ticks; ++i) {
      world.world.stepSimulation(static_cast<btScalar>(tick), 1, static_cast<btScalar>(tick));
      if (each) each();
    }
  }
  Vec3 place(const btRigidBody& body) const {
    return seaway.frame().placeToEarth(body.getCenterOfMassPosition());
  }

  TestWorld world;
  Seaway seaway;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
};

}  // namespace cutwater::test
