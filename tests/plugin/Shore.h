#pragma once
#include <cmath>
#include <memory>
#include <utility>

#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"
#include "tests/plugin/TestWorld.h"

/// A ship in calm water, and one thing that does not move: a trailer, a beach.
namespace cutwater::test {

/// Of all contacts on a body in the last tick, friction included [N s].
inline Vec3 contactImpulse(btDispatcher& dispatcher, const btCollisionObject& body) {
  btVector3 sum(0, 0, 0);
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    const btScalar sign = manifold.getBody0() == &body ? 1 : -1;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& at = manifold.getContactPoint(k);
      sum += sign * (at.m_appliedImpulse * at.m_normalWorldOnB +
                     at.m_appliedImpulseLateral1 * at.m_lateralFrictionDir1 +
                     at.m_appliedImpulseLateral2 * at.m_lateralFrictionDir2);
    }
  }
  return fromBullet(sum);
}

struct Shore {
  explicit Shore(const std::shared_ptr<const Hydrodynamics>& hydrodynamics,
                 const ShipSettings& settings, btCollisionShape* shape = nullptr,
                 const btTransform& place = btTransform::getIdentity())
      : particulars(hydrodynamics->ship()),
        world(particulars.gravity),
        seaway(world.world),
        ship(seaway.addShip(hydrodynamics, settings)) {
    world.world.getSolverInfo().m_numIterations = 50;
    world.world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    if (shape == nullptr) return;
    ground = std::make_unique<btRigidBody>(btScalar(0), nullptr, shape);
    ground->setWorldTransform(place);
    ground->setFriction(1);
    world.world.addRigidBody(ground.get());
  }
  ~Shore() {
    if (hook) world.world.removeConstraint(hook.get());
    if (ground) world.world.removeRigidBody(ground.get());
  }
  Shore(const Shore&) = delete;
  Shore& operator=(const Shore&) = delete;

  /// Hangs the ship where it is from a point above G.
  void hangFrom(double above) {
    hook = std::make_unique<btPoint2PointConstraint>(ship.body(),
                                                     btVector3(0, 0, static_cast<btScalar>(above)));
    hook->setJointFeedback(&feedback);
    hook->enableFeedback(true);
    world.world.addConstraint(hook.get());
  }
  void tick(btScalar step) { world.world.stepSimulation(step, 1, step); }
  void run(double seconds, btScalar step, int perCall = 1) {
    const double until = seaway.time() + seconds;
    while (seaway.time() < until - 0.5 * static_cast<double>(step)) {
      world.world.stepSimulation(step * static_cast<btScalar>(perCall), perCall, step);
    }
  }
  Vec3 touching() { return contactImpulse(world.dispatcher, ship.body()); }
  /// In the mean of some time [N]: what ground and hook carry, and what the water does not, with
  /// what the ship's momentum has gained.
  struct Balance {
    double carried = 0.0, lacking = 0.0;
  };
  Balance balance(double seconds, btScalar step) {
    Balance mean;
    const double before = ship.momentum()[Heave];
    const long ticks = std::lround(seconds / static_cast<double>(step));
    for (long i = 0; i < ticks; ++i) {
      tick(step);
      double carried = touching().z() / static_cast<double>(step);
      if (hook) carried += static_cast<double>(feedback.m_appliedForceBodyA.z());
      mean.carried += carried / static_cast<double>(ticks);
      mean.lacking += lacks() / static_cast<double>(ticks);
    }
    mean.lacking += (ship.momentum()[Heave] - before) / seconds;
    return mean;
  }
  double weight() const { return particulars.mass * particulars.gravity; }  ///< [N]
  /// What the water does not carry of it [N].
  double lacks() const {
    return weight() - particulars.density * particulars.gravity * ship.wetted()->volume;
  }

  ShipParticulars particulars;
  TestWorld world;
  Seaway seaway;
  Ship& ship;
  std::unique_ptr<btRigidBody> ground;
  std::unique_ptr<btPoint2PointConstraint> hook;
  btJointFeedback feedback;
};

}  // namespace cutwater::test
