// The user's own file, with its axes, unit and origin, where the ship is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

/// A file whose axes `forward` and `up` are the ship's, with calm water at `waterline` along up.
struct File {
  const char* name;
  Vec3 forward, port, up;
  double unit;  // [m]
  double waterline;
  FilePlacement placement() const {
    FilePlacement file;
    file.rotation << forward.transpose(), port.transpose(), up.transpose();
    file.metresPerUnit = unit;
    file.origin = Vec3(0, 0, -unit * waterline);
    return file;
  }
  // A point of the hull as it is drawn in the file.
  Vec3 drawn(const Vec3& inHull) const {
    const Vec3 p = inHull / unit;
    return p.x() * forward + p.y() * port + (p.z() + waterline) * up;
  }
};

std::vector<File> files() {
  return {{"z up, x forward, m", kX, kY, kZ, 1.0, 0.0},
          {"z up, -x forward, m", -kX, -kY, kZ, 1.0, 3.0},
          {"y up, x forward, cm", kX, -kZ, kY, 0.01, 250.0},
          {"y up, -x forward, cm", -kX, kZ, kY, 0.01, 0.0},
          {"y up, -z forward, ft", -kZ, -kX, kY, 0.3048, -2.0}};
}

std::vector<WorldFrame> frames() {
  return {{},
          {.up = WorldFrame::Up::Y},
          {.metresPerUnit = 0.01, .seaLevel = 120.0},
          {.up = WorldFrame::Up::Y, .metresPerUnit = 0.01, .seaLevel = -50.0}};
}

// A ship of its own world, in a frame, its hull from a file.
struct Drawn {
  Drawn(const File& file, const WorldFrame& frame, const ShipStart& start)
      : world(0.0), seaway(world.world, SeaState(), frame) {
    world.world.setGravity(frame.length(Vec3(0, 0, -kSphereGravity)));
    Coefficients c = slenderShip();
    c.ship.file = file.placement();
    ship = &seaway.addShip(c, {.start = start});
  }
  TestWorld world;
  Seaway seaway;
  Ship* ship = nullptr;
};

ShipStart somewhere() {
  ShipStart start{.x = 40.0, .y = -25.0, .heading = 0.7};
  start.offset << 0.5, -0.3, 1.2, 0.2, -0.1, 0.05;
  return start;
}

// What an engine does with the 16 numbers of a matrix in columns.
btVector3 byMatrix(const btScalar (&m)[16], const btVector3& p) {
  btVector3 out(m[12], m[13], m[14]);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out[row] += m[4 * column + row] * p[column];
  return out;
}

// Round-off of some ten operations on numbers of the size of the largest.
TEST(ModelTransformIdentity, AVertexOfTheFileLandsWhereTheHullHasIt) {
  const Vec3 vertices[] = {{55.0, 7.0, 6.0}, {-55.0, 7.0, -5.0}, {0.0, -7.0, 6.0}, {0, 0, 0}};
  for (const File& file : files()) {
    for (const WorldFrame& frame : frames()) {
      const Drawn drawn(file, frame, somewhere());
      const btTransform model = drawn.ship->modelTransform();
      btScalar matrix[16];
      model.getOpenGLMatrix(matrix);
      for (const Vec3& vertex : vertices) {
        const btVector3 expected = frame.place(drawn.ship->pointMotion(vertex).position);
        const btVector3 found = model * toBullet(file.drawn(vertex));
        const double size = 100.0 / frame.metresPerUnit + std::abs(frame.seaLevel);
        EXPECT_LT(static_cast<double>((found - expected).length()), 16.0 * kEpsilon * size)
            << file.name << ", world unit " << frame.metresPerUnit;
        EXPECT_LT(static_cast<double>(
                      (byMatrix(matrix, toBullet(file.drawn(vertex))) - expected).length()),
                  16.0 * kEpsilon * size)
            << file.name;
      }
      EXPECT_EQ(drawn.ship->modelScale(), file.unit / frame.metresPerUnit);
      // Without its scale the basis is a rotation.
      const Mat3 turn = fromBullet(model.getBasis()) / drawn.ship->modelScale();
      EXPECT_LT((turn * turn.transpose() - Mat3::Identity()).norm(), 16.0 * kEpsilon);
      EXPECT_GT(turn.determinant(), 0.0);
    }
  }
}

// A y-up model stands upright in a y-up world, a z-up model in a z-up one, and either in the other.
TEST(ModelTransformIdentity, AModelStandsUpright) {
  for (const File& file : files()) {
    for (const WorldFrame& frame : frames()) {
      const Drawn drawn(file, frame, {});
      const btMatrix3x3 basis = drawn.ship->modelTransform().getBasis();
      const btScalar scale = static_cast<btScalar>(1.0 / drawn.ship->modelScale());
      const btVector3 up = basis * toBullet(file.up) * scale;
      const btVector3 forward = basis * toBullet(file.forward) * scale;
      EXPECT_LT(static_cast<double>((up - frame.upwards()).length()), 8.0 * kEpsilon) << file.name;
      EXPECT_LT(static_cast<double>((forward - btVector3(1, 0, 0)).length()), 8.0 * kEpsilon)
          << file.name;
    }
  }
}

// A database that does not know its file: hull axes in metres.
TEST(ModelTransform, WithoutAFileItIsTheHulls) {
  const WorldFrame frame{.up = WorldFrame::Up::Y};
  const Drawn drawn(files().front(), frame, somewhere());
  const btTransform model = drawn.ship->modelTransform(), hull = drawn.ship->hullTransform();
  EXPECT_EQ((model.getOrigin() - hull.getOrigin()).length(), 0);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ((model.getBasis()[i] - hull.getBasis()[i]).length(), 0) << i;
}

}  // namespace
}  // namespace cutwater::test
