#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/DualSurface.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

DualSurface surfaceOf(const SurfaceMesh& mesh, double spacing) {
  return dualSurface(test::waterAround(mesh, spacing), test::unitNormals(mesh), false);
}

TEST(DualSurfaceClosedForm, ABoxKeepsItsEdgesAndCorners) {
  const DualSurface s = surfaceOf(test::box({-2, -1, -3}, {2, 1, -1}), 0.3);
  EXPECT_NEAR(volumeIntegrals(s.mesh).volume, 16.0, 1e-9);  // least squares of exact planes
  EXPECT_NEAR(surfaceArea(s.mesh), 40.0, 1e-9);
  EXPECT_TRUE(openEdges(s.mesh).empty());
  int corners = 0;
  for (const VertexHold& h : s.hold) corners += h.planes == 3 ? 1 : 0;
  EXPECT_EQ(corners, 8);
}

TEST(DualSurfaceConvergence, ASpheresVolumeComesAtSecondOrder) {
  const SurfaceMesh sphere = triangulated(closedSphere(2.0, 64, 48));
  const double exact = volumeIntegrals(sphere).volume;
  const double coarse = 1 - volumeIntegrals(surfaceOf(sphere, 0.4).mesh).volume / exact;
  const double fine = 1 - volumeIntegrals(surfaceOf(sphere, 0.2).mesh).volume / exact;
  // Vertices lie on tangent planes, so that the body is between inscribed and circumscribed.
  EXPECT_LT(std::abs(coarse), 0.02);
  EXPECT_GT(std::abs(coarse) / std::abs(fine), 3.0);  // 4 of second order; lines meet it at random
}

TEST(DualSurfaceIdentity, BodiesThatTouchInACellKeepVerticesOfTheirOwn) {
  const SurfaceMesh two =
      joined(test::box({-2, -1, -3}, {-0.1, 1, -1}), test::box({0.1, -1, -3}, {2, 1, -1}));
  const Bounds b = bounds(two);
  // A plane of nodes runs through the gap.
  SpaceGrid::Planes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (double p = b.low[axis] - 1.0; p < b.high[axis] + 1.0; p += 0.499)
      planes[static_cast<std::size_t>(axis)].push_back(p);
  for (double& x : planes[0]) x -= planes[0][6];
  const SpaceGrid grid(planes);
  const WaterGrid water(grid, GridCrossings(two, grid, 0.0), false);
  const DualSurface s = dualSurface(water, test::unitNormals(two), false);
  EXPECT_NEAR(volumeIntegrals(s.mesh).volume, 2 * 1.9 * 2 * 2, 1e-9);
  EXPECT_TRUE(openEdges(s.mesh).empty());
}

TEST(DualSurfaceIdentity, AtCalmWaterItIsOpenOnTheWaterlineOnly) {
  const SurfaceMesh hull = triangulated(closedFrigate(30, 10));
  const WaterSurvey survey = surveyWater(hull, 0.0);
  const DualSurface s = dualSurface(survey.water, test::unitNormals(hull), true);
  EXPECT_EQ(test::openEdgesBelowWater(s.mesh), 0);
  for (std::size_t i = 0; i < s.hold.size(); ++i)
    if (s.hold[i].onWater) {
      EXPECT_EQ(s.mesh.vertices[i].z(), 0.0);
    }
}

}  // namespace
}  // namespace cutwater
