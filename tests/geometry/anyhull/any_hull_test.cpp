#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/anyhull/AnyHull.h"
#include "tests/geometry/outer/OuterBodies.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

SurfaceMesh column(int sides, double radius, double draught) {
  SurfaceMesh mesh;
  for (int i = 0; i < sides; ++i)
    for (const double z : {-draught, 3.0}) {
      const double angle = 2 * kPi * i / sides;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  mesh.vertices.emplace_back(0, 0, -draught);
  mesh.vertices.emplace_back(0, 0, 3.0);
  for (int i = 0; i < sides; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.faces.push_back({{a, b, b + 1, a + 1}});
    mesh.faces.push_back({{2 * sides, b, a, -1}});
    mesh.faces.push_back({{2 * sides + 1, a + 1, b + 1, -1}});
  }
  return mesh;
}

TEST(AnyHull, AShipIsDividedBySections) {
  const AnyHull ship = anyHull(closedFrigate(60, 16), 433, "frigate");
  EXPECT_EQ(ship.by, PanelsBy::Sections);
  EXPECT_TRUE(ship.done.empty());
  EXPECT_NEAR(ship.panelVolume, ship.volume, 0.01 * ship.volume);
}

TEST(AnyHullClosedForm, ColumnsOfAnyNumberOfSidesHaveTheirVolume) {
  for (const int sides : {3, 4, 5, 8, 12, 15, 31, 60}) {
    const AnyHull body = anyHull(column(sides, 6.0, 20.0), 433, "column");
    const double exact = 20 * 0.5 * sides * 36 * std::sin(2 * kPi / sides);
    EXPECT_NEAR(body.volume, exact, 2e-3 * exact) << sides;       // between two grids
    EXPECT_NEAR(body.panelVolume, exact, 1e-2 * exact) << sides;  // the issue of inscribed panels
  }
}

TEST(AnyHull, ARepairedHullOfTheRightVolumeStaysTheHull) {
  const SurfaceMesh drawn = column(60, 6.0, 20.0);
  const AnyHull body = anyHull(drawn, 433, "column", Symmetry::Auto, PanelsBy::Auto);
  EXPECT_EQ(body.by, PanelsBy::Surface);
  // Each side is two triangles, both cut at z = 0.
  EXPECT_LT(body.hull.surface.vertices.size(), 3 * drawn.vertices.size());
}

TEST(AnyHull, TheWayCanBeAskedFor) {
  const SurfaceMesh frigate = closedFrigate(60, 16);
  EXPECT_EQ(anyHull(frigate, 224, "frigate", Symmetry::Auto, PanelsBy::Surface).by,
            PanelsBy::Surface);
  test::expectRefusal(Fault::SectionsNotFollowed, {"column"}, [] {
    anyHull(column(60, 6.0, 20.0), 433, "column", Symmetry::Auto, PanelsBy::Sections);
  });
  test::expectRefusal(Fault::ValueOutOfRange, {"frigate", "panels = 5"},
                      [&] { anyHull(frigate, 5, "frigate"); });
}

}  // namespace
}  // namespace cutwater
