#pragma once
#include <algorithm>
#include <cstring>
#include <string_view>

#include "plugin/Seaway.h"
#include "tests/plugin/TestShip.h"
#include "tests/plugin/TestWorld.h"

/// A half sphere afloat in a world of its own.
namespace cutwater::test {

// A half sphere in a world of its own.
struct Scene {
  explicit Scene(const ShipSettings& start = {}, SeaState sea = {},
                 Coefficients ship = hemisphere())
      : coefficients(std::move(ship)), seaway(world.world, std::move(sea)) {
    ShipSettings settings = start;
    settings.collision.shape = &shape;
    sphere = &seaway.addShip(coefficients, settings);
  }
  void run(int ticks, btScalar step = kTick, int perCall = 1) {
    for (int i = 0; i < ticks; i += perCall) {
      world.world.stepSimulation(step * static_cast<btScalar>(perCall), perCall, step);
    }
  }

  TestWorld world{kSphereGravity};
  btSphereShape shape{5};
  Coefficients coefficients;
  Seaway seaway;
  Ship* sphere = nullptr;
};

inline bool hasPart(const Ship& ship, std::string_view part) {
  const auto parts = ship.parts();
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}
inline btRigidBody& bodyOf(Scene& scene) { return scene.sphere->body(); }
inline double heaveOf(const Scene& scene) { return scene.sphere->motion()[Heave]; }
// Of a place of some metres, kept by a float for some hundred ticks.
inline constexpr double kStill = 1e4 * kEpsilon;

inline Vec6 one(int mode, double value) {
  Vec6 v = Vec6::Zero();
  v[mode] = value;
  return v;
}

inline SeaState waves() {
  return SeaState({{.omega = 0.9, .amplitude = 0.4, .phase = 0.3, .heading = 2.0},
                   {.omega = 1.3, .amplitude = 0.2, .phase = 1.3, .heading = 2.6}},
                  kSphereGravity, 2.0);
}

inline bool sameBits(const btRigidBody& a, const btRigidBody& b) {
  const auto same = [](const btVector3& u, const btVector3& v) {
    return std::memcmp(u.m_floats, v.m_floats, 3 * sizeof(btScalar)) == 0;
  };
  bool all = same(a.getLinearVelocity(), b.getLinearVelocity()) &&
             same(a.getAngularVelocity(), b.getAngularVelocity()) &&
             same(a.getWorldTransform().getOrigin(), b.getWorldTransform().getOrigin());
  for (int i = 0; i < 3; ++i) {
    all = all && same(a.getWorldTransform().getBasis()[i], b.getWorldTransform().getBasis()[i]);
  }
  return all;
}

}  // namespace cutwater::test
