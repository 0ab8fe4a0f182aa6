#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/shapes/Spacing.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

TEST(ShapeGridClosedForm, APlaneIsDividedInRowsAndColumns) {
  const SurfaceMesh mesh = gridSurface(uniform(4), uniform(3), [](double u, double v) -> Vec3 {
    return {8 * u, 6 * v, -1.0};
  });
  EXPECT_EQ(mesh.vertices.size(), 5u * 4u);
  EXPECT_EQ(mesh.faces.size(), 4u * 3u);
  for (const Face& f : mesh.faces) {
    EXPECT_EQ(f.size(), 4);
    // ∂P/∂u × ∂P/∂v is up; a panel of 2 m × 2 m, to round-off.
    EXPECT_LT((vectorArea(mesh, f) - Vec3(0, 0, 4)).norm(), 1e-14);
  }
}

TEST(ShapeGrid, TheGridNeedNotBeUniform) {
  const std::vector<double> u{0.0, 0.1, 1.0}, v{0.0, 0.75, 1.0};
  const SurfaceMesh mesh = gridSurface(u, v, [](double s, double t) -> Vec3 {
    return {s, t, 0.0};
  });
  EXPECT_EQ(mesh.vertices.size(), 9u);
  for (const double x : u)
    for (const double y : v)
      EXPECT_EQ(std::count(mesh.vertices.begin(), mesh.vertices.end(), Vec3(x, y, 0)), 1);
}

// A cone: all of v → P(0, v) is its tip.
TEST(ShapeGrid, FacesAtAPoleAreTriangles) {
  const SurfaceMesh cone = gridSurface(uniform(3), uniform(5), [](double u, double v) -> Vec3 {
    return {u * std::cos(v), u * std::sin(v), -1 + u};
  });
  EXPECT_EQ(cone.vertices.size(), 1u + 3u * 6u);
  int triangles = 0;
  for (const Face& f : cone.faces) triangles += f.size() == 3 ? 1 : 0;
  EXPECT_EQ(triangles, 5);
  EXPECT_EQ(cone.faces.size(), 15u);
}

TEST(ShapeGrid, WhatIsZeroButForRoundOffIsZero) {
  const SurfaceMesh mesh = gridSurface(uniform(1), uniform(1), [](double u, double v) -> Vec3 {
    return {100 * u, v - 1, u == 0 ? 0.9e-10 : 1.1e-10};  // 1e-12 of 100 m, a little less or more
  });
  for (const Vec3& p : mesh.vertices) EXPECT_EQ(p.z(), p.x() == 0.0 ? 0.0 : 1.1e-10);
  const SurfaceMesh signs = gridSurface(uniform(1), uniform(1), [](double u, double v) -> Vec3 {
    return {u, v, -0.0};
  });
  for (const Vec3& p : signs.vertices) EXPECT_FALSE(std::signbit(p.z()));
}

TEST(ShapeGridClosedForm, CurvesAreCutByTheirLengthNotByTheirParameter) {
  const std::vector<double> fractions{0.0, 0.2, 0.5, 1.0};
  const SurfaceMesh mesh = gridOfCurves({0.0, 1.0}, fractions, [](double u, double v) -> Vec3 {
    const double angle = 0.5 * kPi * v * v;  // a quarter circle that begins slowly
    return {u, std::cos(angle), -std::sin(angle)};
  });
  ASSERT_EQ(mesh.vertices.size(), 8u);
  std::vector<double> found;
  for (const Vec3& p : mesh.vertices)
    if (p.x() == 0.0) found.push_back(std::atan2(-p.z(), p.y()) / (0.5 * kPi));
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found.size(), fractions.size());
  // The length is measured on 4000 chords, short of the arc by 1e-7.
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], fractions[k], 1e-6);
}

TEST(ShapeGridClosedForm, AWallStandsOnCalmWaterAndCarriesItsDeck) {
  const SurfaceMesh mesh = wallSided(uniform(5), 3, 2, [](double u) -> Vec3 {
    return {10 * u, 3.0, 2.0};
  });
  EXPECT_EQ(mesh.faces.size(), 5u * 3u + 5u * 2u);
  // Wall 10 × 2 m facing port, deck 10 × 3 m facing up; round-off of 30 m².
  EXPECT_LT((test::vectorAreaOf(mesh) - Vec3(0, 20, 30)).norm(), 1e-13);
  EXPECT_NEAR(surfaceArea(mesh), 50.0, 1e-13);
  const Bounds box = bounds(mesh);
  EXPECT_EQ(box.low, Vec3(0, 0, 0));  // exactly on calm water and on the centreplane
  EXPECT_EQ(box.high, Vec3(10, 3, 2));
}

// Sheer and flare: the wall follows the deck edge.
TEST(ShapeGrid, AWallIsVerticalUnderItsDeckEdge) {
  const auto edge = [](double u) -> Vec3 { return {10 * u, 3 - 2 * u * u, 1 + u}; };
  const SurfaceMesh mesh = wallSided(uniform(8), 2, 1, edge);
  for (const Vec3& p : mesh.vertices) {
    const Vec3 top = edge(p.x() / 10);
    EXPECT_TRUE(p.y() == 0.0 || std::abs(p.y() - top.y()) < 1e-14) << p.transpose();
    EXPECT_LE(p.z(), top.z() + 1e-14);
  }
}

// A prism stands on the waterplane: its volume is the waterplane's area times its height, exactly.
TEST(ShapeGridClosedForm, HalvesCloseToAHull) {
  const int along = 16;
  const SurfaceMesh wet = wetHalfEllipsoid({10, 2, 1.5}, along, 5);
  const SurfaceMesh dry = wallSided(uniform(along), 2, 3, [](double u) -> Vec3 {
    return {-10 * std::cos(kPi * u), 2 * std::sin(kPi * u), 0.7};
  });
  const SurfaceMesh hull = closedFromHalves(wet, dry);
  EXPECT_TRUE(openEdges(hull).empty());
  const double below = 2 * volumeIntegrals(wet).volume,
               above = 2 * 0.7 * waterplaneIntegrals(wet).area;
  EXPECT_NEAR(volumeIntegrals(hull).volume, below + above, 1e-12 * (below + above));  // round-off
  EXPECT_NEAR(volumeIntegrals(hull).moment.y(), 0.0, 1e-12 * below);
  const SurfaceMesh both = joined(wet, mirroredInY(wet));
  for (std::size_t k = 0; k < both.faces.size();
       ++k)  // the wet faces come first, port then starboard
    EXPECT_LT((vectorArea(hull, hull.faces[k]) - vectorArea(both, both.faces[k])).norm(), 1e-12);
}

}  // namespace
}  // namespace cutwater
