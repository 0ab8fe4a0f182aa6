#include "plugin/Seaway.h"

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolverMt.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyMLCPConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <gtest/gtest.h>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

void run(btDynamicsWorld& world, int ticks) {
  for (int i = 0; i < ticks; ++i) world.stepSimulation(kTick, 1, kTick);
}

// Where a sphere let go from 1 m is after two seconds in any world.
Vec6 dropIn(btDiscreteDynamicsWorld& world) {
  world.setGravity(btVector3(0, 0, btScalar(-kSphereGravity)));
  btSphereShape shape(5);
  const Coefficients coefficients = hemisphere();
  Seaway seaway(world);
  const Ship& sphere = seaway.addShip(
      coefficients,
      {.start = {.heading = 0.3, .offset = one(Heave, 1.0)}, .collision = {.shape = &shape}});
  run(world, 128);
  EXPECT_EQ(seaway.faults(), kStepOk);
  return sphere.motion();
}

TEST(SeawayIdentity, EveryStockWorldMovesAShipAlike) {
  TestWorld plain;
  const Vec6 discrete = dropIn(plain.world);
  EXPECT_LT(discrete[Heave], 0.9);
  // The same solver on the same rows: equal but for the order of sums.
  const double tolerance = 128 * kEpsilon;

  btMultiBodyConstraintSolver multiSolver;
  btMultiBodyDynamicsWorld multi(&plain.dispatcher, &plain.broadphase, &multiSolver,
                                 &plain.configuration);
  EXPECT_LT((dropIn(multi) - discrete).norm(), tolerance);

  btSoftBodyRigidBodyCollisionConfiguration softConfiguration;
  btCollisionDispatcher softDispatcher(&softConfiguration);
  btSoftRigidDynamicsWorld soft(&softDispatcher, &plain.broadphase, &plain.solver,
                                &softConfiguration);
  EXPECT_LT((dropIn(soft) - discrete).norm(), tolerance);

  btConstraintSolverPoolMt pool(2);
  btSequentialImpulseConstraintSolverMt mtSolver;
  btCollisionDispatcher mtDispatcher(&plain.configuration);
  btDiscreteDynamicsWorldMt mt(&mtDispatcher, &plain.broadphase, &pool, &mtSolver,
                               &plain.configuration);
  EXPECT_LT((dropIn(mt) - discrete).norm(), tolerance);
}

TEST(Seaway, RefusesSolversThatGetAddedMassWrong) {
  TestWorld plain;
  btDantzigSolver dantzig;
  btMLCPSolver mlcp(&dantzig);
  btDiscreteDynamicsWorld world(&plain.dispatcher, &plain.broadphase, &mlcp, &plain.configuration);
  try {
    Seaway seaway(world);
    FAIL() << "btMLCPSolver was accepted";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::SolverNotSupported);
    EXPECT_NE(std::string(error.what()).find("btMLCPSolver"), std::string::npos);
  }
  btMultiBodyMLCPConstraintSolver multiSolver(&dantzig);
  btMultiBodyDynamicsWorld multi(&plain.dispatcher, &plain.broadphase, &multiSolver,
                                 &plain.configuration);
  EXPECT_THROW(Seaway{multi}, HydroError);

  Seaway seaway(plain.world);
  plain.world.setConstraintSolver(&mlcp);  // behind our back
  run(plain.world, 1);
  EXPECT_EQ(seaway.faults(), kSolverNotSupported);
  plain.world.setConstraintSolver(&plain.solver);
}

// A bit that two ships raise counts once a tick.
TEST(Seaway, SaysWhenAFaultWasRaisedFirstAndInHowManyTicks) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  Ship& ship = seaway.addShip(hemisphere(), {.collision = {.shape = &shape}});
  Ship& other = seaway.addShip(hemisphere(), {.start = {.x = 50}, .collision = {.shape = &shape}});
  run(plain.world, 10);
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).ticks, 0u);
  const auto lose = [&](int ticks) {
    for (Ship* each : {&ship, &other}) plain.world.removeRigidBody(&each->body());
    run(plain.world, ticks);
    for (Ship* each : {&ship, &other}) plain.world.addRigidBody(&each->body());
  };
  lose(3);
  run(plain.world, 4);
  lose(2);
  run(plain.world, 1);
  EXPECT_EQ(seaway.faults(), kBodyNotInWorld);
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).ticks, 5u);
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).first, 10 * static_cast<double>(kTick));
  EXPECT_EQ(seaway.faultCount(kLoadNotFinite).ticks, 0u);
  EXPECT_EQ(seaway.faultCount(kStepOk).ticks, 0u);
  EXPECT_EQ(seaway.faultCount(static_cast<StepFault>(kBodyNotInWorld | 1u)).ticks, 0u);
  seaway.clearFaults();
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).ticks, 0u);
  const double again = seaway.time();
  lose(1);
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).ticks, 1u);
  EXPECT_EQ(seaway.faultCount(kBodyNotInWorld).first, again);
}

struct Calls {
  int before = 0, after = 0, late = 0;
};

TEST(Seaway, LeavesTheUsersCallbacksAndUserInfoAlone) {
  TestWorld plain(kSphereGravity);
  Calls calls;
  const auto before = [](btDynamicsWorld* world, btScalar) {
    ++static_cast<Calls*>(world->getWorldUserInfo())->before;
  };
  const auto after = [](btDynamicsWorld* world, btScalar) {
    ++static_cast<Calls*>(world->getWorldUserInfo())->after;
  };
  plain.world.setInternalTickCallback(before, &calls, true);
  plain.world.setInternalTickCallback(after, &calls, false);
  const Coefficients coefficients = hemisphere();
  btSphereShape shape(5);
  {
    Seaway seaway(plain.world);
    EXPECT_THROW(Seaway{plain.world}, HydroError);  // one per world
    const Ship& sphere = seaway.addShip(
        coefficients, {.start = {.offset = one(Heave, 1.0)}, .collision = {.shape = &shape}});
    run(plain.world, 10);
    EXPECT_EQ(calls.before, 10);
    EXPECT_EQ(calls.after, 10);
    EXPECT_EQ(seaway.faults(), kStepOk);
    EXPECT_LT(sphere.motion()[Heave], 1.0);

    // Set after us: it takes our slot for one tick, which is reported, and then both are called.
    const auto late = [](btDynamicsWorld* world, btScalar) {
      ++static_cast<Calls*>(world->getWorldUserInfo())->late;
    };
    plain.world.setInternalTickCallback(late, &calls, true);
    run(plain.world, 10);
    EXPECT_EQ(calls.late, 10);
    EXPECT_EQ(seaway.faults(), kCallbackReplaced);
    EXPECT_NE(sphere.load("gravity")[Heave], 0.0);
    EXPECT_EQ(sphere.lastTick().time, 19 / 64.0);
  }
  EXPECT_EQ(plain.world.getWorldUserInfo(), &calls);
  EXPECT_EQ(plain.world.getNumConstraints(), 0);
  EXPECT_EQ(plain.world.getNumCollisionObjects(), 0);
  run(plain.world, 5);
  EXPECT_EQ(calls.late, 15);
  EXPECT_EQ(calls.after, 25);
}

// A box that falls on a floor beside a ship.
Vec6 fallBeside(bool withShip) {
  TestWorld plain(kSphereGravity);
  btStaticPlaneShape plane(btVector3(0, 0, 1), -20);
  btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  btBoxShape cube(btVector3(1, 1, 1));
  btRigidBody box(
      btRigidBody::btRigidBodyConstructionInfo(50, nullptr, &cube, btVector3(30, 30, 30)));
  box.setCenterOfMassTransform(btTransform(
      btQuaternion(btScalar(0.1), btScalar(0.2), btScalar(0.3)), btVector3(40, 0, -15)));
  plain.world.addRigidBody(&floor);
  plain.world.addRigidBody(&box);
  const Coefficients coefficients = hemisphere();
  btSphereShape shape(5);
  std::unique_ptr<Seaway> seaway;
  if (withShip) {
    seaway = std::make_unique<Seaway>(plain.world);
    seaway->addShip(coefficients,
                    {.start = {.offset = one(Heave, 1.0)}, .collision = {.shape = &shape}});
  }
  for (int i = 0; i < 128; ++i) {
    box.applyCentralForce(btVector3(5, 0, 0));
    run(plain.world, 1);
  }
  seaway.reset();
  plain.world.removeRigidBody(&box);
  plain.world.removeRigidBody(&floor);
  return velocityOf(box) + fromBullet(box.getCenterOfMassPosition()).replicate<2, 1>();
}

TEST(SeawayIdentity, OtherBodiesDoNotNoticeIt) { EXPECT_EQ(fallBeside(true), fallBeside(false)); }

TEST(SeawayIdentity, ShipsFarApartDoNotNoticeEachOther) {
  const Coefficients coefficients = hemisphere();
  btSphereShape shape(5);
  const auto settings = [&](double x) {
    return ShipSettings{.start = {.x = x, .offset = one(Heave, 1.0)},
                        .collision = {.shape = &shape}};
  };
  TestWorld lonely(kSphereGravity), busy(kSphereGravity);
  Seaway one(lonely.world), many(busy.world);
  const Ship& alone = one.addShip(coefficients, settings(0));
  const Ship& first = many.addShip(coefficients, settings(0));
  Ship& second = many.addShip(coefficients, settings(64));
  for (int i = 2; i < 20; ++i) many.addShip(coefficients, settings(64.0 * i));
  run(lonely.world, 64);
  run(busy.world, 64);
  EXPECT_EQ(alone.motion(), first.motion());
  EXPECT_EQ(alone.motion()[Heave], second.motion()[Heave]);
  many.removeShip(second);
  EXPECT_EQ(many.ships().size(), 19u);
  run(lonely.world, 64);
  run(busy.world, 64);
  EXPECT_EQ(alone.motion(), first.motion());
}

TEST(Seaway, RefusesGravityThatDoesNotPointDown) {
  TestWorld plain;
  plain.world.setGravity(btVector3(0, -10, 0));  // Bullet's default
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  const Coefficients coefficients = hemisphere();
  try {
    seaway.addShip(coefficients, {.collision = {.shape = &shape}});
    FAIL() << "y-up gravity was accepted";
  } catch (const HydroError& error) {
    EXPECT_EQ(error.fault(), Fault::ValueOutOfRange);
  }
  plain.world.setGravity(btVector3(0, 0, 0));
  seaway.addShip(coefficients, {.collision = {.shape = &shape}});
  run(plain.world, 4);
  EXPECT_EQ(seaway.faults(), kStepOk);
}

TEST(Seaway, ABodyTakenOutOfTheWorldIsReported) {
  TestWorld plain(kSphereGravity);
  Seaway seaway(plain.world);
  btSphereShape shape(5);
  const Coefficients coefficients = hemisphere();
  Ship& ship = seaway.addShip(coefficients, {.collision = {.shape = &shape}});
  run(plain.world, 2);
  plain.world.removeRigidBody(&ship.body());
  run(plain.world, 1);
  EXPECT_EQ(seaway.faults(), kBodyNotInWorld);
  seaway.clearFaults();
  plain.world.addRigidBody(&ship.body());
  ship.body().setLinearVelocity(btVector3(1, 0, 0));  // it comes back moving, and nothing is felt
  run(plain.world, 2);
  EXPECT_EQ(seaway.faults(), kStepOk);
  EXPECT_NEAR(ship.velocity()[0], 1.0, 1e-3);  // less two ticks of radiation, K(0) h v/(M + A) each
}

TEST(Seaway, WaveHeightIsThatOfItsSea) {
  TestWorld plain(kSphereGravity);
  const SeaState sea({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}}, kSphereGravity);
  Seaway seaway(plain.world, sea);
  run(plain.world, 32);
  EXPECT_EQ(seaway.time(), 0.5);
  EXPECT_EQ(seaway.waveHeight(3, 4), sea.elevation(0.5, 3, 4));
}

}  // namespace
}  // namespace cutwater::test
