#include <gtest/gtest.h>

#include "hydro/geometry/outer/LeakStopping.h"
#include "tests/geometry/outer/OuterBodies.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

SurfaceMesh barge() { return triangulated(test::cubes(test::cells({-30, -4, -3}, {30, 4, 2}))); }

double volumeOf(const SurfaceMesh& mesh) { return surveyWater(mesh, 0.0).volume; }

TEST(LeakStopping, ANarrowHoleIsClosedAndSaid) {
  // One of the 1 m squares of the bottom: 1/60 of the length is not too wide.
  SurfaceMesh holed = test::withHoles(barge(), {{0.5, 0.5, -3}}, 0.4);
  ASSERT_LT(holed.faces.size(), barge().faces.size());
  const TightSurface tight = withoutLeaks(holed, "barge");
  EXPECT_NEAR(volumeOf(tight.mesh), volumeOf(barge()), 1e-6 * 1440);
  ASSERT_EQ(tight.done.size(), 1u);
  EXPECT_NE(tight.done[0].find("closed 1 hole"), std::string::npos) << tight.done[0];
}

TEST(LeakStopping, AMissingBottomIsRefusedWithItsPlaceAndWidth) {
  SurfaceMesh open = barge();
  std::erase_if(open.faces, [&](const Face& f) {
    return meanCorner(open, f).z() == -3 && std::abs(meanCorner(open, f).x()) < 15;
  });
  test::expectRefusal(Fault::HullNotClosed, {"barge", "hole", "m wide"},
                      [&] { withoutLeaks(open, "barge"); });
}

TEST(LeakStopping, HolesOfAnInnerSkinAreLeftAlone) {
  const SurfaceMesh inner = test::bowl({-18, -3, -2}, {18, 3, 1.5});
  const TightSurface tight = withoutLeaks(joined(barge(), inner), "barge");
  EXPECT_TRUE(tight.done.empty());
  EXPECT_EQ(tight.mesh.faces.size(), barge().faces.size() + inner.faces.size());
}

}  // namespace
}  // namespace cutwater
