// Contacts and joints of a body with added mass.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/plugin/TestRig.h"
#include "tests/support/Matrices.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

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
  return solved(system, right).topRows<6>();
}

// Relative error of the ship's response to a blow when held to a second body as large as itself;
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

}  // namespace
}  // namespace cutwater::test
