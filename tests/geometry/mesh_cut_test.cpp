#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

/// Turns and lowers the hull so that the plane becomes z = 0.
SurfaceMesh turnedTo(const SurfaceMesh& mesh, const Plane& plane) {
  SurfaceMesh out = mesh;
  const Vec3 axis = plane.normal.cross(Vec3::UnitZ());
  const double angle = std::atan2(axis.norm(), plane.normal.z());
  const Mat3 r = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (Vec3& p : out.vertices) p = r * p - plane.offset * Vec3::UnitZ();
  return out;
}

TEST(MeshCutIdentity, BelowAndAboveMakeTheWhole) {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  for (const SurfaceMesh& hull :
       {triangulated(closedFrigate(16, 4)), triangulated(closedSphere(5.0, 9, 5)),
        closedBox({10, 4, 2, 1}, 5, 2, 2)}) {
    const double size = bounds(hull).diagonal();
    for (int k = 0; k < 20; ++k) {
      const Plane plane{Vec3(any(random), any(random), any(random)).normalized(),
                        0.05 * size * any(random)};
      const SurfaceMesh turned = turnedTo(hull, plane);
      const SurfaceMesh below = cutBelow(turned), above = cutAbove(turned);
      const double whole = volumeIntegrals(turned).volume;
      // Faces are flat, so this is round-off, of the cube of the size.
      EXPECT_NEAR(volumeIntegrals(below).volume + volumeIntegrals(above).volume, whole,
                  1e-13 * size * size * size);
      EXPECT_NEAR(surfaceArea(below) + surfaceArea(above), surfaceArea(turned),
                  1e-11 * size * size);
      EXPECT_NEAR(waterplaneIntegrals(below).area, -waterplaneIntegrals(above).area,
                  1e-12 * size * size);
      // The same by the general plane instead of turning the hull.
      EXPECT_NEAR(surfaceArea(cutBelow(hull, plane)), surfaceArea(below), 1e-11 * size * size);
      for (const OpenEdge& e : openEdges(below))
        for (int v : {e.from, e.to})
          EXPECT_EQ(below.vertices[static_cast<std::size_t>(v)].z(), 0.0);
    }
  }
}

TEST(MeshCut, VerticesOnThePlaneStayAndNothingIsCutThere) {
  const SurfaceMesh wet = wetFrigate(32, 7), whole = closedFrigate(32, 7);
  const SurfaceMesh cut = cutAbove(cutBelow(whole), {Vec3::UnitY(), 0.0});
  ASSERT_EQ(cut.faces.size(), wet.faces.size());
  for (std::size_t k = 0; k < wet.faces.size(); ++k)
    for (int i = 0; i < wet.faces[k].size(); ++i)
      EXPECT_EQ(cut.corner(cut.faces[k], i), wet.corner(wet.faces[k], i));
}

TEST(MeshCut, RoundOffAtTheWaterlineMakesNoSlivers) {
  SurfaceMesh hull = closedFrigate(32, 7);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1e-8, 1e-8);  // m, below 1e-9 of 135 m
  for (Vec3& p : hull.vertices) p.z() += noise(random);
  const SurfaceMesh cut = cutBelow(hull);
  EXPECT_EQ(cut.faces.size(), 2 * wetFrigate(32, 7).faces.size());
}

TEST(MeshCut, QuadrilateralsStayWhereTheyCan) {
  // One square cut through its sides, one through a corner, one that loses a corner.
  const auto square = [](double turn, double z) {
    SurfaceMesh m;
    for (int i = 0; i < 4; ++i) {
      const double a = turn + 0.5 * kPi * i;
      m.vertices.emplace_back(std::cos(a), 0.0, std::sin(a) + z);
    }
    m.faces.push_back({{0, 1, 2, 3}});
    return m;
  };
  const auto sizes = [](const SurfaceMesh& m) {
    std::vector<int> n;
    for (const Face& f : cutBelow(m).faces) n.push_back(f.size());
    std::sort(n.begin(), n.end());
    return n;
  };
  EXPECT_EQ(sizes(square(0.25 * kPi, 0.1)), (std::vector<int>{4}));
  EXPECT_EQ(sizes(square(0.0, 0.5)), (std::vector<int>{3}));
  EXPECT_EQ(sizes(square(0.0, -0.5)), (std::vector<int>{3, 4}));
  EXPECT_EQ(sizes(square(0.0, 0.0)), (std::vector<int>{3}));
  EXPECT_EQ(sizes(square(0.0, 2.0)), (std::vector<int>{}));
}

TEST(MeshCut, ASaddleThatCrossesThePlaneTwiceKeepsItsNeighboursClosed) {
  SurfaceMesh box = closedBox({2, 2, 1, 1}, 1, 1, 1);
  // Push the corners of one end through the plane alternately, so that its faces cross it twice.
  for (Vec3& p : box.vertices)
    if (p.x() > 0) p.z() += (p.y() > 0.5 ? 1.2 : p.y() < -0.5 ? -1.2 : 0.3) * (p.z() > 0 ? 1 : -1);
  for (const OpenEdge& e : openEdges(cutBelow(box)))
    for (int v : {e.from, e.to})
      EXPECT_EQ(cutBelow(box).vertices[static_cast<std::size_t>(v)].z(), 0.0);
}

TEST(MeshCut, APlaneNeedsAUnitNormal) {
  EXPECT_THROW(cutBelow(closedSphere(1, 6, 3), {Vec3(1, 1, 0), 0.0}), HydroError);
}

}  // namespace
}  // namespace cutwater
