// What a ship carries: a load that hangs from it, one that stands on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr double kLoad = 2000.0;  // [kg]

// The half sphere with a flat deck 4 m above G, at rest with a load at a place about G.
struct Carrier {
  Carrier(const Vec3& place, int iterations) : coefficients(hemisphere()), seaway(world.world) {
    world.world.getSolverInfo().m_numIterations = iterations;
    world.world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    world.world.getSolverInfo().m_linearSlop = btScalar(0.002);
    const double weight = kLoad * kSphereGravity;
    const Mat6& stiffness = coefficients.ship.restoring;
    expected[Heave] = -weight / stiffness(Heave, Heave);
    expected[Roll] = -weight * place.y() / (stiffness(Roll, Roll) - weight * place.z());
    ShipSettings settings;
    settings.start.offset = expected;
    settings.collision.shape = &deck;
    ship = &seaway.addShip(coefficients, settings);
    ship->body().setFriction(1);
  }
  ~Carrier() {
    if (joint) world.world.removeConstraint(joint.get());
    world.world.removeRigidBody(load.get());
  }
  void add(const btTransform& pose, bool touches) {
    btVector3 inertia;
    box.calculateLocalInertia(btScalar(kLoad), inertia);
    load = std::make_unique<btRigidBody>(btScalar(kLoad), nullptr, &box, inertia);
    load->setCenterOfMassTransform(pose);
    load->setFriction(btScalar(0.5));
    load->setActivationState(DISABLE_DEACTIVATION);
    world.world.addRigidBody(load.get(), touches ? -1 : 0, touches ? -1 : 0);
  }
  void hang(const Vec3& head) {
    const btVector3 at = ship->body().getWorldTransform() * toBullet(head), rope(0, 0, 3);
    add(btTransform(btQuaternion::getIdentity(), at - rope), false);
    joint = std::make_unique<btPoint2PointConstraint>(ship->body(), *load, toBullet(head), rope);
    world.world.addConstraint(joint.get(), true);
  }
  void stand(const Vec3& place) {
    add(ship->body().getWorldTransform() *
            btTransform(btQuaternion::getIdentity(), toBullet(place)),
        true);
  }
  // Mean motion over half a minute less the expected one, of that.
  double error(int mode, int perCall) {
    double sum = 0.0;
    const int ticks = 1920;
    for (int i = 0; i < ticks; i += perCall) {
      world.world.stepSimulation(kTick * static_cast<btScalar>(perCall), perCall, kTick);
      sum += ship->motion()[mode] * perCall / ticks;
    }
    return std::abs(sum / expected[mode] - 1.0);
  }

  TestWorld world{kSphereGravity};
  btBoxShape deck{btVector3(5, 5, 4)}, box{btVector3(1, 1, btScalar(0.5))};
  Coefficients coefficients;
  Seaway seaway;
  Vec6 expected = Vec6::Zero();
  Ship* ship = nullptr;
  std::unique_ptr<btRigidBody> load;
  std::unique_ptr<btTypedConstraint> joint;
};

// 1e-3: C is linear, the heel's square is 2e-4; and the box sinks into the deck by the slop of 2 mm
// in 4.5 m.
TEST(CarriedLoadClosedForm, HeelAndSinkageAreThoseOfItsWeight) {
  const Vec3 head(0.0, 4.0, 6.0), place(0.0, 3.0, 4.5);
  double hanging = 0.0, standing = 0.0;
  for (const int iterations : {10, 50}) {
    for (const int perCall : {1, 2, 4}) {
      for (const int mode : {int(Heave), int(Roll)}) {
        Carrier crane(head, iterations), cargo(place, iterations);
        crane.hang(head);
        cargo.stand(place);
        hanging = std::max(hanging, crane.error(mode, perCall));
        standing = std::max(standing, cargo.error(mode, perCall));
        const btVector3 at =
            cargo.ship->body().getWorldTransform().invXform(cargo.load->getCenterOfMassPosition());
        EXPECT_NEAR(static_cast<double>(at.y()), 3.0, 1e-3);  // it has not slid
        EXPECT_EQ(crane.seaway.faults() | cargo.seaway.faults(), kStepOk);
      }
    }
  }
  EXPECT_LT(hanging, 1e-3);
  EXPECT_LT(standing, 1e-3);
  recordResult("Plugin",
               withPrecision("load hangs from half sphere: heel, sinkage, relative error"),
               "W y/(C44 - W z), W/C33", hanging, "1e-3");
  recordResult("Plugin", withPrecision("load stands on half sphere: heel, sinkage, relative error"),
               "W y/(C44 - W z), W/C33", standing, "1e-3");
}

}  // namespace
}  // namespace cutwater::test
