// Collisions of two bodies that both have a full added mass.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <random>

#include "tests/plugin/TestRig.h"
#include "tests/support/Matrices.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

// A boat with a ball of 0.5 m somewhere on it that meets other balls.
struct Boat {
  Boat(btDiscreteDynamicsWorld& owner, const Mat6& water, const Vec3& ball, const btTransform& pose)
      : world(owner), added(water) {
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), toBullet(ball)), &fender);
    body = std::make_unique<btRigidBody>(shipInfo(shape, kBoat));
    body->setCenterOfMassTransform(pose);
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setFlags(0);
    body->setFriction(0);
    constraint = std::make_unique<AddedMassConstraint>(*body, added);
    world.addRigidBody(body.get());
    world.addConstraint(constraint.get());
  }
  ~Boat() {
    world.removeConstraint(constraint.get());
    world.removeRigidBody(body.get());
  }
  Mat6 inertia() const { return inEarth(Mat6(shipMass(kBoat) + added), *body); }

  btDiscreteDynamicsWorld& world;
  Mat6 added;
  btSphereShape fender{btScalar(0.5)};
  btCompoundShape shape;
  std::unique_ptr<btRigidBody> body;
  std::unique_ptr<AddedMassConstraint> constraint;
};

struct TwoBoats final : TickListener {
  TwoBoats(std::mt19937& random, int iterations) {
    world.world.getSolverInfo().m_numIterations = iterations;
    world.world.getSolverInfo().m_erp2 = 0;  // no push out of the overlap
    const Vec3 where[2] = {{3.0, 1.0, 0.5}, {-2.0, -1.5, 0.8}};
    normal = randomVector(random).head<3>().normalized();
    // The balls overlap by 0.1 mm, the contact is in the origin.
    for (int i = 0; i < 2; ++i) {
      const btQuaternion turn(btVector3(1, btScalar(2 - 3 * i), 3).normalized(),
                              btScalar(0.7 - 1.1 * i));
      arm[i] = (i == 0 ? 0.49995 : -0.49995) * normal;
      const btVector3 at = toBullet(arm[i]) - btTransform(turn) * toBullet(where[i]);
      const Mat6 added =
          randomAddedMass(shipMass(kBoat), Vec6(0.05, 0.2, 0.5, 0.8, 1, 1.5), random);
      boats[i] = std::make_unique<Boat>(world.world, added, where[i], btTransform(turn, at));
      arm[i] = -fromBullet(at);
      // They meet at 1 m/s.
      boats[i]->body->setLinearVelocity(toBullet(Vec3((i == 0 ? -0.7 : 0.3) * normal)));
      boats[i]->constraint->forgetPast();
    }
    hook = std::make_unique<WorldHook>(world.world, *this);
  }
  void beforeTick(btScalar step) noexcept override {
    for (auto& boat : boats) boat->constraint->beginTick(step);
  }
  void afterTick(btScalar) noexcept override {
    for (auto& boat : boats) boat->constraint->endTick();
  }
  void slotTaken() noexcept override {}
  Vec6 momentum() const {  // of both, about the origin
    Vec6 sum = Vec6::Zero();
    for (const auto& boat : boats) {
      const Vec6 p = boat->inertia() * velocityOf(*boat->body);
      const Vec3 at = fromBullet(boat->body->getCenterOfMassPosition());
      sum += p;
      sum.tail<3>() += at.cross(Vec3(p.head<3>()));
    }
    return sum;
  }
  double energy() const {
    double sum = 0.0;
    for (const auto& boat : boats) {
      const Vec6 v = velocityOf(*boat->body);
      sum += 0.5 * v.dot(boat->inertia() * v);
    }
    return sum;
  }

  TestWorld world;
  Vec3 normal, arm[2];
  std::unique_ptr<Boat> boats[2];
  std::unique_ptr<WorldHook> hook;
};

struct Errors {
  double velocity = 0.0, momentum = 0.0, energy = 0.0;
};

// v⁺ = v⁻ − (M + A)⁻¹Jᵀ (J v⁻)/(J (M + A)⁻¹ Jᵀ), J the closing speed of the two balls.
Errors collisionErrors(std::mt19937& random, int iterations) {
  TwoBoats scene(random, iterations);
  Vec6 row[2], before[2], after[2];
  double closing = 0.0, softness = 0.0, metric = 0.0;
  for (int i = 0; i < 2; ++i) {
    const Vec3 n = (i == 0 ? 1.0 : -1.0) * scene.normal;
    row[i] << n, scene.arm[i].cross(n);
    before[i] = velocityOf(*scene.boats[i]->body);
    closing += row[i].dot(before[i]);
    softness += row[i].dot(inverse(scene.boats[i]->inertia()) * row[i]);
    metric += before[i].dot(scene.boats[i]->inertia() * before[i]);
  }
  const Vec6 momentumBefore = scene.momentum();
  const double energyBefore = scene.energy(), lost = 0.5 * closing * closing / softness;
  const double scale = std::abs(closing) / softness;  // the blow [N s]
  Mat6 inertia[2];
  for (int i = 0; i < 2; ++i) {
    inertia[i] = scene.boats[i]->inertia();
    after[i] = before[i] - inverse(inertia[i]) * row[i] * closing / softness;
  }
  // Inertia and place are those of the blow: the tick's own motion is left out.
  scene.world.world.stepSimulation(kTick, 1, kTick);
  Errors errors;
  Vec6 momentumAfter = Vec6::Zero();
  double square = 0.0, energyAfter = 0.0;
  for (int i = 0; i < 2; ++i) {
    const Vec6 now = velocityOf(*scene.boats[i]->body), off = now - after[i];
    const Vec6 p = inertia[i] * now;
    square += off.dot(inertia[i] * off);
    energyAfter += 0.5 * now.dot(p);
    momentumAfter.head<3>() += p.head<3>();
    momentumAfter.tail<3>() += p.tail<3>() - scene.arm[i].cross(Vec3(p.head<3>()));
  }
  errors.velocity = std::sqrt(square / metric);
  errors.momentum = (momentumAfter - momentumBefore).norm() / scale;
  errors.energy = (energyAfter - (energyBefore - lost)) / energyBefore;
  return errors;
}

Errors worst(int iterations) {
  std::mt19937 random(5);
  Errors most;
  for (int sample = 0; sample < 20; ++sample) {
    const Errors e = collisionErrors(random, iterations);
    most.velocity = std::max(most.velocity, e.velocity);
    most.momentum = std::max(most.momentum, e.momentum);
    most.energy = std::max(most.energy, std::abs(e.energy));
  }
  return most;
}

// The sweeps contract the error at least by l/(1 + l) each, l = 1.5, faster as the other boat is no
// wall; what is left in the end is round-off: some 20 units in the last place, times arms of 3 m in
// momentum.
TEST(CollisionClosedForm, TwoBodiesPartAsMassPlusAddedMassSay) {
  const double rounding = 20.0 * kEpsilon;
  for (const int iterations : {5, 10, 20, 50, 100}) {
    const Errors e = worst(iterations);
    const double bound = iterations >= 50 ? rounding : std::pow(0.6, iterations);
    EXPECT_LT(e.velocity, bound) << iterations;
    EXPECT_LT(e.energy, bound) << iterations;
    EXPECT_LT(e.momentum, 20.0 * bound) << iterations;
    const std::string title =
        "boats collide, full A, " + std::to_string(iterations) + " iterations: ";
    const std::string limit = iterations >= 50 ? "20 ulp" : "0.6^n";
    recordResult("Plugin", withPrecision(title + "velocities, relative error"),
                 "(M+A) of both and one blow", e.velocity, limit);
    recordResult("Plugin", withPrecision(title + "momentum lost, of the blow"), "0", e.momentum,
                 "20 times " + limit);
  }
  EXPECT_LT(worst(10).velocity, 1e-3);
}

TEST(CollisionIdentity, EnergyNeverRisesAndTicksPerCallDoNotMatter) {
  Vec6 first[2];
  for (const int perCall : {1, 2, 4}) {
    std::mt19937 random(9);
    TwoBoats scene(random, 50);
    double before = scene.energy();
    const double atFirst = before;
    for (int i = 0; i < 8; i += perCall) {
      const auto ticks = static_cast<btScalar>(perCall);
      scene.world.world.stepSimulation(ticks * kTick, perCall, kTick);
      // Spinning apart, A∞ turns with the boats: second order in the angle of a tick, 1e-3.
      EXPECT_LT(scene.energy(), before + 1e-6 * atFirst) << perCall;
      before = scene.energy();
    }
    EXPECT_LT(before, 0.9 * atFirst);
    for (int i = 0; i < 2; ++i) {
      const Vec6 now = velocityOf(*scene.boats[i]->body);
      if (perCall == 1) first[i] = now;
      EXPECT_EQ(now, first[i]) << perCall;
    }
  }
}

}  // namespace
}  // namespace cutwater::test
