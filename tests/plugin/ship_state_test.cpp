// What one does to a ship: saving, placing, holding, breaking.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "plugin/Ship.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

TEST(Ship, SnapshotAndRestoreGiveTheSameBits) {
  Scene scene({.start = {.offset = one(Heave, 0.5)}}, waves());
  scene.run(100);
  scene.sphere->body().applyCentralImpulse(btVector3(1e5, 2e4, 0));  // not yet met by the solver
  const Seaway::Snapshot saved = scene.seaway.save();
  scene.run(150);
  Scene twin({.start = {.x = 900, .heading = 2.0}}, waves());
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

// 1/60 s is another number in single precision; both memories go on from a state that was made
// by ticks of it, in a ship that was prepared for it and has not ticked.
TEST(Ship, PreparedForATickItTakesAStateOfSuchTicks) {
  const auto tick = static_cast<btScalar>(1.0 / 60.0);
  for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
    const ShipSettings settings{.start = {.offset = one(Heave, 0.5)}, .model = {.memory = memory}};
    Scene scene(settings), twin(settings);
    scene.run(50, tick);
    const Seaway::Snapshot saved = scene.seaway.save();
    twin.seaway.prepare(1.0 / 60.0);
    ASSERT_NO_THROW(twin.seaway.restore(saved));
    scene.run(50, tick);
    twin.run(50, tick);
    EXPECT_TRUE(sameBits(scene.sphere->body(), twin.sphere->body()));
    EXPECT_EQ(twin.seaway.faults(), kStepOk);
  }
}

TEST(Ship, PlacedElsewhereItIsAtRestThere) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}});
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
  const ShipStart start{.x = 3, .heading = 0.2};
  Scene free({.start = start, .model = {.mean = Mean::Fixed}}, sea),
      tied({.start = start, .model = {.mean = Mean::Fixed, .restrained = held}}, sea);
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
  Scene made({.start = {.x = 4, .y = 5, .offset = one(Heave, 1.0)}});
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

TEST(Ship, AnotherTickLengthRestartsTheConvolutionAndSaysSo) {
  for (const MemoryModel memory : {MemoryModel::Exponential, MemoryModel::Convolution}) {
    Scene scene({.start = {.offset = one(Heave, 1.0)}, .model = {.memory = memory}});
    scene.run(10);
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
    scene.run(10, btScalar(1) / 50);
    EXPECT_EQ(scene.seaway.faults(),
              memory == MemoryModel::Convolution ? kTickLengthChanged : kStepOk);
  }
}

/// Heave after `duration` s from 1 m, with ticks that `next(i)` gives.
template <class Next>
double heaveAfter(double duration, Next next) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}});
  double time = 0.0;
  for (int i = 0; time < duration - 1e-9; ++i) {
    const double step = std::min(next(i), duration - time);
    scene.run(1, static_cast<btScalar>(step));
    time += step;
  }
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  return scene.sphere->motion()[Heave];
}

// The radiated waves' memory goes on through ticks of any lengths: a dropped sphere comes back as
// with equal ticks. Without memory at each change it would be back at 0.98 m. Bounds are the
// scheme's: second order in the ticks but for the start, which is half a tick early and has a
// speed of 1 m/s at most; ω = 1.1 rad/s.
TEST(Ship, TicksOfAnyLengthKeepTheMemory) {
  for (const double time : {3.0, 5.7, 8.5}) {
    SCOPED_TRACE(time);
    const double fixed = heaveAfter(time, [](int) { return 1.0 / 60.0; });
    const auto within = [&](double found, double longest) {
      EXPECT_NEAR(found, fixed, 0.5 * (longest + 1.0 / 60.0) * 1.1 + longest * longest) << longest;
    };
    const auto jitter = [&](double share) {
      return heaveAfter(time, [&](int i) { return (1.0 + share * std::sin(7.0 * i)) / 60.0; });
    };
    EXPECT_NEAR(jitter(0.01), fixed, 1e-3);
    EXPECT_NEAR(jitter(0.1), fixed, 5e-3);
    within(heaveAfter(time, [](int) { return 0.001; }), 0.001);
    within(heaveAfter(time, [](int i) { return i % 3 == 0   ? 0.001
                                               : i % 3 == 1 ? 0.1
                                                            : 0.02; }),
           0.1);
    within(heaveAfter(time, [](int i) { return i == 60 ? 0.2 : 1.0 / 60.0; }), 0.2);
  }
}

// Bullet takes a negative tick with its substeps switched off. Nothing of ours goes backwards.
TEST(Ship, ATickThatIsNotPositivePassesWithoutLoads) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}});
  scene.run(30);
  const double heave = scene.sphere->motion()[Heave];
  scene.world.world.stepSimulation(btScalar(-0.01), 0);
  EXPECT_EQ(scene.seaway.faults(), kTickNotPositive);
  scene.seaway.clearFaults();
  EXPECT_NEAR(scene.sphere->motion()[Heave], heave, 0.02);
  scene.world.world.stepSimulation(btScalar(0), 0);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);  // Bullet makes no tick of it
  scene.run(600);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  EXPECT_LT(std::abs(scene.sphere->motion()[Heave]), 0.05);
}

// The shape of a slender hull reaches as far as the hull itself, plus Bullet's margin.
TEST(Ship, CollidesOnTheConvexHullOfItsOwnMesh) {
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
  const Vec3 margin = Vec3::Constant(0.08);  // Bullet counts its 4 cm twice in a box
  EXPECT_LT((fromBullet(low) - (Vec3(-60, -7, -5 + 2) - margin)).norm(), 0.01);
  EXPECT_LT((fromBullet(high) - (Vec3(60, 7, 5 + 2) + margin)).norm(), 0.01);
}

TEST(Ship, WithoutHullOrShapeItIsRefused) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world);
  const Coefficients coefficients = hemisphere();
  EXPECT_THROW(seaway.addShip(coefficients), HydroError);
}

}  // namespace
}  // namespace cutwater::test
