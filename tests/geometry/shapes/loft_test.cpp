#include "hydro/geometry/shapes/Loft.h"

#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/Hydrostatics.h"
#include "tests/support/Hulls.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

std::vector<Vec3> wedgeOffsets() {
  std::vector<Vec3> points;
  for (int i = 0; i <= 8; ++i)
    for (const double z : {2.0, 1.0, 0.0, -1.0, -2.0})
      points.emplace_back(20.0 - 5.0 * i, 3.0 * (z + 2.0) / 2.0, z);
  return points;
}

// A prism whose sections are straight: splines reproduce straight lines, so its volume is L·B·T/2
// but for the rounded stem, half a disc of the half breadth at each height: (π/2) ∫y² dz.
TEST(LoftClosedForm, StraightSectionsStayStraight) {
  const LoftedHull loft(wedgeOffsets());
  const Hull hull = makeHull(loft.closed(40, 20), "wedge", Symmetry::Auto);
  EXPECT_TRUE(hull.closed);
  const Hydrostatics h = hydrostatics(wholeWetSurface(hull), Vec3::Zero(), 1000.0, 9.81);
  const double prism = 40.0 * 6.0 * 2.0 / 2, nose = 0.5 * kPi * 9.0 * 2.0 / 3;
  // Two strips inscribed in a quarter of a circle: 2·½ sin 45° of π/4. Its own curvature in z:
  // none.
  const double inscribed = std::sin(kPi / 4) / (kPi / 4);
  EXPECT_NEAR(h.volume, prism + inscribed * nose, 1e-3 * nose);
  EXPECT_NEAR(h.beam, 6.0, 1e-9);
}

// Particulars kept with the offsets: mass 2.460962e7 kg, C33 3.16839e7 N/m at 1025 kg/m³ and
// 9.81 m/s², centre of gravity 2.5475 m aft. Another maker's integration of 24 sections: 0.5 % of V
// and C33, 0.1 % of the length.
TEST(LoftVerification, S175HasThePublishedParticulars) {
  const test::TestHull s175 = test::testS175();
  const Hydrostatics h =
      hydrostatics(wholeWetSurface(s175.hull), Vec3(-2.5475, 0, 0.05), 1025.0, 9.81);
  EXPECT_NEAR(h.volume / (2.460962e7 / 1025.0), 1.0, 5e-3);
  EXPECT_NEAR(h.restoring(2, 2) / 3.16839e7, 1.0, 5e-3);
  EXPECT_NEAR(h.buoyancy.x(), -2.5475, 0.175);
  EXPECT_NEAR(h.beam, 25.4, 1e-6);
  test::recordResult("Geometry", "S-175 lofted: V relative error", "24009 m3",
                     h.volume / (2.460962e7 / 1025.0) - 1, "± 0.005");
}

TEST(Loft, ATableInTheWrongOrderIsRefused) {
  std::vector<Vec3> rising = wedgeOffsets();
  std::swap(rising[1], rising[2]);
  EXPECT_THROW(LoftedHull{rising}, HydroError);
  std::vector<Vec3> backwards = wedgeOffsets();
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_THROW(LoftedHull{backwards}, HydroError);
  EXPECT_THROW(LoftedHull({{1, 1, 1}, {1, 1, 0}, {1, 0, -1}}), HydroError);
}

}  // namespace
}  // namespace cutwater
