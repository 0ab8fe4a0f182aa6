#include <gtest/gtest.h>

#include "hydro/Errors.h"
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
