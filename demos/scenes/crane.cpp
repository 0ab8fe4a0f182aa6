// A load of 20 t swings on a rope of 10 m from a boom over the side: crane DATABASE.h5 [OUT.csv]
// Look for: the ship rolls about the angle at which its hull carries the load's weight on its arm,
// where ship and load as one have no righting lever. The load swings with the period of its rope.
// The energy of ship, water and load only falls.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kMass = 20e3, kInertia = 8e3, kRope = 10.0,
                 kDegree = kPi / 180.0;
const Vec3 kBoom(-9.0, 12.0, 14.0);  // its head, about G [m]

// Of the swinging load: T = (weight / rope) (y_load - y_head), and y_head = g(ω) T as the ship
// recoils, y_load = T/(mω²), hence 1/ω² = rope/weight·m + m g(ω).
double period(const Coefficients& frigate) {
  Vec6 athwart;
  athwart << 0.0, 1.0, 0.0, -kBoom.z(), 0.0, kBoom.x();
  const double rope = kRope + kInertia / (kMass * kRope);  // of a mathematical pendulum
  double square = frigate.ship.gravity / rope;
  const auto at = std::lower_bound(frigate.omega.begin(), frigate.omega.end(), std::sqrt(square));
  const Mat6 inertia = frigate.ship.massMatrix() +
                       frigate.addedMass[static_cast<std::size_t>(at - frigate.omega.begin())];
  for (int i = 0; i < 20; ++i) {
    const Mat6 stiffness = frigate.ship.restoring - square * inertia;
    const double recoil = athwart.dot(stiffness.inverse() * athwart);
    square = 1.0 / (rope / frigate.ship.gravity + kMass * recoil);
  }
  return 2.0 * kPi / std::sqrt(square);
}

bool run(const Coefficients& frigate, DemoTable& table) {
  const double gravity = frigate.ship.gravity;
  BulletWorld bullet(gravity);
  bullet.world.getSolverInfo().m_numIterations = 50;
  Seaway calm(bullet.world);
  const Vec6 expected = carrying(frigate.ship, kMass, kBoom);
  ShipSettings settings;
  settings.start.offset = expected;
  Ship& ship = calm.addShip(frigate, settings);

  // The load, a ball of 1 m, pulled out by 6 degrees and let go; the rope is a point joint.
  const btVector3 head = toBullet(kBoom);
  const btVector3 at = ship.body().getWorldTransform() * head;
  const double angle = 6.0 * kDegree;
  btSphereShape ball(1);
  btRigidBody load(btScalar(kMass), nullptr, &ball, btVector3(kInertia, kInertia, kInertia));
  load.setCenterOfMassTransform(
      btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(angle)),
                  at + toBullet(kRope * Vec3(0.0, std::sin(angle), -std::cos(angle)))));
  load.setActivationState(DISABLE_DEACTIVATION);
  bullet.world.addRigidBody(&load);
  btPoint2PointConstraint rope(ship.body(), load, head, btVector3(0, 0, btScalar(kRope)));
  bullet.world.addConstraint(&rope, true);
  SceneRuns runs(table, calm, kTick, 4);
  runs.ship("ship", ship, settings);
  runs.box("load", load, {2.0, 2.0, 2.0});  // a ball, as large

  // As the ship's: at the start of a tick, by the mean of the velocities before and after it.
  const auto tick = [&] {
    const double height = double(load.getCenterOfMassPosition().z());
    btVector3 velocity = load.getLinearVelocity(), spin = load.getAngularVelocity();
    bullet.world.stepSimulation(kTick, 1, kTick);
    velocity = (velocity + load.getLinearVelocity()) / 2;
    spin = (spin + load.getAngularVelocity()) / 2;
    return ship.energy() + 0.5 * kMass * double(velocity.length2()) +
           0.5 * kInertia * double(spin.length2()) + kMass * gravity * height;
  };
  const double first = tick(), lift = kMass * gravity * kRope * (1.0 - std::cos(angle));
  double most = -1.0, stretch = 0.0, before = 1.0, begun = 0.0, ended = 0.0;
  int swings = -1, ticks = 0;
  Vec6 mean = Vec6::Zero();
  for (; calm.time() < 200.0; ++ticks) {
    const double gained = (tick() - first) / lift;
    const btVector3 hangs = load.getCenterOfMassPosition() - ship.body().getWorldTransform() * head;
    const double swung = std::atan2(double(hangs.y()), -double(hangs.z()));
    if (before < 0.0 && swung >= 0.0) {
      ended = calm.time() - kTick * swung / (swung - before);
      if (++swings == 0) begun = ended;
    }
    before = swung;
    most = std::max(most, gained);
    stretch = std::max(stretch, std::abs(double(hangs.length()) / kRope - 1.0));
    mean += ship.motion();
    table.row({calm.time(), ship.motion()[Roll] / kDegree, swung / kDegree, ship.motion()[Heave],
               gained});
  }
  mean /= ticks;
  bool good = calm.faults() == kStepOk;
  // 0.5 %: the square of the swing, 6 degrees = 0.1.
  good &= agrees("heel [deg]", mean[Roll] / kDegree, expected[Roll] / kDegree, 0.015);
  good &= agrees("sinkage [m]", -mean[Heave], -expected[Heave], 1e-4);
  good &= agrees("period of the load [s]", (ended - begun) / swings, period(frigate), 0.03);
  good &= isBelow("energy gained, of what the load was lifted by", most, 1e-6);
  good &= isBelow("rope stretched, of its length", stretch, 1e-4);
  runs.write();
  bullet.world.removeConstraint(&rope);
  bullet.world.removeRigidBody(&load);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "crane", "t,roll_deg,swing_deg,heave,energy_gained", run);
}
