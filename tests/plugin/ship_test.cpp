#include "plugin/Ship.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>

#include "hydro/forces/FrequencyResponse.h"
#include "plugin/Seaway.h"
#include "tests/plugin/TestShip.h"
#include "tests/plugin/TestWorld.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr btScalar kTick = btScalar(1) / 64;

// A half sphere in a world of its own.
struct Scene {
  explicit Scene(const ShipSettings& start = {}, SeaState sea = {},
                 Coefficients ship = hemisphere())
      : coefficients(std::move(ship)), seaway(world.world, std::move(sea)) {
    ShipSettings settings = start;
    settings.shape = &shape;
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

Vec6 one(int mode, double value) {
  Vec6 v = Vec6::Zero();
  v[mode] = value;
  return v;
}

SeaState waves() {
  return SeaState({{.omega = 0.9, .amplitude = 0.4, .phase = 0.3, .heading = 2.0},
                   {.omega = 1.3, .amplitude = 0.2, .phase = 1.3, .heading = 2.6}},
                  kSphereGravity, 2.0);
}

bool sameBits(const btRigidBody& a, const btRigidBody& b) {
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

TEST(ShipIdentity, AtRestInCalmWaterNothingMoves) {
  Scene scene({.x = 30, .y = -12, .heading = 0.7});
  const btTransform start = scene.sphere->body().getWorldTransform();
  scene.run(640);
  EXPECT_EQ(scene.sphere->body().getWorldTransform().getOrigin(), start.getOrigin());
  EXPECT_EQ(scene.sphere->body().getLinearVelocity(), btVector3(0, 0, 0));
  // A heading of 0.7 rad is not exact: the attitude about the mean course is of one rounding.
  EXPECT_LT(velocityOf(scene.sphere->body()).norm(), 10 * kEpsilon);
}

TEST(ShipClosedForm, AUsersForceMovesMassPlusAddedMass) {
  Scene scene;
  scene.sphere->body().applyCentralForce(btVector3(3e5, 0, 2e5));
  scene.run(1);
  const double m = 261800.0, displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const Vec6 v = velocityOf(scene.sphere->body());
  // Heave also carries Bullet's gravity and what cancels it, 0.15 m/s each way.
  EXPECT_NEAR(v[Surge], 3e5 / 64 / (m + 0.2732 * displaced), 2 * kEpsilon);
  EXPECT_NEAR(v[Heave], 2e5 / 64 / (m + 0.5 * displaced), 2 * kEpsilon);
}

TEST(ShipClosedForm, ABlowBetweenTicksMovesMassPlusAddedMass) {
  Scene scene;
  scene.run(3);
  scene.sphere->body().applyCentralImpulse(btVector3(2e5, 0, 0));
  scene.run(1);
  const double expected = 2e5 / (261800.0 + 0.2732 * 1000.0 * 2.0 / 3.0 * kPi * 125.0);
  EXPECT_NEAR(velocityOf(scene.sphere->body())[Surge], expected, 4 * kEpsilon);
  Scene set;
  set.run(3);
  set.sphere->resetVelocity(Vec3(0.5, 0, 0), Vec3::Zero());
  set.run(1);
  // Set, not struck: the one tick's radiation force, K(0) h v, is all that slows her.
  EXPECT_NEAR(velocityOf(set.sphere->body())[Surge], 0.5, 2e-4);
}

// M dv/dt is the sum of the parts, added mass among them, and nothing else.
TEST(ShipIdentity, PartsOfTheLoadAddUpToNewtonsLaw) {
  Scene scene({.heading = 0.4, .offset = one(Heave, 0.5)}, waves());
  scene.run(200);
  const Vec6 before = velocityOf(scene.sphere->body());
  scene.run(1);
  const ForceParts& p = scene.sphere->lastTick().forces;
  const Vec6 sum = p.gravity + p.restoring + p.froudeKrylov + p.diffraction + p.radiation +
                   p.addedMass + p.supplementary;
  const Vec3 change = (velocityOf(scene.sphere->body()) - before).head<3>();
  const Mat3 toCourse = Eigen::AngleAxisd(-0.4, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 inertial = toCourse * (261800.0 * 64.0 * change);
  // Velocities of 1 m/s are stored to ε; through m/h that is the resolution of this sum.
  EXPECT_LT((inertial - sum.head<3>()).norm(), 4 * kEpsilon * 261800.0 * 64.0);
  EXPECT_GT(p.addedMass.head<3>().norm(), 1e3);
  EXPECT_GT(p.radiation.norm(), 1e2);
  EXPECT_GT(p.diffraction.norm(), 1e2);
}

TEST(ShipIdentity, TicksPerStepSimulationDoNotMatterToTheLastBit) {
  const ShipSettings start{.heading = 0.4, .offset = one(Heave, 0.5)};
  Scene single(start, waves());
  single.run(256, kTick, 1);
  for (const int perCall : {2, 4}) {
    Scene many(start, waves());
    many.run(256, kTick, perCall);
    EXPECT_TRUE(sameBits(single.sphere->body(), many.sphere->body())) << perCall;
    EXPECT_EQ(single.seaway.time(), many.seaway.time());
  }
  recordResult("Plugin", withPrecision("1, 2, 4 ticks per stepSimulation, different bits"), "0", 0,
               "0");
}

// Height after 8 s of a sphere let go from 1 m, `start` its velocity.
double heightAfterEightSeconds(int ticksPerSecond, double start) {
  Scene scene({.offset = one(Heave, 1.0)});
  scene.sphere->resetVelocity(Vec3(0, 0, start), Vec3::Zero());
  scene.run(8 * ticksPerSecond, btScalar(1) / static_cast<btScalar>(ticksPerSecond));
  return scene.sphere->motion()[Heave];
}

// x_{n+1} = x_n + h v_{n+1} takes the velocity given at the start for that of half a tick before
// it. Where that is what it is, v(−h/2) = v(0) − a(0) h/2, the scheme is a leapfrog: second order.
// Given v(0) instead it is first order, by a shift in time of h/2, which is the engine's and
// constant.
TEST(ShipConvergence, SecondOrderInTheTickWithAConsistentStartFirstFromRest) {
  const double displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const double fall = -7.695e5 / (261800.0 + 0.5 * displaced);  // a(0)
  const auto order = [&](bool consistent) {
    double z[3];
    for (int i = 0; i < 3; ++i) {
      const int rate = (consistent ? 16 : 64) << i;
      z[i] = heightAfterEightSeconds(rate, consistent ? -0.5 * fall / rate : 0.0);
    }
    return std::log2((z[0] - z[1]) / (z[1] - z[2]));
  };
  const double second = order(true), first = order(false);
  // The next term of the error is smaller by h over the time scale of the motion, 0.35 s = 1/ω: 0.2
  // of the second-order one's square at 1/16 s, 0.05 of the first-order one at 1/64 s.
  EXPECT_NEAR(second, 2.0, 0.1);
  EXPECT_NEAR(first, 1.0, 0.1);
  recordResult("Plugin", withPrecision("order of convergence in the tick, consistent start"), "2",
               second, "1.9..2.1");
  recordResult("Plugin", withPrecision("order of convergence in the tick, start from rest"), "1",
               first, "0.9..1.1");
}

// An impulse first meets A(∞), then, its waves gone, A(0): Ogilvie's A(0) = A(∞) − ∫τK dτ as
// momentum. After that nothing slows her: ∫K dτ = 0 must hold in the sum of ticks, too.
TEST(ShipIdentity, PushedOffSheSettlesAtTheSpeedOfZeroFrequencyAddedMassAndKeepsIt) {
  Scene scene;
  scene.sphere->resetVelocity(Vec3(10, 0, 0), Vec3::Zero());
  scene.run(100 * 64);
  const double settled = scene.sphere->velocity()[0];
  const double expected = 10.0 * (1.0 + 0.2732) / (1.0 + 0.5);
  // 0.5 %: the table's grid in ω, first point Ka = 0.02.
  EXPECT_NEAR(settled, expected, 0.005 * expected);
  scene.run(600 * 64);
  const double drift = std::abs(scene.sphere->velocity()[0] - settled);
  EXPECT_LT(drift, 20 * kEpsilon);
  recordResult("Plugin", withPrecision("coasting 600 s with radiation memory, change [m/s]"), "0",
               drift, kDouble ? "4.4e-15" : "2.4e-6");
  recordResult("Plugin", withPrecision("pushed off at 10 m/s, speed kept [m/s]"),
               "8.488 = 10 (m + A(inf))/(m + A(0))", settled, "0.5 %");
}

TEST(ShipVerification, HeaveInARegularWaveIsThatOfTheFrequencyDomain) {
  const double omega = 1.2, amplitude = 0.5;
  Scene scene(
      {.x = 7.0, .y = -3.0},
      SeaState({{.omega = omega, .amplitude = amplitude, .heading = kPi}}, kSphereGravity, 10.0));
  const double periods = 4.0 * 2.0 * kPi / omega;
  scene.run(150 * 64);
  Complex sum = 0.0;
  const int samples = static_cast<int>(std::lround(periods * 64));
  for (int i = 0; i < samples; ++i) {
    const double t = scene.seaway.time();
    sum += scene.sphere->motion()[Heave] * std::exp(Complex(0, -omega * t));
    scene.run(1);
  }
  const double k = omega * omega / kSphereGravity;
  // The crest is over G's mean place, x = 7, later than over the origin of E: e^{+ikx} at β = π.
  const Complex found = 2.0 / samples * sum / (amplitude * std::exp(Complex(0, k * 7.0)));
  const Complex expected = FrequencyResponse(scene.coefficients).at(omega, kPi)[Heave];
  // The acceptance of the whole chain, 1 % and 3°; here well inside it: the window is not quite
  // four periods (0.2 %), the tick is 1/340 of one.
  EXPECT_NEAR(std::abs(found) / std::abs(expected), 1.0, 5e-3);
  EXPECT_NEAR(std::arg(found / expected), 0.0, 5e-3);
}

// The physics does not know where E's axes point.
TEST(ShipIdentity, TurnedSceneGivesTurnedMotion) {
  const double turn = 1.1;
  SeaState straight({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}}, kSphereGravity);
  SeaState turned({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0 - turn}}, kSphereGravity);
  Scene a({.offset = one(Heave, 0.5)}, straight);
  Scene b({.heading = turn, .offset = one(Heave, 0.5)}, turned);
  a.run(320);
  b.run(320);
  // Rounding of 320 ticks of positions and velocities of order one.
  EXPECT_LT((a.sphere->motion() - b.sphere->motion()).norm(), 320 * 4 * kEpsilon);
  EXPECT_GT(std::abs(a.sphere->motion()[Sway]), 1e-2);
}

TEST(Ship, SnapshotAndRestoreGiveTheSameBits) {
  Scene scene({.offset = one(Heave, 0.5)}, waves());
  scene.run(100);
  scene.sphere->body().applyCentralImpulse(btVector3(1e5, 2e4, 0));  // not yet met by the solver
  const Seaway::Snapshot saved = scene.seaway.save();
  scene.run(150);
  Scene twin({.x = 900, .heading = 2.0}, waves());
  twin.sphere->prepare(static_cast<double>(kTick));
  twin.seaway.restore(saved);
  twin.run(150);
  EXPECT_TRUE(sameBits(scene.sphere->body(), twin.sphere->body()));
  scene.sphere->placeAt(500, 20, 1.0);
  scene.run(30);
  scene.seaway.restore(saved);
  scene.run(150);
  EXPECT_TRUE(sameBits(scene.sphere->body(), twin.sphere->body()));
}

TEST(Ship, PlacedElsewhereSheIsAtRestThere) {
  Scene scene({.offset = one(Heave, 1.0)});
  scene.run(100);
  scene.sphere->placeAt(400, -300, 0.5);
  EXPECT_LT(scene.sphere->motion().norm(), 1e3 * kEpsilon);
  const btVector3 there = scene.sphere->body().getCenterOfMassPosition();
  scene.run(100);
  EXPECT_EQ(scene.sphere->body().getCenterOfMassPosition(), there);
}

TEST(Ship, RestrainedModesStayAndTheOthersDoNotNotice) {
  const SeaState sea({{.omega = 1.0, .amplitude = 0.5, .heading = 2.5}}, kSphereGravity, 2.0);
  std::array<bool, 6> held{};
  held[Surge] = held[Yaw] = true;
  Scene free({.x = 3, .heading = 0.2}, sea),
      tied({.x = 3, .heading = 0.2, .restrained = held}, sea);
  double surge = 0.0, heave = 0.0;
  for (int i = 0; i < 640; ++i) {
    free.run(1);
    tied.run(1);
    surge = std::max(surge, std::abs(tied.sphere->motion()[Surge]));
    heave = std::max(heave, std::abs(tied.sphere->motion()[Heave] - free.sphere->motion()[Heave]));
  }
  EXPECT_GT(std::abs(free.sphere->motion()[Sway]), 0.01);
  EXPECT_NEAR(tied.sphere->motion()[Sway], free.sphere->motion()[Sway], 1e-4);
  // Ten sweeps of the solver leave (l/(1 + l))¹⁰ of the load's work in a tick, and the joint pulls
  // a fifth of the error back each tick.
  EXPECT_LT(surge, 1e-4);
  EXPECT_LT(heave, 1e-4);
}

TEST(Ship, TakesAUsersOwnBody) {
  TestWorld world(kSphereGravity);
  const Coefficients coefficients = hemisphere();
  btSphereShape shape(5);
  const auto inertia = static_cast<btScalar>(261800.0 * 2.5 * 2.5);
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(261800, nullptr, &shape,
                                                            btVector3(inertia, inertia, inertia)));
  body.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(4, 5, -1)));
  Seaway seaway(world.world);
  EXPECT_THROW(seaway.addShip(coefficients, body), HydroError);  // not in the world yet
  world.world.addRigidBody(&body);
  Ship& ship = seaway.addShip(coefficients, body);
  Scene made({.x = 4, .y = 5, .offset = one(Heave, 1.0)});
  made.run(100);
  for (int i = 0; i < 100; ++i) world.world.stepSimulation(kTick, 1, kTick);
  EXPECT_TRUE(sameBits(body, made.sphere->body()));
  seaway.removeShip(ship);
  EXPECT_TRUE(body.isInWorld());
  world.world.removeRigidBody(&body);
  btRigidBody light(
      btRigidBody::btRigidBodyConstructionInfo(1000, nullptr, &shape, btVector3(1, 1, 1)));
  world.world.addRigidBody(&light);
  EXPECT_THROW(seaway.addShip(coefficients, light), HydroError);
  world.world.removeRigidBody(&light);
}

TEST(Ship, EulerAnglesInvertTheRotation) {
  for (const Vec3& angles : {Vec3(0.3, -0.5, 2.0), Vec3(-2.0, 0.1, -3.0), Vec3(0.1, 1.5, 0.2)}) {
    const Mat3 r =
        (Eigen::AngleAxisd(angles[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1], Vec3::UnitY()) *
         Eigen::AngleAxisd(angles[0], Vec3::UnitX()))
            .toRotationMatrix();
    EXPECT_LT((eulerAngles(r) - angles).norm(), 1e-13);
  }
  const Mat3 up = Eigen::AngleAxisd(kPi / 2, Vec3::UnitY()).toRotationMatrix();
  EXPECT_TRUE(eulerAngles(up).allFinite());
}

TEST(Ship, LoadsThatAreNotFiniteAreReportedAndNotApplied) {
  Coefficients broken = hemisphere();
  broken.ship.restoring(2, 2) = std::numeric_limits<double>::quiet_NaN();
  Scene scene({}, {}, broken);
  scene.run(2);
  EXPECT_EQ(scene.seaway.faults(), kLoadNotFinite);
  EXPECT_TRUE(velocityOf(scene.sphere->body()).allFinite());
  Scene lost;
  lost.run(2);
  lost.sphere->body().setLinearVelocity(btVector3(std::numeric_limits<btScalar>::infinity(), 0, 0));
  lost.run(1);
  EXPECT_EQ(lost.seaway.faults() & kStateNotFinite, kStateNotFinite);
  lost.seaway.clearFaults();
  EXPECT_EQ(lost.seaway.faults(), kStepOk);
}

TEST(Ship, AnotherTickLengthRestartsTheMemoryAndSaysSo) {
  Scene scene({.offset = one(Heave, 1.0)});
  scene.run(10);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  scene.run(10, btScalar(1) / 50);
  EXPECT_EQ(scene.seaway.faults(), kTickLengthChanged);
}

// The shape of a slender hull reaches as far as the hull itself, plus Bullet's margin.
TEST(Ship, CollidesOnTheConvexHullOfHerOwnMesh) {
  Coefficients slender = hemisphere();
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j < 24; ++j) {
      const double along = kPi * i / 40, around = 2 * kPi * j / 24;
      slender.ship.hull.vertices.emplace_back(60 * std::cos(along),
                                              7 * std::sin(along) * std::cos(around),
                                              5 * std::sin(along) * std::sin(around));
    }
  }
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  const Ship& ship = seaway.addShip(slender);
  btVector3 low, high;
  ship.body().getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
  const Vec3 margin = Vec3::Constant(0.04);
  EXPECT_LT((fromBullet(low) - (Vec3(-60, -7, -5 + 2) - margin)).norm(), 0.01);
  EXPECT_LT((fromBullet(high) - (Vec3(60, 7, 5 + 2) + margin)).norm(), 0.01);
}

TEST(Ship, WithoutHullOrShapeSheIsRefused) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  const Coefficients coefficients = hemisphere();
  EXPECT_THROW(seaway.addShip(coefficients), HydroError);
}

}  // namespace
}  // namespace cutwater::test
