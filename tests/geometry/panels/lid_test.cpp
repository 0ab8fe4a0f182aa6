#include "hydro/geometry/panels/Lid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

double area(const std::vector<Panel>& lid) {
  double sum = 0.0;
  for (const Panel& p : lid) sum += p.area;
  return sum;
}

void expectUpright(const std::vector<Panel>& lid) {
  for (const Panel& p : lid) {
    EXPECT_EQ(p.normal, Vec3(0, 0, 1));
    EXPECT_GT(p.area, 0.0);
    for (const Vec3& c : p.corner) EXPECT_EQ(c.z(), 0.0);
  }
}

TEST(LidIdentity, AreaIsTheWaterplaneOfThePanelledHull) {
  for (const SurfaceMesh& half : {wetBox({10, 4, 2, 1}, 10, 2, 2), wetFrigate(32, 7),
                                  wetFrigate(48, 9), wetWigley(wigley(3), 40, 10)}) {
    const SurfaceMesh whole = bothHalves(half);
    const std::vector<Panel> port = makeLid(half, true), both = makeLid(whole, false);
    expectUpright(port);
    expectUpright(both);
    // Stations pass through every waterline vertex here: round-off of the sum only.
    EXPECT_NEAR(area(port) / waterplaneIntegrals(half).area, 1.0, 1e-9);
    EXPECT_NEAR(area(both) / waterplaneIntegrals(whole).area, 1.0, 1e-9);
  }
}

TEST(LidConvergence, BluntEndsAreCoveredToo) {
  for (const auto& [around, down] : {std::pair{12, 8}, {27, 16}, {40, 26}}) {
    const SurfaceMesh half = wetHemisphere(1.0, around, down);
    const std::vector<Panel> lid = makeLid(half, true);
    expectUpright(lid);
    // Kinks up to 0.05 of a panel's length l = π/around may be cut off, along a few panels at each
    // end: less than 2 l · 0.05 l.
    const double l = kPi / around;
    EXPECT_NEAR(area(lid), waterplaneIntegrals(half).area, 0.1 * l * l);
    for (const Panel& p : lid) EXPECT_GT(p.area, 0.02 * l * l);  // no slivers
  }
}

TEST(LidIdentity, ACatamaranHasItsLidInTheHullsOnly) {
  const SurfaceMesh one = bothHalves(wetWigley(wigley(3), 40, 10));
  SurfaceMesh hull = one;
  for (Vec3& p : hull.vertices) p.y() += 0.5;
  const std::vector<Panel> half = makeLid(hull, true);
  const std::vector<Panel> whole = makeLid(joined(hull, mirroredInY(hull)), false);
  EXPECT_NEAR(area(half) / waterplaneIntegrals(one).area, 1.0, 1e-9);
  EXPECT_NEAR(area(whole), 2 * area(half), 1e-9);
  for (const Panel& p : whole) EXPECT_GT(std::abs(p.centroid.y()), 0.35);
}

TEST(LidIdentity, AMoonpoolStaysOpen) {
  const SurfaceMesh outer = bothHalves(wetBox({10, 6, 2, 1}, 5, 3, 2));
  const SurfaceMesh pool = turnedOver(bothHalves(wetBox({4, 2, 2, 1}, 2, 1, 2)));
  const std::vector<Panel> lid = makeLid(joined(outer, pool), false);
  EXPECT_NEAR(area(lid), 60.0 - 8.0, 1e-12);
  for (const Panel& p : lid)
    EXPECT_FALSE(std::abs(p.centroid.x()) < 2 && std::abs(p.centroid.y()) < 1);
}

TEST(Lid, PanelsAreAboutTheSizeAskedFor) {
  const std::vector<Panel> lid = makeLid(wetBox({12, 8, 2, 1}, 4, 2, 1), true, 1.0);
  EXPECT_EQ(lid.size(), 48u);
  for (const Panel& p : lid) EXPECT_NEAR(p.area, 1.0, 1e-12);
}

TEST(Lid, NoWaterlineNoLid) {
  SurfaceMesh deep = closedSphere(1.0, 8, 4);
  for (Vec3& p : deep.vertices) p.z() -= 2.0;
  EXPECT_TRUE(makeLid(deep, false).empty());
}

TEST(Lid, ALooseWaterlineIsRefused) {
  SurfaceMesh wet = bothHalves(wetBox({10, 4, 2, 1}, 5, 2, 2));
  std::erase_if(wet.faces, [&](const Face& f) {  // one panel of the starboard side
    double low = 0.0, high = -9.0;
    for (int i = 0; i < f.size(); ++i) {
      low = std::max(low, wet.corner(f, i).y() + 2.0);
      high = std::max(high, wet.corner(f, i).z());
    }
    return low == 0.0 && high == 0.0 && wet.corner(f, 0).x() > 2.5;
  });
  EXPECT_THROW(makeLid(wet, false), HydroError);
}

}  // namespace
}  // namespace cutwater
