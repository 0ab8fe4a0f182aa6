#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/panels/Lid.h"
#include "hydro/geometry/panels/SolverPanels.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

void expectSame(const std::vector<Panel>& a, const std::vector<Panel>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].corner, b[i].corner) << i;
    EXPECT_EQ(a[i].corners, b[i].corners) << i;
    EXPECT_EQ(a[i].centroid, b[i].centroid) << i;
    EXPECT_EQ(a[i].normal, b[i].normal) << i;
    EXPECT_EQ(a[i].area, b[i].area) << i;
  }
}

TEST(WetSurface, PanelsAreTheSolversOfEveryShape) {
  const SurfaceMesh wet = wetFrigate(16, 5);
  for (const PanelShape shape : {PanelShape::FlattenedOnly, PanelShape::MovedOnly, PanelShape::Flat,
                                 PanelShape::Curved, PanelShape::Auto}) {
    const PanelMesh panels = WetSurface(wet, true, shape).panels();
    const PanelMesh expected = solverPanels(wet, true, shape);
    expectSame(panels.panels, expected.panels);
    const bool old = shape == PanelShape::FlattenedOnly || shape == PanelShape::MovedOnly;
    EXPECT_EQ(panels.patches.size(), old ? 0u : wet.faces.size());
    EXPECT_TRUE(panels.symmetric);
    EXPECT_TRUE(panels.lid.empty());
  }
  EXPECT_FALSE(WetSurface(bothHalves(wet), false).panels().symmetric);
}

TEST(WetSurface, TheLidIsMakeLids) {
  const SurfaceMesh wet = wetHalfEllipsoid({10.0, 3.0, 2.0}, 12, 4);
  for (const double length : {0.0, 0.8}) {
    const PanelMesh mesh = WetSurface(wet, true).panelsWithLid(length);
    expectSame(mesh.panels, WetSurface(wet, true).panels().panels);
    expectSame(mesh.lid, makeLid(wet, true, length));
    EXPECT_FALSE(mesh.lid.empty());
  }
}

// Quadrilaterals out of plane become two triangles each, whose edges are the mesh's: nothing is
// lost between them. Round-off of a sum of 2000 m² and 2300 m³.
TEST(WetSurfaceIdentity, FacesCloseTheSurface) {
  const SurfaceMesh wet = wetFrigate(32, 7);
  const PanelMesh faces = WetSurface(wet, true, PanelShape::Curved).faces();
  Vec3 area = Vec3::Zero(), expected = Vec3::Zero();
  double volume = 0.0;
  for (const Panel& triangle : faces.panels) {
    EXPECT_EQ(triangle.corners, 3);
    area += triangle.area * triangle.normal;
    volume += triangle.area * triangle.normal.dot(triangle.centroid) / 3.0;
  }
  for (const Face& face : wet.faces) expected += vectorArea(wet, face);
  EXPECT_LT((area - expected).norm(), 1e-9);
  EXPECT_NEAR(volume, volumeIntegrals(triangulated(wet)).volume, 1e-9);
}

TEST(WetSurface, EmptyIsWithoutFaces) {
  const SurfaceMesh none, wet = wetWigley(wigley(1), 4, 3);
  EXPECT_TRUE(WetSurface(none, false).empty());
  EXPECT_FALSE(WetSurface(wet, true).empty());
}

}  // namespace
}  // namespace cutwater
