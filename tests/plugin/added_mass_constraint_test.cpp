#include <gtest/gtest.h>

#include <limits>

#include "hydro/Errors.h"
#include "plugin/AddedMassConstraint.h"
#include "tests/plugin/TestRig.h"
#include "tests/support/Matrices.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

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
    const Vec6 expected = inverse(mass + inEarth(added, rig.body)) * force * kH;
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
  const Vec6 expected = inverse(mass + inEarth(added, rig.body)) * blow;
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
  const Mat6 response = inverse(inEarth(shipMass(), rig.body));
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
