#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/wetted/WettedTriangles.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

constexpr double kRhoG = 1025.0 * 9.81;
const Vec3 kOrigin(0.3, -0.2, 0.7);

// An L of seven cubes: not convex, no symmetry but one, sharp edges.
SurfaceMesh body() {
  return triangulated(
      test::cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 0, 1}, {1, 0, 1}}));
}

Mat3 randomAttitude(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

// The surface e·r = height + slope·r, still water but for the slope; hydrostatic pressure below it.
struct Surface {
  Vec3 up = Vec3::UnitZ();
  double height = 0.0;
  Vec3 slope = Vec3::Zero();
};

WettedTriangles::State cut(const WettedTriangles& hull, const Surface& surface) {
  WettedTriangles::State state(hull);
  for (std::size_t i = 0; i < hull.points().size(); ++i) {
    const Vec3 r(hull.points().x[i], hull.points().y[i], hull.points().z[i]);
    state.depth[i] = surface.height + surface.slope.dot(r) - surface.up.dot(r);
    state.pressure[i] = kRhoG * state.depth[i];
  }
  hull.cut(surface.up, state);
  return state;
}

double size(const SurfaceMesh& mesh) { return bounds(mesh).diagonal(); }

TEST(WettedTrianglesIdentity, StillWaterPushesAClosedHullUpAndNoOtherWay) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> height(-2.0, 2.0);
  for (const SurfaceMesh& mesh :
       {body(), test::shuffled(test::shaken(body(), 0.2)), test::chinedHull(12, 3, 4, true)}) {
    const WettedTriangles hull(mesh, kOrigin);
    for (int i = 0; i < 200; ++i) {
      const Vec3 up = randomAttitude(random).row(2);
      const auto state = cut(hull, {up, height(random)});
      const Vec3 force = state.load.head<3>(), moment = state.load.tail<3>();
      // Round-off: some hundred terms of at most ρg L³.
      const double L = size(mesh), bound = 1e-14 * kRhoG * L * L * L;
      EXPECT_LT((force - up * up.dot(force)).norm(), bound);
      EXPECT_LT(std::abs(up.dot(moment)), bound * L);
      // Archimedes: ρgV through the centre of V.
      EXPECT_NEAR(up.dot(force), kRhoG * state.volume, bound);
      EXPECT_LT((moment - state.centre.cross(force)).norm(), 4.0 * bound * L);
    }
  }
}

// The same piece by cutting the mesh at the plane, which is other code.
TEST(WettedTrianglesIdentity, IsThePartBelowThePlane) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> height(-1.5, 1.5), slant(-0.3, 0.3);
  const SurfaceMesh mesh = test::shaken(body(), 0.2);
  const WettedTriangles hull(mesh, kOrigin);
  SurfaceMesh moved = mesh;
  for (Vec3& p : moved.vertices) p -= kOrigin;
  for (int i = 0; i < 200; ++i) {
    Surface surface{randomAttitude(random).row(2), height(random)};
    const Vec3 across = surface.up.unitOrthogonal();
    surface.slope = slant(random) * across;
    const auto state = cut(hull, surface);
    const Vec3 normal = surface.up - surface.slope;
    const SurfaceMesh below =
        cutBelow(moved, {normal.normalized(), surface.height / normal.norm()}, 0.0);
    double area = 0.0;
    for (const Face& face : triangulated(below).faces) area += vectorArea(below, face).norm();
    EXPECT_NEAR(state.area, area, 1e-12 * area + 1e-12);
  }
}

// A pressure that is linear in space over the whole surface: F = −V∇p, M = −V r_V × ∇p.
TEST(WettedTrianglesIdentity, LinearPressureUnderWaterIsGausssTheorem) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const SurfaceMesh mesh = body();
  const WettedTriangles hull(mesh, kOrigin);
  WettedTriangles::State state(hull);
  const Vec3 slope(normal(random), normal(random), normal(random));
  for (std::size_t i = 0; i < hull.points().size(); ++i) {
    const Vec3 r(hull.points().x[i], hull.points().y[i], hull.points().z[i]);
    state.depth[i] = 100.0 - r.z();
    state.pressure[i] = 7.0 + slope.dot(r);
  }
  hull.cut(Vec3::UnitZ(), state);
  // Seven unit cubes, and their middle.
  const Vec3 middle = Vec3(7.5, 6.5, 5.5) / 7.0 - kOrigin;
  EXPECT_NEAR(state.volume, 7.0, 1e-11);  // of differences of depths of 100 m
  EXPECT_LT((state.centre - middle).norm(), 1e-10);
  EXPECT_LT((state.load.head<3>() + 7.0 * slope).norm(), 1e-12);
  EXPECT_LT((state.load.tail<3>() + 7.0 * middle.cross(slope)).norm(), 1e-12);
  EXPECT_TRUE(state.waterline.empty());
  EXPECT_NEAR(hull.volume(), 7.0, 1e-13);
}

// ∮f (V·n) dS = ∫V·∇f dV for a hull that moves without changing its shape.
TEST(WettedTrianglesIdentity, FlowThroughAMovingHullIsGausssTheorem) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto some = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  const WettedTriangles hull(body(), kOrigin);
  WettedTriangles::State state(hull);
  const Vec3 slopes[3] = {some(), some(), some()}, velocity = some(), spin = some();
  for (std::size_t i = 0; i < hull.points().size(); ++i) {
    const Vec3 r(hull.points().x[i], hull.points().y[i], hull.points().z[i]);
    state.depth[i] = 100.0 - r.z();
    for (std::size_t k = 0; k < 3; ++k) state.carried[k][i] = 3.0 + slopes[k].dot(r);
  }
  Vec6 motion;
  motion << velocity, spin;
  hull.press(Vec3::UnitZ(), motion, state);
  const Vec3 middle = Vec3(7.5, 6.5, 5.5) / 7.0 - kOrigin;
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(state.flow[k], 7.0 * slopes[k].dot(velocity + spin.cross(middle)), 1e-12);
}

// Of a hull that is cut: the same, with the waterplane closed by ∫f V·e dA, here of a box.
TEST(WettedTrianglesClosedForm, FlowAndWaterlineOfABoxThatMoves) {
  const WettedTriangles hull(triangulated(test::cubes(test::cells({0, 0, 0}, {4, 2, 1}))),
                             Vec3::Zero());
  WettedTriangles::State state(hull);
  for (std::size_t i = 0; i < hull.points().size(); ++i) {
    state.depth[i] = 0.25 - hull.points().z[i];
    state.carried[0][i] = 1.0;
    state.carried[1][i] = hull.points().x[i];
    state.onSurface[i] = 2.0;
    state.rise[i] = 0.7;  // walls: the waterline does not move with it
  }
  Vec6 motion;
  motion << 0.3, -0.2, 0.5, 0.0, 0.0, 0.0;
  hull.press(Vec3::UnitZ(), motion, state);
  EXPECT_NEAR(state.flow[0], -0.5 * 8.0, 1e-13);              // what rises through the bottom
  EXPECT_NEAR(state.flow[1], 0.3 * 2.0 - 0.5 * 16.0, 1e-13);  // ∫V_x dV, less the bottom
  EXPECT_NEAR(state.edge[0], 0.0, 1e-13);
  EXPECT_NEAR(state.edge[1], 2.0 * 0.3 * 8.0, 1e-12);  // g V_x over the waterplane
}

TEST(WettedTrianglesClosedForm, ABoxAtAnyDraught) {
  const SurfaceMesh mesh = triangulated(test::cubes(test::cells({0, 0, 0}, {4, 2, 1})));
  const WettedTriangles hull(mesh, Vec3(2.0, 1.0, 0.5));
  for (const double draught : {0.001, 0.3, 0.999}) {
    const auto state = cut(hull, {Vec3::UnitZ(), draught - 0.5});
    EXPECT_NEAR(state.volume, 8.0 * draught, 1e-13);
    EXPECT_NEAR(state.area, 8.0 + 12.0 * draught, 1e-13);
    EXPECT_NEAR(state.centre.z(), 0.5 * draught - 0.5, 1e-13);
    EXPECT_NEAR(state.beamArea[0], 8.0, 1e-13);
    double length = 0.0;
    for (const auto& [a, b] : state.waterline) length += (b - a).norm();
    EXPECT_NEAR(length, 12.0, 1e-12);
  }
  const auto sunk = cut(hull, {Vec3::UnitZ(), 3.0});
  EXPECT_NEAR(sunk.volume, 8.0, 1e-13);
  EXPECT_NEAR(sunk.beamArea[0], 8.0, 1e-13);
  const auto dry = cut(hull, {Vec3::UnitZ(), -0.5});
  EXPECT_EQ(dry.volume, 0.0);
  EXPECT_EQ(dry.area, 0.0);
  EXPECT_EQ(dry.load, Vec6(Vec6::Zero()));
}

// Each end of a piece is the end of one other: neighbours share the bits of a cut.
TEST(WettedTrianglesIdentity, WaterlinesAreClosed) {
  std::mt19937 random(4);
  const WettedTriangles hull(test::shaken(body(), 0.2), kOrigin);
  for (int i = 0; i < 50; ++i) {
    const auto state = cut(hull, {randomAttitude(random).row(2), 0.1});
    std::map<std::tuple<double, double, double>, int> ends;
    for (const auto& [a, b] : state.waterline) {
      ++ends[{a.x(), a.y(), a.z()}];
      ++ends[{b.x(), b.y(), b.z()}];
    }
    for (const auto& [place, count] : ends) EXPECT_EQ(count % 2, 0);
  }
}

TEST(WettedTriangles, SurfacePressureActsAtTheCut) {
  // A wall of a box, half wet, with a pressure of 5 Pa in the surface and below it.
  const SurfaceMesh mesh = triangulated(test::cubes({{0, 0, 0}}));
  const WettedTriangles hull(mesh, Vec3::Zero());
  WettedTriangles::State state(hull);
  for (std::size_t i = 0; i < hull.points().size(); ++i) {
    const double x = hull.points().x[i];
    state.depth[i] = 0.5 - hull.points().z[i];
    state.pressure[i] = x > 0.5 ? 5.0 : 0.0;
    state.surfacePressure[i] = state.pressure[i];
  }
  hull.cut(Vec3::UnitZ(), state);
  EXPECT_NEAR(state.load[0], -2.5, 1e-14);
}

TEST(WettedTriangles, StripsShareTheBeam) {
  const SurfaceMesh mesh = triangulated(test::cubes(test::cells({0, 0, 0}, {4, 2, 1})));
  const WettedTriangles hull(mesh, Vec3::Zero(), {0.0, 1.0, 3.0, 4.0});
  ASSERT_EQ(hull.strips(), 3u);
  const auto state = cut(hull, {Vec3::UnitZ(), 0.5});
  EXPECT_NEAR(state.beamArea[0], 2.0, 1e-14);
  EXPECT_NEAR(state.beamArea[1], 4.0, 1e-14);
  EXPECT_NEAR(state.beamArea[2], 2.0, 1e-14);
}

TEST(WettedTriangles, RefusesWhatIsNoClosedHull) {
  SurfaceMesh open = body();
  open.faces.pop_back();
  test::expectRefusal(Fault::HullNotClosed, {"not closed", "3 open edges", "one at ("},
                      [&] { WettedTriangles(open, kOrigin); });
  test::expectRefusal(Fault::HullInverted, {"outwards"},
                      [&] { WettedTriangles(turnedOver(body()), kOrigin); });
  test::expectRefusal(Fault::MeshEmpty, {"no faces"}, [&] { WettedTriangles({}, kOrigin); });
  SurfaceMesh nan = body();
  nan.vertices.front().x() = std::numeric_limits<double>::quiet_NaN();
  test::expectRefusal(Fault::MeshNotFinite, {"not finite"}, [&] { WettedTriangles(nan, kOrigin); });
}

}  // namespace
}  // namespace cutwater
