#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/geometry/outer/GridPlanes.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

TEST(GridPlanes, OfYTheyLieAlikeOnBothSidesAndTheLastOfZIsCalmWater) {
  const GridPlan plan{{{-10, -3, -2}, {10, 3, 4}}, 0.5, false, {}};
  const SpaceGrid::Planes planes = coarsePlanes(plan);
  for (const auto& p : planes) EXPECT_TRUE(std::is_sorted(p.begin(), p.end()));
  const std::vector<double>& y = planes[1];
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(y[i], -y[y.size() - 1 - i]);
  EXPECT_LT(planes[2].back(), 0.0);
  EXPECT_GT(planes[2].back(), -1e-5);
  EXPECT_LT(planes[2].front(), -2.5);
  EXPECT_LT(planes[0].front(), -10.5);
  EXPECT_GT(planes[0].back(), 10.5);
}

TEST(GridPlanes, AHalfBeginsAtTheCentreplane) {
  const SpaceGrid::Planes planes = coarsePlanes({{{-10, -3, -2}, {10, 3, 4}}, 0.5, true, {}});
  EXPECT_GT(planes[1].front(), 0.0);
  EXPECT_LT(planes[1].front(), 1e-5);
}

TEST(GridPlanes, FinePlanesHoldTheCoarseOnesAndGoUpToTheTop) {
  const SpaceGrid::Planes coarse = coarsePlanes({{{-10, -3, -2}, {10, 3, 4}}, 0.5, false, {}});
  const FinePlanes fine = finePlanes(coarse, 4, 4.0);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < coarse[axis].size(); ++i)
      EXPECT_EQ(fine.planes[axis][4 * i], coarse[axis][i]);
  EXPECT_EQ(fine.planes[2][static_cast<std::size_t>(fine.top)], coarse[2].back());
  EXPECT_GT(fine.planes[2].back(), 4.0);
}

TEST(GridPlanes, AThinPlateGetsAPlaneInItsMiddle) {
  // A column on a plate of 0.1 m, panels of 1 m.
  const SurfaceMesh body =
      joined(test::box({-1, -1, -6}, {1, 1, 2}), test::box({-5, -5, -6}, {5, 5, -5.9}));
  const WaterSurvey survey = surveyWater(body, 0.0);
  const SpaceGrid::Planes extra = planesOfThinParts(survey.water, survey.crossings, 1.0, false);
  EXPECT_TRUE(extra[0].empty());
  EXPECT_TRUE(extra[1].empty());
  ASSERT_EQ(extra[2].size(), 1u);
  EXPECT_NEAR(extra[2][0], -5.95, 1e-6);
  const SpaceGrid::Planes planes = coarsePlanes({bounds(body), 1.0, false, extra});
  EXPECT_EQ(std::count(planes[2].begin(), planes[2].end(), extra[2][0]), 1);
}

TEST(GridPlanes, ASkegOnTheCentreplaneGetsOneAtAQuarterOfItsThickness) {
  const SurfaceMesh body =
      joined(test::box({-10, -3, -2}, {10, 3, 2}), test::box({-8, -0.1, -4}, {2, 0.1, -1}));
  const WaterSurvey survey = surveyWater(body, 0.0);
  EXPECT_TRUE(isMirrorImage(body, survey, 1e-3));
  const SpaceGrid::Planes extra = planesOfThinParts(survey.water, survey.crossings, 1.0, true);
  ASSERT_EQ(extra[1].size(), 1u);
  EXPECT_NEAR(extra[1][0], 0.05, 1e-6);
}

}  // namespace
}  // namespace cutwater
