// A floating half sphere, with the memory of radiated waves, against what does not move.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

// Momentum along y is exchanged between sphere, water and quay.
struct Drift {
  double taken = 0.0;   // by the quay [N s]
  double blow = 0.0;    // of it until the sphere has stopped
  double atBlow = 0.0;  // its speed before [m/s]
  double lost = 0.0;    // of the balance, at worst, of its momentum at first
  double energy = 0.0;  // largest over that at first
  double first = 0.0;   // (m + A22) v at first
  double left = 0.0;    // at the end
  Vec6 velocity = Vec6::Zero();
};

double contactImpulse(btDispatcher& dispatcher) {
  double sum = 0.0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      sum += static_cast<double>(manifold.getContactPoint(k).getAppliedImpulse());
    }
  }
  return sum;
}

// On a fixed course, whose momentum is (m + A∞)v and whose radiation is the water's; a free ship's
// momentum holds its waves too, and its first tick says what they were before.
Drift drift(int iterations, int ticks, double gap, int perCall = 1, Mean mean = Mean::Fixed) {
  const double speed = 0.3;
  ShipSettings settings;
  settings.model.mean = mean;
  settings.model.resistance = false;  // it takes momentum
  settings.start.velocity[Sway] = -speed;
  Scene scene(settings);
  scene.world.world.getSolverInfo().m_numIterations = iterations;
  btBoxShape wall(btVector3(50, 1, 50));
  btRigidBody quay(0, nullptr, &wall);
  quay.setWorldTransform(
      btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(-6.0 - gap), 0)));
  scene.world.world.addRigidBody(&quay);
  scene.sphere->body().setFriction(0);
  Drift result;
  if (mean == Mean::Free) scene.run(perCall, kTick, perCall);
  result.first = -scene.sphere->momentum()[Sway];
  double water = 0.0;
  for (int i = 0; i < ticks; i += perCall) {
    const double before = -scene.sphere->velocity()[Sway];
    scene.run(perCall, kTick, perCall);
    const double now = contactImpulse(scene.world.dispatcher);  // of the last tick
    if (result.taken == 0.0) result.atBlow = before;
    result.taken += now;
    if (mean == Mean::Fixed) {
      water -= static_cast<double>(kTick) * scene.sphere->load("radiation")[Sway];
    }
    const double v = -scene.sphere->velocity()[Sway], left = -scene.sphere->momentum()[Sway];
    if (result.blow == 0.0 && result.taken > 0.0 && v < 0.01 * result.atBlow) {
      result.blow = result.taken;
    }
    result.lost =
        std::max(result.lost, std::abs(left + result.taken - water - result.first) / result.first);
    result.energy = std::max(result.energy, v * v / (speed * speed));
    result.left = left;
  }
  result.velocity = velocityOf(scene.sphere->body());
  scene.world.world.removeRigidBody(&quay);
  return result;
}

// Sphere, water and quay share the momentum to round-off, once the sweeps have converged: l = 0.27,
// so that ten of them leave (l/(1 + l))^10 = 2e-7. Float sums 1900 ticks of rounding.
TEST(QuayIdentity, MomentumIsThatOfSphereWaterAndQuay) {
  for (const int iterations : {5, 10, 20, 50, 100}) {
    const Drift d = drift(iterations, 1920, 1.0);
    const double bound = iterations < 10 ? 1e-3 : kDouble && iterations > 10 ? 1e-12 : 1e-5;
    EXPECT_LT(d.lost, bound) << iterations;
    EXPECT_LT(d.energy, 1.0) << iterations;
    const Drift free = drift(iterations, 1920, 1.0, 1, Mean::Free);
    EXPECT_LT(free.lost, bound) << iterations;
    EXPECT_LE(free.energy, 1.0 + 10 * kEpsilon) << iterations;
    recordResult("Plugin",
                 withPrecision("half sphere against a quay, " + std::to_string(iterations) +
                               " iterations: momentum lost in 30 s"),
                 "0", d.lost,
                 iterations < 10              ? "1e-3"
                 : kDouble && iterations > 10 ? "1e-12"
                                              : "1e-5");
  }
}

// 2e-3: what the water gives in the ticks that the blow takes.
TEST(QuayClosedForm, TheBlowIsThatOfMassPlusAddedMass) {
  const double speed = 0.3;
  for (const double gap : {0.01, 1.0}) {
    const Drift d = drift(20, 1920, gap);
    EXPECT_NEAR(d.blow / (d.first * d.atBlow / speed), 1.0, 2e-3) << gap;
  }
  // Hardly under way when it is stopped, it has set no water in motion that comes after it. 1 m on,
  // the waves of its start have slowed it, and those of the stop push it off.
  const Drift near = drift(20, 1920, 0.01), far = drift(20, 1920, 1.0);
  EXPECT_NEAR(near.taken / near.first, 1.0, 2e-3);
  EXPECT_LT(far.left, 0.0);
  EXPECT_LT(far.left * far.left, 0.01 * far.first * far.first);
}

TEST(QuayIdentity, TicksPerCallDoNotMatterToTheLastBit) {
  const Vec6 one = drift(20, 960, 0.1, 1).velocity;
  EXPECT_EQ(drift(20, 960, 0.1, 2).velocity, one);
  EXPECT_EQ(drift(20, 960, 0.1, 4).velocity, one);
  const Vec6 free = drift(20, 960, 0.1, 1, Mean::Free).velocity;
  EXPECT_EQ(drift(20, 956, 0.1, 4, Mean::Free).velocity,
            drift(20, 959, 0.1, 1, Mean::Free).velocity);
  EXPECT_NE(free, one);
}

}  // namespace
}  // namespace cutwater::test
