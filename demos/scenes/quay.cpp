// A ship drifts at 0.3 m/s sideways onto the two fenders of a quay: quay DATABASE.h5 [OUT.csv]
// Look for: the blow is that of (m + A22)v, a third more than the ship's own mv. What the fenders
// take in all is the momentum of ship and water. The ship drifts off at an eighth of its speed, and
// energy never rises. Drag is off: the momentum that it takes would not be missed.
#include <algorithm>

#include "demos/scenes/DemoShip.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kSpeed = 0.3;

// What the solver's contacts gave the fenders in the tick [N s], along −y.
double contactImpulse(btDispatcher& dispatcher) {
  double sum = 0.0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      sum += std::abs(static_cast<double>(point.getAppliedImpulse() * point.m_normalWorldOnB.y()));
    }
  }
  return sum;
}

bool run(const Coefficients& database, DemoTable& table) {
  Coefficients frigate = database;
  frigate.ship.supplementary = {};
  BulletWorld bullet(frigate.ship.gravity);
  bullet.world.getSolverInfo().m_numIterations = 50;
  Seaway calm(bullet.world);
  btBoxShape side(btVector3(60, 7, 4));
  ShipSettings settings;
  settings.collision.shape = &side;
  settings.start.velocity[Sway] = -kSpeed;
  settings.model.resistance = false;
  settings.model.restrained[Yaw] = true;  // else one end is there first
  Ship& ship = calm.addShip(frigate, settings);
  ship.body().setFriction(0);

  // Fenders at the height of G, half a metre off the ship's side.
  btSphereShape round(1);
  btRigidBody fore(0, nullptr, &round), aft(0, nullptr, &round);
  for (btRigidBody* fender : {&fore, &aft}) {
    const btScalar x = fender == &fore ? 30 : -30;
    fender->setWorldTransform(btTransform(
        btQuaternion::getIdentity(), btVector3(x, btScalar(-8.5), btScalar(frigate.ship.cog.z()))));
    bullet.world.addRigidBody(fender);
  }
  const double mass = frigate.ship.mass, own = mass * kSpeed;
  double first = 0.0, energyAtFirst = 0.0;
  double taken = 0.0, water = 0.0, most = 0.0, off = 0.0, before = 0.0, blow = 0.0;
  for (int i = 0; i < 120 * 64; ++i) {
    const double speed = -ship.velocity()[Sway];
    bullet.world.stepSimulation(kTick, 1, kTick);
    const double now = contactImpulse(bullet.dispatcher);
    if (taken == 0.0) before = speed;
    taken += now;
    water -= kTick * ship.load("radiation")[Sway];
    if (blow == 0.0 && taken > 0.0 && ship.velocity()[Sway] > -0.01 * before) blow = taken;
    if (i == 0) {  // now the water's momentum is known: the ship has long drifted at this speed
      first = -ship.momentum()[Sway];
      energyAtFirst = ship.energy();
    }
    most = std::max(most, ship.energy() / energyAtFirst);
    off = std::max(off, std::abs(-ship.momentum()[Sway] + taken - first) / first);
    if (i % 4 == 0) {
      table.row({calm.time(), ship.position().y(), ship.velocity()[Sway],
                 ship.attitude().x() * 180.0 / kPi, taken / own, water / own,
                 -ship.momentum()[Sway] / own, ship.energy() / energyAtFirst});
    }
  }
  // The ship also rolls a little, so that a blow at G moves not quite m + A22.
  const Eigen::Matrix<double, 5, 5> inverse =
      (frigate.ship.massMatrix() + frigate.addedMass.atInfinity).topLeftCorner<5, 5>().inverse();
  bool good = calm.faults() == kStepOk;
  good &= agrees("blow / m v", blow / mass / before, 1.0 / inverse(Sway, Sway) / mass, 0.02);
  good &= isBelow("momentum lost between ship, water and fenders", off, 1e-4);
  good &= isBelow("energy at most, of that at first", most, 1.0);
  // What the fenders gave beyond the momentum at first, over the speed at which the ship drifts
  // off: by then the water moves with it, as it did at first.
  good &= agrees("momentum when it leaves / m v", (taken - first) / mass / ship.velocity()[Sway],
                 1.0 + frigate.addedMass.atZero(Sway, Sway) / mass, 0.02);
  good &= isBelow("speed when it leaves, of that before", ship.velocity()[Sway] / kSpeed, 1.0);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "quay", "t,y,sway_speed,roll_deg,taken,from_water,momentum,energy",
                  run);
}
