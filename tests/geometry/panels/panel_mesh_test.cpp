#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/Hydrostatics.h"
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

TEST(PanelMeshIdentity, PanelsAreFlatAndStayOnTheirWaterlineVertices) {
  for (const SurfaceMesh& wet :
       {wetFrigate(32, 7), wetHemisphere(1.0, 27, 16), wetHalfEllipsoid({62.25, 7.4, 4.97}, 50, 8),
        wetWigley(wigley(1), 40, 10)}) {
    const PanelMesh mesh = makePanels(wet, true);
    ASSERT_EQ(mesh.panels.size(), wet.faces.size());
    int onWater = 0, kept = 0;
    for (std::size_t k = 0; k < mesh.panels.size(); ++k) {
      const Panel& p = mesh.panels[k];
      EXPECT_NEAR(p.normal.norm(), 1.0, 1e-14);
      for (std::size_t i = 0; i < static_cast<std::size_t>(p.corners); ++i) {
        EXPECT_LE(p.corner[i].z(), 0.0);
        // Flat to round-off of coordinates of 62 m.
        EXPECT_NEAR(p.normal.dot(p.corner[i] - p.centroid), 0.0, 1e-13 * 62.25);
        const Vec3& vertex = wet.corner(wet.faces[k], static_cast<int>(i));
        if (vertex.z() == 0.0) {
          ++onWater;
          kept += (vertex - p.corner[i]).norm() < 1e-14 * 62.25 && p.corner[i].z() == 0.0;
        }
      }
    }
    EXPECT_GT(onWater, 0);
    EXPECT_EQ(kept, onWater);
  }
}

// A plane that contains the waterline edge e cannot keep the part of the vector area along e; all
// else of it is kept, and without such an edge the whole.
TEST(PanelMeshIdentity, VectorAreaIsThatOfTheFaceButForItsPartAlongTheWaterline) {
  const SurfaceMesh wet = wetFrigate(32, 7);
  const PanelMesh mesh = makePanels(wet, true);
  for (std::size_t k = 0; k < wet.faces.size(); ++k) {
    const Face& f = wet.faces[k];
    Vec3 wanted = vectorArea(wet, f);
    for (int i = 0; i < f.size() && f.size() == 4; ++i) {
      const Vec3 &a = wet.corner(f, i), &b = wet.corner(f, (i + 1) % 4);
      if (a.z() == 0.0 && b.z() == 0.0)
        wanted -= wanted.dot((b - a).normalized()) * (b - a).normalized();
    }
    // Round-off of coordinates of 62 m times edges of 4 m.
    EXPECT_LE((mesh.panels[k].area * mesh.panels[k].normal - wanted).norm(), 1e-12) << "face " << k;
  }
}

// Divergence theorem: ∫n dS = 0 and ∫r × n dS = 0 over the closed surface of wet hull and
// waterplane, so the hull has minus the waterplane's, and of surge nothing: the frigate's transom
// is dry. The waterplane of a mesh is the polygon of its waterline. Panels flattened about the
// waterline lack 0.33 m² of frontal area a side here.
TEST(PanelMeshIdentity, PatchesOfAHullCloseWithItsWaterplane) {
  for (const SurfaceMesh& wet : {wetFrigate(48, 9, 0.0), wetFrigate(32, 7)}) {
    const PanelMesh mesh = makePanels(bothHalves(wet), false);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero(), flat = Vec3::Zero();
    for (std::size_t i = 0; i < mesh.panels.size(); ++i) {
      sum += mesh.vectorArea(i);
      moment += mesh.panels[i].centroid.cross(mesh.vectorArea(i)) + mesh.patches[i].couple;
      flat += mesh.panels[i].area * mesh.panels[i].normal;
    }
    const Hydrostatics h = hydrostatics(bothHalves(wet), Vec3::Zero(), 1.0, 1.0);
    // Round-off of areas of 1400 m² and arms of 62 m.
    EXPECT_LT((sum + h.waterplaneArea * Vec3::UnitZ()).norm(), 1e-11 * h.waterplaneArea);
    const double aboutY = h.flotation.x() * h.waterplaneArea;
    EXPECT_LT((moment - aboutY * Vec3::UnitY()).norm(), 1e-10 * h.waterplaneArea);
    EXPECT_GT(std::abs(flat.x()), 0.1) << "nothing to mend?";
  }
}

TEST(PanelMesh, CentroidOfAnUnevenFlatQuadrilateral) {
  // A trapezoid: parallel sides 3 and 1 at distance 2 has its centroid at h/3 (a + 2b)/(a + b).
  const Panel p = flatPanel({{0, 0, 0}, {3, 0, 0}, {1, 2, 0}, {0, 2, 0}});
  EXPECT_NEAR(p.area, 4.0, 1e-15);
  EXPECT_NEAR(p.centroid.y(), 2.0 / 3.0 * (3 + 2 * 1) / (3 + 1), 1e-15);
  EXPECT_NEAR(p.normal.z(), 1.0, 1e-15);
}

TEST(PanelMesh, AFaceWithoutAreaIsRefusedByNumber) {
  const SurfaceMesh wet{{{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {2, 0, -1}},
                        {{{0, 1, 2, -1}}, {{0, 1, 3, -1}}}};
  try {
    makePanels(wet, false);
    FAIL();
  } catch (const HydroError& e) {
    EXPECT_EQ(e.fault(), Fault::ValueOutOfRange);
    EXPECT_NE(std::string(e.what()).find("face 1 "), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace cutwater
