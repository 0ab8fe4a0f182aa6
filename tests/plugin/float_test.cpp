// Bodies that float by their shape: draught, attitude, period, drag, waves, other worlds.
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/forces/floats/Ellipsoid.h"
#include "plugin/Seaway.h"
#include "tests/plugin/FloatScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr double kG = kStandardGravity;

// Drag alone, as the formula has it at any speed; or no drag at all.
FloatSettings dragless() {
  FloatSettings settings;
  settings.normalDrag = settings.friction = settings.slowDrag = 0.0;
  return settings;
}

double share(const FloatScene& scene, const Float& one) {
  return 1.0 / static_cast<double>(one.body().getInvMass()) *
         scene.seaway.frame().kilogramsPerUnit / (kRho * one.volume());
}

TEST(FloatClosedForm, ABoxFloatsAtItsDraught) {
  for (const double tick : {1.0 / 240, 1.0 / 60, 1.0 / 15}) {
    FloatScene scene;
    btBoxShape box(btVector3(btScalar(1.0), btScalar(0.8), btScalar(0.4)));
    const double mass = 800.0, draught = mass / (kRho * 2.0 * 1.6);
    Float& one = scene.seaway.addFloat(scene.body(box, mass, {3.0, -2.0, 0.3}));
    scene.run(60.0, tick);
    // 1e-4 m of 0.24 m: what is left of the swing after a minute; a float's place has 1e-7 of 3 m.
    EXPECT_NEAR(0.4 - scene.place(one.body()).z(), draught, 1e-4) << tick;
    EXPECT_NEAR(one.wetVolume(), mass / kRho, 1e-4 * 3.2);  // the same times the waterplane
    EXPECT_EQ(scene.seaway.faults(), kStepOk);
    recordResult("Floats",
                 withPrecision("draught of a box of 2 x 1.6 m, tick " +
                               std::to_string(tick).substr(0, 6) + " s [m]"),
                 std::to_string(draught), 0.4 - scene.place(one.body()).z(), "1e-4 m");
  }
}

// Every shape has its volume, and floats at its share of it.
TEST(FloatClosedForm, EveryShapeHasItsVolumeAndDisplacesItsMass) {
  btSphereShape ball(btScalar(0.5));
  btCapsuleShapeX capsule(btScalar(0.3), btScalar(1.0));
  btCylinderShapeZ cylinder(btVector3(btScalar(0.4), btScalar(0.4), btScalar(0.5)));
  btConeShapeZ cone(btScalar(0.5), btScalar(0.8));
  btConvexHullShape hull;  // a wedge
  for (const double x : {-0.5, 0.5}) {
    hull.addPoint(toBullet(Vec3(x, -0.5, -0.4)));
    hull.addPoint(toBullet(Vec3(x, 0.5, -0.4)));
    hull.addPoint(toBullet(Vec3(x, 0.0, 0.4)));
  }
  hull.setLocalScaling(btVector3(2, 1, 1));
  btBoxShape half(btVector3(btScalar(0.5), btScalar(0.2), btScalar(0.2)));
  btCompoundShape compound;  // a catamaran
  for (const double y : {-0.6, 0.6})
    compound.addChildShape(btTransform(btQuaternion::getIdentity(), toBullet(Vec3(0.0, y, 0.0))),
                           &half);
  btUniformScalingShape twice(&half, 2);
  btMultiSphereShape pill(std::array<btVector3, 2>{btVector3(-1, 0, 0), btVector3(1, 0, 0)}.data(),
                          std::array<btScalar, 2>{btScalar(0.5), btScalar(0.5)}.data(), 2);
  struct Case {
    btCollisionShape* shape;
    double volume, tolerance;
  };
  // 1e-6: sizes in single precision. The support of a round shape in 500 directions is inside it,
  // 2 % for a pill whose ends alone have most of them.
  const Case cases[] = {
      {&ball, kPi / 6.0, 1e-6},       {&capsule, kPi * 0.09 * (1.0 + 0.4), 1e-6},
      {&cylinder, kPi * 0.16, 1e-6},  {&cone, kPi / 3.0 * 0.25 * 0.8, 1e-6},
      {&hull, 2.0 * 0.5 * 0.8, 1e-6}, {&compound, 2.0 * 0.16, 1e-6},
      {&twice, 8.0 * 0.16, 1e-6},     {&pill, kPi * 0.25 * (2.0 + 2.0 / 3.0), 0.02}};
  for (const Case& one : cases) {
    FloatScene scene;
    const double mass = 0.6 * kRho * one.volume;
    Float& floating = scene.seaway.addFloat(scene.body(*one.shape, mass));
    EXPECT_NEAR(floating.volume(), one.volume, one.tolerance * one.volume) << one.shape->getName();
    scene.run(60.0);
    // 2e-3: what a minute leaves of heaving and rolling.
    EXPECT_NEAR(floating.immersion(), share(scene, floating), 2e-3) << one.shape->getName();
  }
}

// A ball's cap of height d has the volume πd²(R − d/3); its mesh has flat faces.
TEST(FloatClosedForm, RoundShapesFloatAtTheirDraught) {
  FloatScene scene;
  btSphereShape ball(1);
  const double draught = 0.7, volume = kPi * draught * draught * (1.0 - draught / 3.0);
  Float& one = scene.seaway.addFloat(scene.body(ball, kRho * volume));
  btCylinderShapeZ barrel(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.15)));
  Float& flat = scene.seaway.addFloat(scene.body(barrel, kRho * kPi * 0.25 * 0.2, {10, 0, 0}));
  scene.run(60.0);
  // 1 % of R: a ball of 180 faces.
  EXPECT_NEAR(1.0 - scene.place(one.body()).z(), draught, 0.01);
  EXPECT_NEAR(0.15 - scene.place(flat.body()).z(), 0.2, 1e-4);
  recordResult("Floats", withPrecision("draught of a ball of 1 m radius [m]"), "0.7",
               1.0 - scene.place(one.body()).z(), "0.01");
}

// ω² = ρgA/(m + A33), A33 of the half that is wet; the waves that it makes take 5 % a swing, which
// is 0.1 % of the period, and the tick 0.02 %.
TEST(FloatClosedForm, ABoxHeavesWithItsPeriod) {
  FloatScene scene;
  btBoxShape box(btVector3(1, 1, btScalar(0.5)));
  const double mass = 0.5 * kRho * 4.0;
  btRigidBody& body = scene.body(box, mass, {0.0, 0.0, 0.02});
  body.setAngularFactor(0);
  Float& one = scene.seaway.addFloat(body, dragless());
  std::vector<double> crossings;
  double before = 0.02, time = 0.0;
  scene.run(20.0, 1.0 / 240, [&] {
    time += 1.0 / 240;
    const double z = scene.place(body).z();
    if ((before > 0.0) != (z > 0.0)) crossings.push_back(time - 1.0 / 240 * z / (z - before));
    before = z;
  });
  ASSERT_GE(crossings.size(), 4u);
  const Vec3 a = one.semiAxes();  // rising: the first is upright
  const double A33 = 0.5 * ellipsoidMass(a, kRho).linear[0];
  const double period = 2.0 * kPi * std::sqrt((mass + A33) / (kRho * kG * 4.0));
  EXPECT_NEAR(crossings[3] - crossings[1], period, 0.01 * period);
  recordResult("Floats", withPrecision("heave period of a box of 2 x 2 x 1 m [s]"),
               std::to_string(period), crossings[3] - crossings[1], "1 %");
}

TEST(FloatClosedForm, WhatSinksReachesItsTerminalSpeed) {
  for (const double tick : {1.0 / 240, 1.0 / 15}) {
    FloatScene scene;
    btBoxShape box(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
    btRigidBody& body = scene.body(box, 1.6 * kRho, {0.0, 0.0, -5.0});
    body.setAngularFactor(0);
    FloatSettings settings;
    settings.friction = settings.slowDrag = 0.0;
    scene.seaway.addFloat(body, settings);
    scene.run(20.0, tick);
    const double expected = std::sqrt(2.0 * 0.6 * kRho * kG / (kRho * settings.normalDrag));
    EXPECT_NEAR(-static_cast<double>(body.getLinearVelocity().z()), expected, 1e-4 * expected);
    recordResult(
        "Floats",
        withPrecision("terminal speed of a cube [m/s], tick " + std::to_string(tick).substr(0, 6)),
        std::to_string(expected), -static_cast<double>(body.getLinearVelocity().z()), "1e-4");
  }
}

// Without gravity and weight, deep down, whatever the tick: a velocity is slowed, never turned; and
// of a body that moves and spins the energy only falls.
TEST(FloatIdentity, DragNeverTurnsAVelocityRound) {
  constexpr double kNothing = kDouble ? 1e-10 : 1e-4;  // round-off of (20 m/s)², at rest
  for (const double tick : {1.0 / 240, 1.0 / 60, 1.0 / 15}) {
    for (const double size : {0.02, 0.5, 6.0}) {
      for (const double density : {0.05, 1.0, 8.0}) {
        for (const int moves : {1, 2, 3}) {  // along, about, both
          FloatScene scene({}, {}, 0.0);
          btBoxShape box(toBullet(Vec3(size, 2.0 * size, 0.5 * size)));
          btRigidBody& body =
              scene.body(box, density * 8000.0 * size * size * size, {0.0, 0.0, -100.0});
          if ((moves & 1) != 0) body.setLinearVelocity(btVector3(20, 0, 0));
          if ((moves & 2) != 0) body.setAngularVelocity(btVector3(0, 0, 5));
          Float& one = scene.seaway.addFloat(body);
          const double mass = 1.0 / static_cast<double>(body.getInvMass());
          const auto energy = [&] {
            const btVector3 spin = body.getAngularVelocity();
            return 0.5 * mass * static_cast<double>(body.getLinearVelocity().length2()) +
                   0.5 * static_cast<double>(
                             spin.dot(body.getInvInertiaTensorWorld().inverse() * spin));
          };
          btVector3 before = body.getLinearVelocity(), spin = body.getAngularVelocity();
          double most = energy();
          scene.run(60 * tick, tick, [&] {
            const btVector3 now = body.getLinearVelocity(), turns = body.getAngularVelocity();
            // Of a body that does both, the water's share of the energy may come back to it.
            if (moves != 3) {
              EXPECT_GE(now.dot(before), -kNothing) << tick << ' ' << size << ' ' << density;
              EXPECT_GE(turns.dot(spin), -kNothing) << tick << ' ' << size << ' ' << density;
              EXPECT_LE(energy(), most * 1.0001);
            }
            most = energy();
            before = now;
            spin = turns;
          });
          EXPECT_LT(body.getLinearVelocity().length2(), 20 * 20);
          EXPECT_GT(one.immersion(), 0.999);
          EXPECT_EQ(scene.seaway.faults(), kStepOk);
        }
      }
    }
  }
}

// Deep down, without weight: a ball of mass m with a = ½ρV of water runs into a ball of mass m that
// is no float, without restitution, and both go on at (m + a)/(2m + a) of its speed.
TEST(FloatClosedForm, ContactsMoveBodyAndWater) {
  FloatScene scene({}, {}, 0.0);
  scene.world.world.getSolverInfo().m_erp2 = 0;  // an overlap would push them apart
  btSphereShape ball(btScalar(0.5));
  const double a = 0.5 * kRho * kPi / 6.0, mass = 0.8 * kRho * kPi / 6.0;
  btRigidBody& runs = scene.body(ball, mass, {0.0, 0.0, -50.0});
  btRigidBody& rests = scene.body(ball, mass, {1.2, 0.0, -50.0});
  runs.setLinearVelocity(btVector3(1, 0, 0));
  scene.seaway.addFloat(runs, dragless());
  scene.run(0.1);
  EXPECT_NEAR(static_cast<double>(runs.getLinearVelocity().x()), 1.0, 1e-6);
  scene.run(0.4);
  const double expected = (mass + a) / (2.0 * mass + a);
  // (l/(1 + l))^10 of ten sweeps, l = a/m, is 7e-5.
  EXPECT_NEAR(static_cast<double>(rests.getLinearVelocity().x()), expected, 1e-4);
  EXPECT_NEAR(static_cast<double>(runs.getLinearVelocity().x()), expected, 1e-4);
}

// 2.7 g in a ball of 40 mm that may be dropped from 1 m: no tick is too long for it.
TEST(FloatClosedForm, ATableTennisBallComesToRestAtAnyTick) {
  for (const double tick : {1.0 / 240, 1.0 / 60, 1.0 / 15}) {
    FloatScene scene;
    btSphereShape ball(btScalar(0.02));
    Float& one = scene.seaway.addFloat(scene.body(ball, 0.0027, {0.0, 0.0, 1.0}));
    double highest = -1.0, lowest = 1.0, time = 0.0;
    scene.run(20.0, tick, [&] {
      time += tick;
      if (time < 15.0) return;
      highest = std::max(highest, scene.place(one.body()).z());
      lowest = std::min(lowest, scene.place(one.body()).z());
    });
    EXPECT_LT(highest - lowest, 1e-4) << tick;  // of 40 mm
    EXPECT_NEAR(one.immersion(), share(scene, one), 1e-3);
  }
}

// Its weight low down a barrel stands; a slab on its edge lies down.
TEST(FloatIdentity, AttitudeFollowsTheWeight) {
  FloatScene scene;
  btCylinderShapeZ cylinder(btVector3(btScalar(0.3), btScalar(0.3), btScalar(0.45)));
  btCompoundShape ballasted;  // G 0.3 m below the middle
  ballasted.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(0.3))),
                          &cylinder);
  const Mat3 tilted = Eigen::AngleAxisd(1.2, Vec3(1.0, 0.4, 0.0).normalized()).toRotationMatrix();
  btRigidBody& barrel =
      scene.body(ballasted, 0.6 * kRho * kPi * 0.09 * 0.9, {0.0, 0.0, 0.0}, tilted);
  btBoxShape slabShape(btVector3(1, 1, btScalar(0.1)));
  const Mat3 onEdge = Eigen::AngleAxisd(1.5, Vec3::UnitX()).toRotationMatrix();
  btRigidBody& slab = scene.body(slabShape, 0.5 * kRho * 0.8, {10.0, 0.0, 0.0}, onEdge);
  scene.seaway.addFloat(barrel);
  scene.seaway.addFloat(slab);
  scene.run(120.0);
  EXPECT_GT(barrel.getWorldTransform().getBasis()[2][2], 0.9999);  // within 1 degree
  EXPECT_GT(std::abs(slab.getWorldTransform().getBasis()[2][2]), 0.9999);
}

// Half a metre across, as heavy as water, 3 m down in a wave of 40 m: the orbit of the water there
// within 4 %: the orbit itself is so much
// larger at its top than at its bottom.
TEST(FloatVerification, ABodyAsHeavyAsWaterFollowsItsOrbit) {
  const double omega = 1.24, a = 0.5, k = omega * omega / kG, z0 = -3.0;
  FloatScene scene(SeaState({{.omega = omega, .amplitude = a}}, kG, 20.0));
  btSphereShape ball(btScalar(0.25));
  Float& one = scene.seaway.addFloat(scene.body(ball, 1.0, {0.0, 0.0, z0}));
  const double mass = kRho * one.volume();
  btVector3 inertia;
  ball.calculateLocalInertia(static_cast<btScalar>(mass), inertia);
  one.body().setMassProps(static_cast<btScalar>(mass), inertia);
  one.body().setGravity(scene.world.world.getGravity());
  scene.run(30.0);
  Vec3 low = Vec3::Constant(1e9), high = -low;
  double slip = 0.0, fastest = 0.0, slowest = 0.0;
  scene.run(2.0 * kPi / omega, 1.0 / 64, [&] {
    const Vec3 at = scene.place(one.body());
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
    const Vec3 v = fromBullet(one.body().getLinearVelocity());
    slip = std::max(slip, (v - one.waterVelocity()).norm());
    fastest = std::max(fastest, v.x());
    slowest = std::min(slowest, v.x());
  });
  const double orbit = a * std::exp(k * 0.5 * (high.z() + low.z()));
  // By its velocity: it drifts on meanwhile.
  EXPECT_NEAR(0.5 * (fastest - slowest) / omega, orbit, 0.04 * orbit);
  EXPECT_NEAR(0.5 * (high.z() - low.z()), orbit, 0.04 * orbit);
  EXPECT_LT(slip, 0.05 * omega * orbit);
  recordResult("Floats", withPrecision("orbit of a ball as heavy as water, 3 m down [m]"),
               std::to_string(orbit), 0.5 * (high.z() - low.z()), "4 %");
}

// As heavy as water, 8 m down in steep waves: Bernoulli's pressure has the convective part of the
// acceleration already. It stays at its depth, but for its first second. (Twice that part, a²ω²k
// e^{2kz} upwards, would bring it to the surface within a minute.)
TEST(FloatVerification, ABodyAsHeavyAsWaterStaysDownInSteepWaves) {
  for (const int order : {1, 2, 5}) {
    FloatScene scene(SeaState::steep({.omega = 1.0, .amplitude = 2.0}, kG, order, 20.0));
    btSphereShape ball(btScalar(0.5));
    Float& one = scene.seaway.addFloat(scene.body(ball, 1.0, {0.0, 0.0, -8.0}));
    const double mass = kRho * one.volume();
    btVector3 inertia;
    ball.calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    one.body().setMassProps(static_cast<btScalar>(mass), inertia);
    one.body().setGravity(scene.world.world.getGravity());
    double low = 0.0, high = -HUGE_VAL;
    scene.run(60.0, 1.0 / 64, [&] {
      low = std::min(low, scene.place(one.body()).z());
      high = std::max(high, scene.place(one.body()).z());
    });
    EXPECT_GT(low, -10.5) << order;  // its orbit there is 0.9 m
    EXPECT_LT(high, -6.0) << order;
  }
}

// What floats drifts with the waves, at Stokes' a²ωk: none of its own.
TEST(FloatVerification, ASmallCrateDriftsAsStokesSays) {
  const double omega = 1.0, a = 0.5, stokes = a * a * omega * omega * omega / kG;
  for (const WaveProfile profile : {WaveProfile::Extrapolated, WaveProfile::Wheeler}) {
    FloatScene scene(SeaState({{.omega = omega, .amplitude = a}}, kG, 10.0, profile));
    btBoxShape box(toBullet(Vec3::Constant(0.1)));
    Float& one = scene.seaway.addFloat(scene.body(box, 0.6 * kRho * 0.008));
    scene.run(60.0, 1.0 / 60);
    const double from = scene.place(one.body()).x();
    scene.run(600.0, 1.0 / 60);
    const double drift = (scene.place(one.body()).x() - from) / 600.0;
    // Wheeler's profile has no change of velocity with depth at the surface: half of Stokes' drift.
    const double expected = profile == WaveProfile::Wheeler ? 0.5 * stokes : stokes;
    EXPECT_NEAR(drift, expected, 0.1 * stokes);
    EXPECT_NEAR(scene.place(one.body()).y(), 0.0, 1.0);
    recordResult("Floats",
                 withPrecision(std::string("drift of a crate of 0.2 m in 10 minutes, ") +
                               kWaveProfileNames[static_cast<std::size_t>(profile)] + " [m/s]"),
                 std::to_string(expected), drift, "10 % of Stokes' drift");
  }
}

// Long waves carry a raft up and down as they are, and it lies along their slope.
TEST(FloatVerification, ARaftFollowsLongWaves) {
  const double omega = 0.5, a = 1.0, k = omega * omega / kG;
  FloatScene scene(SeaState({{.omega = omega, .amplitude = a}}, kG, 20.0));
  btBoxShape box(btVector3(1, 1, btScalar(0.15)));
  Float& one = scene.seaway.addFloat(scene.body(box, 0.5 * kRho * 1.2));
  scene.run(60.0);
  double off = 0.0, tilt = 0.0, middle = 0.0;
  scene.run(4.0 * kPi / omega, 1.0 / 64, [&] {
    const Vec3 at = scene.place(one.body());
    off = std::max(off, std::abs(at.z() - scene.seaway.waveHeight(at.x(), at.y())));
    tilt = std::max(
        tilt, std::acos(static_cast<double>(one.body().getWorldTransform().getBasis()[2][2])));
    middle = std::max(middle, one.immersion());
  });
  EXPECT_LT(off, 0.03 * a);  // (ω/ω_heave)² = 1 %, and the tick
  EXPECT_NEAR(tilt, k * a, 0.15 * k * a);
  recordResult("Floats", withPrecision("raft in waves of 250 m: largest way off the surface [m]"),
               "0", off, "0.03");
}

// One scene in three worlds.
TEST(FloatIdentity, WorldsWithYUpAndInCentimetresGiveTheSame) {
  const SeaState sea({{.omega = 1.3, .amplitude = 0.4, .heading = 0.7}}, kG, 5.0);
  const auto run = [&](const WorldFrame& frame) {
    FloatScene scene(sea, frame);
    const auto unit = static_cast<btScalar>(1.0 / frame.metresPerUnit);
    const Vec3 half(0.6, 0.4, 0.3);
    btVector3 extents = frame.length(half);
    for (int i = 0; i < 3; ++i) extents[i] = std::abs(extents[i]);
    btBoxShape box(extents);
    box.setMargin(btScalar(0.01) * unit);
    const Mat3 tilt = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    Float& one = scene.seaway.addFloat(scene.body(box, 300.0, {1.0, 2.0, 0.5}, tilt));
    scene.run(10.0);
    return scene.place(one.body());
  };
  const Vec3 metres = run({});
  // The triangles of a box lie in another order along other axes, felt in the drag at 5e-4;
  // single precision is amplified some hundredfold in ten seconds of a tilted box.
  const double tolerance = 5e-3;
  for (const WorldFrame& frame :
       {WorldFrame{.up = WorldFrame::Up::Y},
        WorldFrame{.up = WorldFrame::Up::Y, .metresPerUnit = 0.01, .seaLevel = 300.0},
        WorldFrame{.metresPerUnit = 0.3048, .kilogramsPerUnit = 10.0}})
    EXPECT_LT((run(frame) - metres).norm(), tolerance);
}

}  // namespace
}  // namespace cutwater::test
