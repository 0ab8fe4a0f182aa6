#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/SurfacePanels.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

OuterSurface outerOf(const SurfaceMesh& mesh, int count = 433) {
  return outerSurface(withoutLeaks(cleanSurface(mesh, "body", Symmetry::Auto).mesh, "body"), count,
                      Symmetry::Auto);
}

/// V from each component of ∫ r n dS: the three agree for what is open on z = 0 only.
void expectClosedBelowWater(const SurfaceMesh& panels, bool half) {
  const SurfaceMesh wet = half ? bothHalves(panels) : panels;
  EXPECT_EQ(test::openEdgesBelowWater(wet), 0);
  const Vec3 area = test::vectorAreaOf(wet);
  EXPECT_LT(std::hypot(area.x(), area.y()), 1e-9 * surfaceArea(wet));
}

TEST(SurfacePanelsClosedForm, SolidsThatTouchOverlapAndHoldOneAnotherAreOneBody) {
  SurfaceMesh solids = test::box({-10, -3, -2}, {-2, 3, 2});
  solids = joined(solids, test::box({-2, -3, -2}, {4, 3, 2}));      // touches
  solids = joined(solids, test::box({3, -2.5, -2}, {10, 2.5, 2}));  // overlaps
  solids = joined(solids, test::box({-8, -1, -1}, {8, 1, 1}));      // lies within
  const OuterSurface outer = outerOf(solids);
  const double exact = 14 * 6 * 2 + 6 * 5 * 2;
  EXPECT_TRUE(outer.hull.symmetric);
  EXPECT_TRUE(outer.hull.closed);
  // Planes of exact faces: what is left is where a concave edge crosses a cell between its nodes.
  EXPECT_NEAR(outer.volume, exact, 1e-4 * exact);
  EXPECT_NEAR(outer.panelVolume, exact, 1e-3 * exact);
  EXPECT_NEAR(static_cast<double>(outer.panels.faces.size()), 433, 0.1 * 433);
  expectClosedBelowWater(outer.panels, true);
}

TEST(SurfacePanelsClosedForm, ASphereUnderWaterHasNoWaterlineAndItsVolume) {
  const SurfaceMesh sphere = test::moved(closedSphere(5.0, 60, 40), {0, 0, -8});
  const OuterSurface outer = outerOf(sphere);
  const double exact = volumeIntegrals(triangulated(sphere)).volume;
  EXPECT_NEAR(outer.volume, exact, 1e-3 * exact);       // of the fine grid, an eighth of a panel
  EXPECT_NEAR(outer.panelVolume, exact, 2e-3 * exact);  // filled out to that
  expectClosedBelowWater(outer.panels, true);
}

TEST(SurfacePanelsIdentity, WindingDoublesAndWeldsChangeNothing) {
  const SurfaceMesh frigate = closedFrigate(40, 12);
  const OuterSurface plain = outerOf(frigate),
                     spoilt =
                         outerOf(test::withDoubles(test::turnedAtRandom(test::unwelded(frigate))));
  EXPECT_NEAR(spoilt.volume, plain.volume, 1e-9 * plain.volume);
  EXPECT_EQ(spoilt.panels.faces.size(), plain.panels.faces.size());
}

TEST(SurfacePanelsIdentity, InteriorIsNoPartOfIt) {
  const SurfaceMesh frigate = closedFrigate(40, 12);
  // Where a deck meets the shell, a line may meet the deck's edge first.
  EXPECT_NEAR(outerOf(test::withInterior(frigate)).volume, outerOf(frigate).volume, 1e-4 * 4500);
}

TEST(SurfacePanels, PartsTooThinForTheGridAreSaid) {
  // Oblique plates of 4 mm on both sides of a barge of 20 m: 0.41 m³ of 320.
  SurfaceMesh plate = test::box({-8, -2, -0.004}, {8, 2, 0.0});
  for (Vec3& p : plate.vertices) p = Vec3(p.x(), 7 + 0.8 * p.y(), -2 + 0.6 * p.y() + p.z());
  const SurfaceMesh plates = joined(plate, mirroredInY(plate));
  const OuterSurface outer = outerOf(joined(test::box({-10, -4, -2}, {10, 4, 2}), plates));
  const double exact = 2 * 16 * 0.8 * 4 * 0.004;
  EXPECT_NEAR(outer.thin.volume, exact, 0.05 * exact);  // lines a tenth of the plate apart
  ASSERT_FALSE(outer.done.empty());
  EXPECT_NE(outer.done[0].find("left out"), std::string::npos) << outer.done[0];
}

}  // namespace
}  // namespace cutwater
