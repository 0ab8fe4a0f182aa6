#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <functional>
#include <limits>

#include "hydro/Errors.h"
#include "plugin/AddedMassConstraint.h"
#include "plugin/WorldHook.h"
#include "tests/plugin/TestWorld.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

using Info = btRigidBody::btRigidBodyConstructionInfo;

constexpr btScalar kTick = btScalar(1) / 64;
constexpr double kH = 1.0 / 64;

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

// A frigate, and a boat of a tenth of her length.
struct Size {
  double length, mass;
  Vec3 inertia;
};
const Size kFrigate{100.0, 4.0e6, {1.4e8, 3.3e9, 3.4e9}};
const Size kBoat{10.0, 4.0e3, {1.4e3, 3.3e4, 3.4e4}};

Mat6 shipMass(const Size& ship = kFrigate) {
  Vec6 diagonal;
  diagonal << Vec3::Constant(ship.mass), ship.inertia;
  return diagonal.asDiagonal();
}

Info shipInfo(btCollisionShape& shape, const Size& ship = kFrigate) {
  return {static_cast<btScalar>(ship.mass), nullptr, &shape, toBullet(ship.inertia)};
}

btTransform someAttitude() {
  return btTransform(btQuaternion(btVector3(1, -2, 3).normalized(), btScalar(0.7)),
                     btVector3(3, -5, 2));
}

// Length of a velocity in the metric of M: metres and radians made one.
double size(const Mat6& mass, const Vec6& v) { return std::sqrt(v.dot(mass * v)); }

// One pass over M-orthogonal rows is exact, so all that is left is rounding: of Bullet's stored
// velocity and products, a few dozen operations. √51 is the spread of the response between l = 0.01
// and 50, which is how much more the largest direction's rounding weighs in the smallest one.
const double kRounding = 50.0 * std::sqrt(51.0) * kEpsilon;

TEST(AddedMassConstraintClosedForm, FreeBodyRespondsToAForceAsMassPlusAddedMassDo) {
  std::mt19937 random(7);
  btSphereShape shape(1);
  double worst = 0.0;
  for (int sample = 0; sample < 40; ++sample) {
    TestWorld world;
    Vec6 ratios;
    for (int r = 0; r < 6; ++r) ratios[r] = 0.01 * std::pow(5000.0, (r + sample % 3) / 7.0);
    const Mat6 added = randomAddedMass(shipMass(), ratios, random);
    Rig rig(world, shipInfo(shape), added, someAttitude());
    const Mat6 mass = inEarth(shipMass(), rig.body);
    const Vec6 force = turning(rig.body) * (shipMass().cwiseSqrt() * randomVector(random)) * 1e3;
    rig.body.applyCentralForce(toBullet(0.4 * force.head<3>()));
    rig.body.applyTorque(toBullet(0.4 * force.tail<3>()));
    rig.load = [&] {
      rig.body.applyCentralImpulse(toBullet(0.6 * kH * force.head<3>()));
      rig.body.applyTorqueImpulse(toBullet(0.6 * kH * force.tail<3>()));
    };
    const Vec6 expected = (mass + inEarth(added, rig.body)).partialPivLu().solve(force) * kH;
    rig.tick();
    const double error = size(mass, velocityOf(rig.body) - expected) / size(mass, expected);
    worst = std::max(worst, error);
  }
  EXPECT_LT(worst, kRounding);
  recordResult("Plugin", withPrecision("free response, l = 0.01..50, relative error"),
               "(M+A)^-1 F dt", worst, kDouble ? "1e-13" : "5e-5");
}

TEST(AddedMassConstraintClosedForm, ABlowBetweenTicksMovesMassPlusAddedMass) {
  std::mt19937 random(8);
  btSphereShape shape(1);
  TestWorld world;
  const Mat6 added = randomAddedMass(shipMass(), Vec6(0.1, 0.5, 1, 2, 4, 20), random);
  Rig rig(world, shipInfo(shape), added, someAttitude());
  rig.tick();
  const Vec6 blow = turning(rig.body) * (shipMass().cwiseSqrt() * randomVector(random)) * 10.0;
  rig.body.applyCentralImpulse(toBullet(blow.head<3>()));
  rig.body.applyTorqueImpulse(toBullet(blow.tail<3>()));
  const Mat6 mass = inEarth(shipMass(), rig.body);
  const Vec6 expected = (mass + inEarth(added, rig.body)).partialPivLu().solve(blow);
  rig.tick();
  const double error = size(mass, velocityOf(rig.body) - expected) / size(mass, expected);
  EXPECT_LT(error, kRounding);
  recordResult("Plugin", withPrecision("a user's impulse between ticks, relative error"),
               "(M+A)^-1 P", error, kDouble ? "1e-13" : "5e-5");
}

TEST(AddedMassConstraintClosedForm, ReportsTheForceItApplied) {
  std::mt19937 random(9);
  btSphereShape shape(1);
  TestWorld world;
  const Mat6 added = randomAddedMass(shipMass(), Vec6(0.1, 0.5, 1, 2, 4, 20), random);
  Rig rig(world, shipInfo(shape), added, someAttitude());
  const Mat6 addedInEarth = inEarth(added, rig.body);
  const Mat6 response = inEarth(shipMass(), rig.body).inverse();
  rig.body.applyCentralForce(btVector3(4e5, -2e5, 1e5));
  rig.tick();
  const Vec6 expected = -addedInEarth * velocityOf(rig.body) / kH;
  Vec6 force;
  force << rig.constraint->force(), rig.constraint->moment();
  // The difference of (1 + κ) and κ times an impulse, κ ≤ 1.8 here, beside the rounding above.
  EXPECT_LT(size(response, force - expected) / size(response, expected), 5 * kRounding);
}

// No force, no change: whatever rounding there is must not add up. 600 s at 64 Hz.
TEST(AddedMassConstraintIdentity, CoastingForTenMinutesLosesNothing) {
  std::mt19937 random(10);
  btSphereShape shape(1);
  TestWorld world;
  Rig rig(world, shipInfo(shape),
          randomAddedMass(shipMass(), Vec6(0.01, 0.3, 1, 2, 10, 50), random), someAttitude());
  const btVector3 start(btScalar(8.1), btScalar(-5.3), btScalar(2.5));
  rig.body.setLinearVelocity(start);
  rig.constraint->forgetPast();
  rig.tick(600 * 64);
  EXPECT_EQ(rig.body.getLinearVelocity(), start);
  EXPECT_EQ(rig.body.getAngularVelocity(), btVector3(0, 0, 0));
  recordResult("Plugin", withPrecision("coasting 600 s at 10 m/s, change of velocity [m/s]"), "0",
               static_cast<double>((rig.body.getLinearVelocity() - start).length()), "0");
}

// Euler's equations act on M + A∞ like any load; Bullet's implicit gyroscopic step is the load
// here.
TEST(AddedMassConstraintIdentity, GyroscopicTorqueMovesMassPlusAddedMass) {
  btSphereShape shape(1);
  TestWorld world;
  const Mat6 added = Vec6(0, 0, 0, 1.4e8, 1e9, 2e9).asDiagonal();
  Rig rig(world, shipInfo(shape), added);
  rig.body.setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);  // Bullet's default
  const btVector3 spin(btScalar(0.3), btScalar(0.2), btScalar(-0.4));
  rig.body.setAngularVelocity(spin);
  rig.constraint->forgetPast();
  const Vec3 gyro = fromBullet(rig.body.computeGyroscopicImpulseImplicit_Body(kTick));
  rig.tick();
  const Vec3 change = fromBullet(rig.body.getAngularVelocity() - spin);
  const Vec3 expected(gyro.x() / 2.0, gyro.y() * 3.3 / 4.3, gyro.z() * 3.4 / 5.4);
  // Rounding of the spin itself, 0.5 rad/s, in a change of some 1e-3 rad/s.
  EXPECT_LT((change - expected).norm(), 10 * kEpsilon);
  EXPECT_GT(expected.norm(), 1e-4);
}

// A body of mass m with added mass a = l m runs into a resting one of mass m, no restitution:
// momentum (m + a) v is shared by 2m + a.
double collisionError(double l, int iterations, int mode = -1) {
  TestWorld world;
  world.world.getSolverInfo().m_numIterations = iterations;
  world.world.getSolverInfo().m_erp2 = 0;  // Bullet's push out of the overlap would add velocity
  if (mode >= 0) world.world.getSolverInfo().m_solverMode = mode;
  btSphereShape sphere(1);
  const Info info(1000, nullptr, &sphere, btVector3(400, 400, 400));
  const Mat6 added = Vec6(1000 * l, 1000 * l, 1000 * l, 0.0, 0.0, 0.0).asDiagonal();
  Rig rig(world, info, added);
  btRigidBody other(info);
  other.setCenterOfMassTransform(
      btTransform(btQuaternion::getIdentity(), btVector3(btScalar(2.05), 0, 0)));
  other.setActivationState(DISABLE_DEACTIVATION);
  world.world.addRigidBody(&other);
  rig.body.setLinearVelocity(btVector3(1, 0, 0));
  rig.constraint->forgetPast();
  rig.tick(32);
  world.world.removeRigidBody(&other);
  const double expected = (1.0 + l) / (2.0 + l);
  return std::max(std::abs(static_cast<double>(rig.body.getLinearVelocity().x()) - expected),
                  std::abs(static_cast<double>(other.getLinearVelocity().x()) - expected)) /
         expected;
}

TEST(AddedMassConstraintClosedForm, CollisionSharesTheMomentumOfMassPlusAddedMass) {
  // Sweeps against an equal mass contract the error by l/(2(1+l)) < 1/2 each: 2⁻¹⁰ at l = ∞, and
  // 4⁻¹⁰ = 1e-6 at l = 1.
  const double error = collisionError(1.0, 10);
  EXPECT_LT(error, 1e-4);
  recordResult("Plugin",
               withPrecision("collision with added mass m, 10 iterations, relative error"),
               "(m+a)/(2m+a)", error, "1e-4");
  EXPECT_LT(collisionError(0.1, 10), 1e-4);
  EXPECT_LT(collisionError(3.0, 20), 1e-4);
}

TEST(AddedMassConstraintClosedForm, CollisionIsTheSameInEverySolverMode) {
  for (const int mode :
       {0, int(SOLVER_SIMD), SOLVER_USE_WARMSTARTING | SOLVER_SIMD,
        SOLVER_RANDMIZE_ORDER | SOLVER_USE_WARMSTARTING,
        SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS}) {
    EXPECT_LT(collisionError(1.0, 10, mode), 1e-4) << "solver mode " << mode;
  }
}

Mat3 crossing(const Vec3& r) {
  Mat3 m;
  m << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return m;
}

// Two bodies, the first with added mass, held together by J v = 0:  (M + A) dv = P + Jᵀλ.
Vec6 pairResponse(const Mat6& first, const Mat6& second, const Eigen::MatrixXd& j,
                  const Vec6& impulse) {
  const Eigen::Index n = 12 + j.rows();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
  system.topLeftCorner<6, 6>() = first;
  system.block<6, 6>(6, 6) = second;
  system.bottomLeftCorner(j.rows(), 12) = j;
  system.topRightCorner(12, j.rows()) = j.transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  right.head<6>() = impulse;
  return system.partialPivLu().solve(right).head<6>();
}

// Relative error of the ship's response to a blow when held to a second body as large as herself;
// `axis` zero: joined at a point only.
double joinedError(std::mt19937& random, const Size& ship, const Vec3& axis) {
  btSphereShape shape(1);
  TestWorld world;
  const Mat6 added = randomAddedMass(shipMass(ship), Vec6(0.05, 0.2, 0.5, 0.8, 1, 1.5), random);
  Rig rig(world, shipInfo(shape, ship), added, someAttitude());
  btRigidBody barge(shipInfo(shape, ship));
  const auto length = static_cast<btScalar>(ship.length);
  const btVector3 away = length * btVector3(btScalar(0.6), btScalar(0.2), 0);
  barge.setCenterOfMassTransform(
      btTransform(someAttitude().getRotation(), someAttitude().getOrigin() + away));
  barge.setFlags(0);
  world.world.addRigidBody(&barge);
  const btVector3 pivot =
      someAttitude().getOrigin() + btScalar(0.5) * away + btVector3(0, 0, length * btScalar(0.04));
  const btTransform toShip = rig.body.getWorldTransform().inverse();
  const btTransform toBarge = barge.getWorldTransform().inverse();
  std::unique_ptr<btTypedConstraint> joint;
  const bool hinge = axis.norm() > 0.0;
  if (hinge) {
    joint = std::make_unique<btHingeConstraint>(rig.body, barge, toShip * pivot, toBarge * pivot,
                                                toShip.getBasis() * toBullet(axis),
                                                toBarge.getBasis() * toBullet(axis));
  } else {
    joint =
        std::make_unique<btPoint2PointConstraint>(rig.body, barge, toShip * pivot, toBarge * pivot);
  }
  world.world.addConstraint(joint.get(), true);
  world.world.getSolverInfo().m_numIterations = 100;

  Eigen::MatrixXd j(hinge ? 5 : 3, 12);
  j.topRows<3>() << Mat3::Identity(),
      -crossing(fromBullet(pivot - rig.body.getCenterOfMassPosition())), -Mat3::Identity(),
      crossing(fromBullet(pivot - barge.getCenterOfMassPosition()));
  if (hinge) {
    const Vec3 across = axis.unitOrthogonal();
    Eigen::Matrix<double, 2, 3> both;
    both << across.transpose(), axis.cross(across).transpose();
    j.bottomRows<2>() << Eigen::Matrix<double, 2, 3>::Zero(), both,
        Eigen::Matrix<double, 2, 3>::Zero(), -both;
  }
  const Mat6 mass = inEarth(shipMass(ship), rig.body);
  const Vec6 blow = turning(rig.body) * (shipMass(ship).cwiseSqrt() * randomVector(random)) *
                    std::sqrt(ship.mass);  // some 1 m/s
  rig.load = [&] {
    rig.body.applyCentralImpulse(toBullet(blow.head<3>()));
    rig.body.applyTorqueImpulse(toBullet(blow.tail<3>()));
  };
  const Vec6 expected =
      pairResponse(mass + inEarth(added, rig.body), inEarth(shipMass(ship), barge), j, blow);
  rig.tick();
  world.world.removeConstraint(joint.get());
  world.world.removeRigidBody(&barge);
  return size(mass, velocityOf(rig.body) - expected) / size(mass, expected);
}

// Bullet gives up a joint's row when 1/m_1 + r²/I_1 + … is below its epsilon, 1.2e-7 in single
// precision: the two rows that keep a hinge's axes parallel, 1/I_1 + 1/I_2, do nothing between
// ships.
TEST(AddedMassConstraintClosedForm, JoinedShipAcceleratesAsTheTwoBodyMatrixSays) {
  std::mt19937 random(11);
  double point = 0.0, hinge = 0.0, boat = 0.0;
  for (int sample = 0; sample < 10; ++sample) {
    const Vec3 axis = randomVector(random).head<3>().normalized();
    point = std::max(point, joinedError(random, kFrigate, Vec3::Zero()));
    if (kDouble) hinge = std::max(hinge, joinedError(random, kFrigate, axis));
    boat = std::max(boat, joinedError(random, kBoat, axis));
  }
  EXPECT_LT(point, 1e-3);  // the bound; what is left is Gauss-Seidel's, at 100 sweeps
  EXPECT_LT(hinge, 1e-3);
  EXPECT_LT(boat, 1e-3);
  recordResult("Plugin", withPrecision("frigate held at a point, response, relative error"),
               "two-body matrix", point, "1e-3");
  if (kDouble) {
    recordResult("Plugin", withPrecision("frigate hinged to another, response, relative error"),
                 "two-body matrix", hinge, "1e-3");
  }
  recordResult("Plugin", withPrecision("boat hinged to another, response, relative error"),
               "two-body matrix", boat, "1e-3");
}

TEST(AddedMassConstraint, IterationsForToleranceBringContactWithAHeavyPartnerWithinIt) {
  btSphereShape sphere(1);
  const Info info(1000, nullptr, &sphere, btVector3(400, 400, 400));
  const double l = 3.0;
  const Mat6 added = Vec6(1000 * l, 1000 * l, 1000 * l, 0.0, 0.0, 0.0).asDiagonal();
  for (const double tolerance : {0.05, 1e-3}) {
    TestWorld world;
    Rig rig(world, info, added);
    world.world.getSolverInfo().m_numIterations = rig.constraint->iterationsFor(tolerance);
    world.world.getSolverInfo().m_erp2 = 0;
    btRigidBody heavy(Info{50000, nullptr, &sphere, btVector3(20000, 20000, 20000)});
    heavy.setCenterOfMassTransform(
        btTransform(btQuaternion::getIdentity(), btVector3(btScalar(2.05), 0, 0)));
    world.world.addRigidBody(&heavy);
    rig.body.setLinearVelocity(btVector3(1, 0, 0));
    rig.constraint->forgetPast();
    rig.tick(16);
    const double expected = (1.0 + l) / (51.0 + l);  // of both
    // The error is stated as a share of the ship's change of velocity, close to 1 m/s here.
    EXPECT_NEAR(static_cast<double>(rig.body.getLinearVelocity().x()), expected, tolerance);
    world.world.removeRigidBody(&heavy);
  }
}

TEST(AddedMassConstraint, RefusesAStaticBodyAndNumbersThatAreNotFinite) {
  btSphereShape sphere(1);
  btRigidBody fixed(Info{0, nullptr, &sphere, btVector3(0, 0, 0)});
  EXPECT_THROW(AddedMassConstraint(fixed, Mat6::Identity()), HydroError);
  btRigidBody body(Info{1, nullptr, &sphere, btVector3(1, 1, 1)});
  Mat6 bad = Mat6::Identity();
  bad(2, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(AddedMassConstraint(body, bad), HydroError);
}

// A solver's A∞ may have a slightly negative eigenvalue in a direction without added mass.
TEST(AddedMassConstraint, ClipsNegativeAddedMass) {
  btSphereShape sphere(1);
  TestWorld world;
  const Mat6 added = Vec6(-5.0, 0.0, 1000.0, 0.0, 0.0, 0.0).asDiagonal();
  Rig rig(world, {1000, nullptr, &sphere, btVector3(400, 400, 400)}, added);
  rig.load = [&] { rig.body.applyCentralImpulse(btVector3(100, 100, 100)); };
  rig.tick();
  const Vec3 expected(0.1, 0.1, 0.05);
  EXPECT_LT((velocityOf(rig.body).head<3>() - expected).norm(), 4 * kEpsilon);
}

}  // namespace
}  // namespace cutwater::test
