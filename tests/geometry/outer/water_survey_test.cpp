#include <gtest/gtest.h>

#include "hydro/geometry/outer/LostParts.h"
#include "hydro/geometry/outer/WaterSurvey.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

TEST(WaterSurveyClosedForm, KnowsVolumeAreaAndMiddleOfABox) {
  const SurfaceMesh box = test::box({-4, -1, -2}, {6, 1, 2});
  const WaterSurvey s = surveyWater(box, 0.0);
  // Counting nodes errs by a layer of half a cell at each wall at most.
  EXPECT_NEAR(s.volume, 40.0, 40.0 * s.spacing);
  EXPECT_NEAR(s.area, 10 * 2 + 2 * 20 + 2 * 4, 0.02 * 68);
  EXPECT_NEAR(s.middle.x(), 1.0, s.spacing);
  EXPECT_NEAR(s.middle.y(), 0.0, 1e-9);
  EXPECT_TRUE(isMirrorImage(box, s, 1e-3));
  EXPECT_EQ(s.plateArea, 0.0);
}

TEST(WaterSurvey, SeesThatOneSideHasWhatTheOtherLacks) {
  const SurfaceMesh hull = test::box({-4, -1, -2}, {4, 1, 2});
  const SurfaceMesh strake = test::box({-3, 0.9, -1}, {3, 1.2, -0.8});
  const SurfaceMesh one = joined(hull, strake), two = joined(one, mirroredInY(strake));
  EXPECT_FALSE(isMirrorImage(one, surveyWater(one, 0.0), 1e-2));
  EXPECT_TRUE(isMirrorImage(two, surveyWater(two, 0.0), 1e-2));
}

TEST(WaterSurveyClosedForm, APlateWithWaterOnBothSidesHasAnAreaAndNoVolume) {
  SurfaceMesh plate{{{-2, 3, -1}, {2, 3, -1}, {2, 5, -1.5}, {-2, 5, -1.5}}, {{{0, 1, 2, 3}}}};
  const SurfaceMesh hull = test::box({-4, -1, -2}, {4, 1, 2});
  const WaterSurvey s = surveyWater(joined(hull, triangulated(plate)), 0.0);
  EXPECT_NEAR(s.plateArea, 4 * std::hypot(2.0, 0.5), 0.05 * 8.2);  // lines of a grid count it
  EXPECT_NEAR(s.platePlace.z(), -1.25, 0.3);
  EXPECT_NEAR(s.volume, 32.0, 32.0 * s.spacing);
}

TEST(LostPartsClosedForm, APlateThinnerThanACellIsMeasuredByTheLinesThroughIt) {
  const SurfaceMesh body =
      joined(test::box({-4, -1, -2}, {4, 1, 2}), test::box({-2, 3, -1.001}, {2, 5, -1}));
  const SpaceGrid grid = test::gridAround({-4, -1, -2}, {4, 5, 2}, 0.2);
  const GridCrossings crossings(body, grid, 0.0);
  const WaterGrid water(grid, crossings, false);
  const LostParts lost = partsBetweenCrossings(water, crossings, grid.above(2, 0.0));
  EXPECT_NEAR(lost.volume, 8 * 0.001, 0.1 * 0.008);  // 20 × 10 lines of 0.04 m²
  EXPECT_NEAR(lost.place.z(), -1.0, 0.2);
}

TEST(LostPartsClosedForm, AFinBetweenTheNodesOfThePanelsIsMeasured) {
  const SurfaceMesh body =
      joined(test::box({-4, -1, -2}, {4, 1, 2}), test::box({-1, 2.2, -1.5}, {1, 2.6, -1}));
  const SpaceGrid grid = test::gridAround({-4, -1, -2}, {4, 3, 2}, 0.1);
  const WaterGrid water(grid, GridCrossings(body, grid, 0.0), false);
  const LostParts lost = partsBetweenNodes(water, 16, grid.above(2, 0.0));
  EXPECT_NEAR(lost.volume, 0.4, 0.2 * 0.4);  // nodes 0.1 m apart in 0.4 × 0.5 m
  EXPECT_NEAR(lost.place.y(), 2.4, 0.25);
}

}  // namespace
}  // namespace cutwater
