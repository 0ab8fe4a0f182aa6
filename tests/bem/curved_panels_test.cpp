#include <gtest/gtest.h>

#include <cmath>

#include "hydro/bem/solution/Radiation.h"
#include "tests/bem/Bodies.h"

// Curved panels of a floating hemisphere of radius 1: integrals over the sphere, no flow is solved.
namespace cutwater::test {
namespace {

struct CurvedSphere {
  CurvedSphere(int around, int down)
      : wet(wetHemisphere(1.0, around, down)),
        mesh(panels(wet, true, false, PanelShape::Curved)),
        normals(mesh, kG, wet) {}
  static inline const Vec3 kG{0.0, 0.0, -0.3};
  SurfaceMesh wet;
  PanelMesh mesh;
  ModeNormals normals;
};

/// Relative errors of the patches' vector areas, whose sum over the port half is that of half a
/// disc on calm water and of as much on the centreline.
std::array<double, 2> discErrors(int around, int down) {
  const CurvedSphere sphere(around, down);
  Vec3 sum = Vec3::Zero();
  for (const PanelPatch& patch : sphere.mesh.patches) sum += patch.vectorArea;
  EXPECT_NEAR(sum.x(), 0.0, 1e-12);
  return {sum.y() / (0.5 * kPi) - 1.0, sum.z() / (-0.5 * kPi) - 1.0};
}

// Patches meet, so that only the arcs of the rim tell: parabolas for circles, fourth order in the
// angle between two vertices. Chords, as flat panels have, would be of second order.
TEST(CurvedPanelsConvergence, VectorAreasSumToTheDiscAtFourthOrder) {
  const auto coarse = discErrors(16, 10), fine = discErrors(32, 20);
  for (std::size_t i = 0; i < coarse.size(); ++i)
    EXPECT_GT(std::log2(std::abs(coarse[i] / fine[i])), 3.5) << coarse[i] << ' ' << fine[i];
}

/// Errors, over V, of ∫x n_1 dS = ∫y n_2 dS = ∫z n_3 dS = V and of ∫x n_5 dS, n_5 about G, which is
/// V(z_B − z_G) + ∫x² of the waterplane: z_B = −3/8, π/4.
std::array<double, 4> sphereErrors(int around, int down) {
  const CurvedSphere sphere(around, down);
  const auto integral = [&](int mode, int axis) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sphere.mesh.panels.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      sum += 2.0 * sphere.normals.area[row] * sphere.normals.velocity(row, mode) *
             sphere.mesh.panels[i].centroid[axis];
    }
    return sum;
  };
  const double volume = 2.0 * kPi / 3.0;
  const double pitch = volume * (-0.375 - CurvedSphere::kG.z()) + 0.25 * kPi;
  return {integral(Surge, 0) / volume - 1.0, integral(Sway, 1) / volume - 1.0,
          integral(Heave, 2) / volume - 1.0, (integral(Pitch, 0) - pitch) / volume};
}

// The weights take x and n_j as linear on a panel. Fourth order, since what they leave out, cubic
// in the distance from the centroid, is odd; 3.5 allows for the pole, where panels are triangles.
// With n_j ΔS of the moved panels it is the second.
TEST(CurvedPanelsConvergence, WeightsIntegrateAtFourthOrder) {
  const auto coarse = sphereErrors(16, 10), fine = sphereErrors(32, 20);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_LT(std::abs(fine[i]), 5e-5) << i;
    EXPECT_GT(std::log2(coarse[i] / fine[i]), 3.5) << i;
  }
}

// Mirror images for neighbours across the centreline are the whole hull's own. Round-off of the
// fits.
TEST(CurvedPanelsIdentity, HalfHullHasTheWeightsOfTheWhole) {
  const CurvedSphere half(8, 5);
  const SurfaceMesh both = bothHalves(half.wet);
  const PanelMesh mesh = panels(both, false, false, PanelShape::Curved);
  const ModeNormals whole(mesh, CurvedSphere::kG, both);
  const Eigen::Index count = half.normals.velocity.rows();
  EXPECT_LT((whole.velocity.topRows(count) - half.normals.velocity).cwiseAbs().maxCoeff(), 1e-9);
}

// A box is a surface of planes and believed to be, a sphere curves everywhere alike, and a bilge of
// few panels does neither: there the panels stay flat and say nothing of the surface.
TEST(CurvedPanelsIdentity, AutoCurvesWhereTheNormalsAgree) {
  const auto share = [](const SurfaceMesh& wet) {
    double curved = 0.0, area = 0.0;
    const PanelMesh mesh = solverPanels(wet, true, PanelShape::Auto);
    for (std::size_t i = 0; i < mesh.panels.size(); ++i) {
      curved += mesh.patches[i].curved * mesh.panels[i].area;
      area += mesh.panels[i].area;
    }
    return curved / area;
  };
  EXPECT_EQ(share(wetBox({20.0, 6.0, 4.0, 0.0}, 5, 2, 2)), 1.0);
  for (const PanelPatch& patch :
       solverPanels(wetBox({20.0, 6.0, 4.0, 0.0}, 5, 2, 2), true, PanelShape::Auto).patches)
    EXPECT_EQ(patch.bend, Eigen::Matrix3d::Zero());
  EXPECT_GT(share(wetHemisphere(1.0, 27, 16)), 0.98);
  const double frigate = share(wetFrigate(48, 9, 0.0));
  EXPECT_GT(frigate, 0.1);
  EXPECT_LT(frigate, 0.6);
}

// What the sum of n dS has to be does not depend on which panels are curved: patches meet.
TEST(CurvedPanelsIdentity, PatchesOfAMixedHullHaveNoFrontalAreaInAll) {
  const PanelMesh mesh = solverPanels(wetFrigate(48, 9, 0.0), true, PanelShape::Auto);
  double sum = 0.0;
  for (const PanelPatch& patch : mesh.patches) sum += patch.vectorArea.x();
  EXPECT_NEAR(sum, 0.0, 1e-9);  // round-off of 500 m² of side
}

}  // namespace
}  // namespace cutwater::test
