// Worlds with other axes and units, threads, drawing.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

// The slender ship in waves, in a world that measures as `frame` says.
struct Measured {
  explicit Measured(const WorldFrame& frame, unsigned threads = 1, int ships = 1)
      : seaway(world.world, waves(), frame) {
    world.world.setGravity(frame.length(Vec3(0, 0, -kSphereGravity)));
    for (int i = 0; i < ships; ++i) {
      ShipSettings settings;
      settings.start.x = 5.0;
      settings.start.y = 200.0 * i;
      settings.start.heading = 0.6 + 0.1 * i;
      settings.start.speed = 4.0;
      settings.model.mean = i % 2 == 0 ? Mean::Free : Mean::Fixed;
      if (i % 2 == 1) settings.start.speed = 0.0;
      settings.start.offset[Roll] = 0.1;
      settings.model.keepCourse = CourseKeeper{.heading = 1.0};
      seaway.addShip(coefficients, settings);
    }
    seaway.setThreads(threads);
  }
  Ship& ship(std::size_t i = 0) { return *seaway.ships()[i]; }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) world.world.stepSimulation(kTick, 1, kTick);
  }
  TestWorld world;
  Coefficients coefficients = slenderShip();
  Seaway seaway;
};

TEST(WorldFrameIdentity, AxesAndUnitsDoNotChangeThePhysics) {
  Measured metric({});
  metric.run(640);
  for (const WorldFrame& frame :
       {WorldFrame{.up = WorldFrame::Up::Y}, WorldFrame{.metresPerUnit = 0.01},
        WorldFrame{.up = WorldFrame::Up::Y,
        .metresPerUnit = 2.0,
        .kilogramsPerUnit = 1000.0,
        .seaLevel = 30.0}}) {
    Measured other(frame);
    other.run(640);
    EXPECT_EQ(other.seaway.faults(), kStepOk);
    // Rounding of 640 ticks, positions of 50 m; centimetres and tonnes are no powers of two.
    const double tolerance = 640 * 50 * 4 * kEpsilon;
    EXPECT_LT((other.ship().position() - metric.ship().position()).norm(), tolerance);
    EXPECT_LT((other.ship().attitude() - metric.ship().attitude()).norm(), tolerance);
    const btVector3 origin = other.ship().body().getWorldTransform().getOrigin();
    const btScalar height = frame.up == WorldFrame::Up::Y ? origin.y() : origin.z();
    EXPECT_NEAR(static_cast<double>(height),
                metric.ship().position().z() / frame.metresPerUnit + frame.seaLevel,
                tolerance / frame.metresPerUnit + 40 * kEpsilon);
  }
}

TEST(WorldFrameClosedForm, YUpPutsTheMastAlongYAndPortAlongMinusZ) {
  const WorldFrame frame{.up = WorldFrame::Up::Y, .metresPerUnit = 0.5, .seaLevel = 10.0};
  EXPECT_EQ(frame.place(Vec3(1, 2, 3)), btVector3(2, 16, -4));
  EXPECT_EQ(frame.placeToEarth(btVector3(2, 16, -4)), Vec3(1, 2, 3));
  EXPECT_EQ(frame.inertia(Vec3(1, 2, 3)), btVector3(4, 12, 8));
  const btMatrix3x3 upright = frame.rotation(Mat3::Identity());
  EXPECT_EQ(upright, btMatrix3x3::getIdentity());
  TestWorld world;
  EXPECT_THROW(Seaway(world.world, {}, WorldFrame{.metresPerUnit = 0.0}), HydroError);
  Seaway seaway(world.world, waves(), frame);
  const btVector3 surface = seaway.waterAt(btVector3(20, 99, -8));
  EXPECT_NEAR(static_cast<double>(surface.y()), 10.0 + 2.0 * seaway.waveHeight(10, 4),
              40 * kEpsilon);
}

TEST(SeawayIdentity, ThreadsDoNotChangeABit) {
  Measured one({}, 1, 9), three({}, 3, 9);
  one.run(300);
  three.run(300);
  int different = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!sameBits(one.ship(i).body(), three.ship(i).body())) ++different;
  }
  EXPECT_EQ(different, 0);
  EXPECT_THROW(one.seaway.setThreads(0), HydroError);
  recordResult("Plugin", withPrecision("ships whose bits differ between 1 and 3 threads"), "0",
               different, "0");
}

TEST(Seaway, ShipsComeAndGoWhileItRuns) {
  Measured scene({}, 2, 3);
  scene.run(50);
  scene.seaway.removeShip(scene.ship(1));
  scene.run(50);
  ShipSettings late;
  late.start.x = -500.0;
  late.start.speed = 5.0;
  late.model.mean = Mean::Free;
  Ship& newcomer = scene.seaway.addShip(scene.coefficients, late);
  scene.run(50);
  EXPECT_EQ(scene.seaway.faults(), kStepOk);
  EXPECT_GT(newcomer.position().x(), -500.0);
  while (!scene.seaway.ships().empty()) scene.seaway.removeShip(scene.ship());
  scene.run(10);
  EXPECT_EQ(scene.world.world.getNumCollisionObjects(), 0);
  EXPECT_EQ(scene.world.world.getNumConstraints(), 0);
}

// Counts what it is asked to draw.
struct Pen final : LineDrawer {
  void drawLine(const btVector3& from, const btVector3& to, const btVector3&) override {
    ++lines;
    finite = finite && std::isfinite(from.x() + from.y() + from.z() + to.x() + to.y() + to.z());
  }
  int lines = 0;
  bool finite = true;
};

TEST(Seaway, DrawsWavesForcesAndWaterlines) {
  Measured scene({});
  scene.coefficients.ship.hull.faces = {{{0, 4, 6, 2}}, {{1, 3, 7, 5}}, {{0, 1, 5, 4}},
                                        {{2, 6, 7, 3}}, {{0, 2, 3, 1}}, {{4, 5, 7, 6}}};
  scene.run(10);
  Pen pen;
  scene.seaway.debugDraw(pen);
  EXPECT_GT(pen.lines, 2 * 24 * 24);  // the grid, and four sides that cross the water, and arrows
  EXPECT_LE(pen.lines, 2 * 24 * 24 + 4 + 6);
  EXPECT_TRUE(pen.finite);
  scene.world.world.setDebugDrawer(&pen);
  const int before = pen.lines;
  scene.world.world.debugDrawWorld();
  EXPECT_GT(pen.lines, before + 2 * 24 * 24);
  scene.world.world.setDebugDrawer(nullptr);
}

TEST(Seaway, AMassTakenAwayHoldsTheShipStillAndGivenBackLetsItGo) {
  Measured scene({});
  scene.run(10);
  btRigidBody& body = scene.ship().body();
  const btScalar mass = btScalar(1) / body.getInvMass();
  const btVector3 inertia(btScalar(1) / body.getInvInertiaDiagLocal().x(),
                          btScalar(1) / body.getInvInertiaDiagLocal().y(),
                          btScalar(1) / body.getInvInertiaDiagLocal().z());
  body.setMassProps(0, btVector3(0, 0, 0));
  scene.run(20);
  EXPECT_TRUE(velocityOf(body).allFinite());
  body.setMassProps(mass, inertia);
  body.updateInertiaTensor();
  scene.run(20);
  EXPECT_TRUE(velocityOf(body).allFinite());
  EXPECT_LT(scene.ship().velocity().norm(), 10.0);
}

}  // namespace
}  // namespace cutwater::test
