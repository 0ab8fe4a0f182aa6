#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/SurfaceFitting.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

DualSurface surfaceOf(const SurfaceMesh& mesh, double spacing) {
  return dualSurface(test::waterAround(mesh, spacing), test::unitNormals(mesh), false);
}

double shortestEdge(const SurfaceMesh& mesh) {
  double shortest = 1e300;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < f.size(); ++i)
      shortest =
          std::min(shortest, (mesh.corner(f, i) - mesh.corner(f, (i + 1) % f.size())).norm());
  return shortest;
}

TEST(SurfaceFittingIdentity, WhatIsMergedStaysClosed) {
  DualSurface s = surfaceOf(triangulated(closedSphere(2.0, 40, 30)), 0.4);
  const std::size_t faces = s.mesh.faces.size();
  mergeShortEdges(s, 0.25);
  mergeShortEdges(s, 0.25);
  EXPECT_LT(s.mesh.faces.size(), faces);
  EXPECT_GT(s.mesh.faces.size(), faces / 2);
  EXPECT_TRUE(openEdges(s.mesh).empty());
  EXPECT_GT(shortestEdge(s.mesh), 0.2);  // an end of a merged edge may have come nearer
  EXPECT_EQ(s.hold.size(), s.mesh.vertices.size());
}

TEST(SurfaceFittingClosedForm, APlateThinnerThanThatKeepsItsThickness) {
  // 4 × 4 × 0.05 m on a grid of 0.5 m with a plane of nodes in the plate.
  const SurfaceMesh plate = test::box({-2, -2, -1.05}, {2, 2, -1}), &mesh = plate;
  SpaceGrid::Planes planes;
  for (double p = -3.13; p < 3.2; p += 0.5) {
    planes[0].push_back(p);
    planes[1].push_back(p);
  }
  planes[2] = {-2.0, -1.5, -1.025, -0.5, -0.2};
  const SpaceGrid grid(planes);
  const WaterGrid water(grid, GridCrossings(mesh, grid, 0.0), false);
  DualSurface s = dualSurface(water, test::unitNormals(mesh), false);
  mergeShortEdges(s, 0.15);
  EXPECT_NEAR(volumeIntegrals(s.mesh).volume, 0.8, 1e-9);
  EXPECT_TRUE(openEdges(s.mesh).empty());
}

TEST(SurfaceFittingIdentity, SmoothedVerticesLieOnTheSurface) {
  const SurfaceMesh sphere = triangulated(closedSphere(2.0, 64, 48));
  DualSurface s = surfaceOf(sphere, 0.4);
  const SurfaceTree tree(sphere);
  smooth(s, tree, 4);
  for (const Vec3& p : s.mesh.vertices) EXPECT_LT(tree.distance(p), 1e-12);  // round-off
}

TEST(SurfaceFittingClosedForm, FilledOutARoundBodyHasItsVolumeAndABoxStaysAsItIs) {
  const SurfaceMesh sphere = triangulated(closedSphere(2.0, 64, 48));
  DualSurface s = surfaceOf(sphere, 0.4);
  const SurfaceTree tree(sphere);
  smooth(s, tree, 4);
  const double exact = volumeIntegrals(sphere).volume;
  EXPECT_LT(volumeIntegrals(s.mesh).volume, 0.995 * exact);
  fillOut(s, tree, exact, 0.03 * 0.4);
  EXPECT_NEAR(volumeIntegrals(s.mesh).volume, exact, 1e-6 * exact);  // what rounds of Newton leave

  const SurfaceMesh box = test::box({-2, -1, -3}, {2, 1, -1});
  DualSurface flat = surfaceOf(box, 0.3);
  const std::vector<Vec3> before = flat.mesh.vertices;
  fillOut(flat, SurfaceTree(box), 17.0, 0.1);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((flat.mesh.vertices[i] - before[i]).norm(), 1e-9);
}

TEST(SurfaceFitting, NoVertexIsFilledOutBeyondTheLimit) {
  const SurfaceMesh sphere = triangulated(closedSphere(2.0, 64, 48));
  DualSurface s = surfaceOf(sphere, 0.4);
  const std::vector<Vec3> before = s.mesh.vertices;
  fillOut(s, SurfaceTree(sphere), 100.0, 0.01);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LE((s.mesh.vertices[i] - before[i]).norm(), 0.01 + 1e-12);
}

}  // namespace
}  // namespace cutwater
