#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/geometry/wetted/SymmetricTriangles.h"
#include "hydro/geometry/wetted/WettedTriangles.h"

namespace cutwater {
namespace {

// Round-off of sums over the faces.
TEST(SymmetricTrianglesIdentity, TheVolumeIsThatOfTheFaces) {
  const SurfaceMesh hull = closedFrigate(24, 8), triangles = symmetricTriangles(hull);
  const double volume = volumeIntegrals(hull).volume;
  EXPECT_NEAR(volumeIntegrals(triangles).volume, volume, 1e-13 * volume);
  EXPECT_TRUE(openEdges(triangles).empty());
  for (const Face& face : triangles.faces) EXPECT_EQ(face.size(), 3);
}

// A hull alike to both sides, half under water: no moment about x, which one diagonal a face leaves
// (it is 3e-4 of the volume times the beam here).
TEST(SymmetricTrianglesIdentity, ASymmetricHullDoesNotList) {
  const SurfaceMesh hull = closedFrigate(24, 8);
  const auto offCentre = [](const SurfaceMesh& mesh) {
    const WettedTriangles wetted(mesh, Vec3::Zero());
    WettedTriangles::State state(wetted);
    for (std::size_t i = 0; i < state.depth.size(); ++i) state.depth[i] = -wetted.points().z[i];
    wetted.cut(Vec3::UnitZ(), state);
    return std::abs(state.centre.y());
  };
  EXPECT_LT(offCentre(symmetricTriangles(hull)), 1e-12);
  EXPECT_GT(offCentre(triangulated(hull)), 1e-4);
}

TEST(SymmetricTriangles, FlatQuadrilateralsAndTrianglesStay) {
  const SurfaceMesh box = closedBox({4.0, 2.0, 1.0, 1.0}, 2, 1, 1);
  const SurfaceMesh triangles = symmetricTriangles(box);
  EXPECT_EQ(triangles.vertices.size(), box.vertices.size());
  EXPECT_EQ(triangles.faces.size(), 2 * box.faces.size());
  EXPECT_EQ(symmetricTriangles(triangles).faces.size(), triangles.faces.size());
}

}  // namespace
}  // namespace cutwater
