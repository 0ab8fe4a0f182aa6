#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/geometry/HullShells.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/repair/ShellSplit.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

/// 2 × 2 m at the origin, sides along these axes; as one quadrilateral.
SurfaceMesh square(const Vec3& u, const Vec3& v, const Vec3& at = Vec3(0, 0, -3)) {
  return {{at - u - v, at + u - v, at + u + v, at - u + v}, {{{0, 1, 2, 3}}}};
}

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

/// Area of the faces on the side of this normal of a plane through a point; none may lie on both.
double areaBeside(const SurfaceMesh& mesh, const Vec3& normal, const Vec3& point) {
  double area = 0.0;
  for (const Face& f : mesh.faces) {
    double least = 1e300, most = -1e300;
    for (int i = 0; i < f.size(); ++i) {
      least = std::min(least, normal.dot(mesh.corner(f, i) - point));
      most = std::max(most, normal.dot(mesh.corner(f, i) - point));
    }
    EXPECT_FALSE(least < -1e-5 && most > 1e-5);  // corners within 1e-6 of 5 m are one
    area += least + most > 1e-5 ? vectorArea(mesh, f).norm() : 0.0;
  }
  return area;
}

TEST(ShellSplitIdentity, WithoutACrossingOnlyTrianglesAreMade) {
  const SurfaceMesh body = test::cubes(test::cells({0, 0, -2}, {3, 2, 0})),
                    wanted = triangulated(body);
  const SplitSurface same = splitWhereCrossing(body);
  EXPECT_EQ(same.split, 0u);
  EXPECT_EQ(same.firstCut, static_cast<int>(body.vertices.size()));
  ASSERT_EQ(same.mesh.faces.size(), wanted.faces.size());
  EXPECT_NEAR(surfaceArea(same.mesh), surfaceArea(body), 1e-12);  // round-off of 64 triangles
  EXPECT_TRUE(openEdges(same.mesh).empty());
  EXPECT_TRUE(splitWhereCrossing({}).mesh.faces.empty());
}

// Two squares of 4 m² that cross in their middle lines: four parts, each of 2 m².
TEST(ShellSplitClosedForm, TwoSquaresBecomeFourHalves) {
  const SplitSurface split = splitWhereCrossing(joined(square(kX, kY), square(kX, kZ)));
  EXPECT_EQ(split.split, 4u);                       // triangles
  EXPECT_NEAR(surfaceArea(split.mesh), 8.0, 1e-5);  // corners within 1e-6 of 3.5 m are one
  for (const Vec3& normal : {kY, Vec3(-kY), kZ, Vec3(-kZ)})
    EXPECT_NEAR(areaBeside(split.mesh, normal, Vec3(0, 0, -3)), 2.0, 1e-5);
}

TEST(ShellSplit, VerticesMadeBySplittingComeLast) {
  const SurfaceMesh far = test::moved(square(kX, kY), {20, 0, 0});
  const SplitSurface split =
      splitWhereCrossing(joined(far, joined(square(kX, kY), square(kX, kZ))));
  EXPECT_EQ(split.firstCut, 4);  // those of the square that is not crossed
  int onLine = 0;
  for (std::size_t v = 4; v < split.mesh.vertices.size(); ++v) {
    const Vec3& p = split.mesh.vertices[v];
    onLine += std::abs(p.y()) < 1e-9 && std::abs(p.z() + 3) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(onLine, 3);  // both ends of the line, and where the diagonals cross it
}

TEST(ShellSplit, ThePlaceOfTheFirstCrossingIsACornerOfIts) {
  const SurfaceMesh far = test::moved(square(kX, kY), {20, 0, 0});
  const SplitSurface split =
      splitWhereCrossing(joined(far, joined(square(kX, kY), square(kX, kZ))));
  EXPECT_LT((split.first - Vec3(0, 0, -3)).norm(), 1.5);  // half a diagonal is 1.41 m
}

// Only the part of a face that the other passes through is divided off.
TEST(ShellSplitClosedForm, AShortCrossingKeepsTheArea) {
  const SurfaceMesh two = joined(square(3 * kX, 3 * kY), square(0.5 * kX, 0.5 * kZ));
  const SplitSurface split = splitWhereCrossing(two);
  EXPECT_GT(split.split, 0u);
  EXPECT_NEAR(surfaceArea(split.mesh), 36 + 1, 1e-4);  // 1e-6 of 9 m times an edge of 6 m
  EXPECT_EQ(splitWhereCrossing(split.mesh).split, 0u);
}

TEST(ShellSplit, WhatOnlyTouchesIsLeftAlone) {
  const SurfaceMesh base = square(kX, kY);
  for (const SurfaceMesh& other :
       {square(kX, kY, {0.5, 0.5, -3}),  // in one plane
        square(kX, kY, {0, 0, -3.1}),    // parallel
        square(kX, kZ, {0, 1.1, -3}),    // beside it
        square(kX, kZ, {2, 0, -3}),      // touches its side from end to end of nothing
        square(0.5 * (kX + kZ), kY, {1.5, 0, -2.5})})  // an edge on its edge
    EXPECT_EQ(splitWhereCrossing(joined(base, other)).split, 0u) << other.vertices[0].transpose();
}

TEST(ShellSplit, NeighboursMayFoldSharply) {
  SurfaceMesh fold{{{0, 0, -3}, {1, 0, -3}, {0, 1, -3}, {1, 1, -2.99}, {0.3, 0.3, -2.5}},
                   {{{0, 1, 2, -1}}, {{1, 3, 2, -1}}, {{0, 4, 3, -1}}}};
  EXPECT_EQ(splitWhereCrossing(fold).split, 0u);  // each shares a vertex with each
}

// Signed volumes add up whatever crosses whatever; after splitting nothing crosses any more.
TEST(ShellSplitIdentity, BodiesThatPassThroughOneAnotherKeepAreaAndVolume) {
  SurfaceMesh box = test::cubes(test::cells({0, 0, 0}, {2, 2, 2}));
  for (Vec3& p : box.vertices) p = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()) * p;
  const SurfaceMesh hull = test::cubes(test::cells({0, 0, -4}, {4, 3, -1}));
  const SurfaceMesh both = joined(hull, test::moved(box, {1.1, 1.2, -2.2}));
  const SplitSurface split = splitWhereCrossing(both),
                     mixed = splitWhereCrossing(test::shuffled(both));
  EXPECT_GT(split.split, 10u);
  for (const SplitSurface& s : {split, mixed}) {
    // Corners within 1e-6 of 7 m are one: that much times an area of 90 m² at most.
    EXPECT_NEAR(volumeIntegrals(s.mesh).volume, 36 + 8, 1e-4);
    EXPECT_NEAR(surfaceArea(s.mesh), 66 + 24, 1e-3);
    EXPECT_EQ(splitWhereCrossing(s.mesh).split, 0u);
    EXPECT_TRUE(looseEdges(s.mesh).empty());  // all parts share their edges
  }
}

}  // namespace
}  // namespace cutwater
