#include <gtest/gtest.h>

#include <map>

#include "hydro/geometry/outer/GridCrossings.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

TEST(GridCrossingsIdentity, EveryLineThatEntersAClosedBodyLeavesIt) {
  const SurfaceMesh sphere = triangulated(closedSphere(5.0, 12, 8));
  const SpaceGrid grid = test::gridAround({-5, -5, -5}, {5, 5, 5}, 0.7);
  const GridCrossings crossings(sphere, grid, 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    std::map<std::size_t, int> onLine;
    for (const GridCrossing& c : crossings.along(axis)) {
      EXPECT_TRUE(crossings.blocked(c.node, axis));
      const auto at = grid.index(c.node);
      ++onLine[c.node -
               static_cast<std::size_t>(at[static_cast<std::size_t>(axis)]) * grid.stride(axis)];
    }
    EXPECT_GT(onLine.size(), 50u);
    for (const auto& [line, count] : onLine) EXPECT_EQ(count % 2, 0);
  }
}

TEST(GridCrossingsClosedForm, AWallIsMetWhereItStands) {
  const SurfaceMesh wall = test::box({-1, -1, -3}, {1.25, 1, -1});
  const SpaceGrid grid =
      test::gridAround({-1, -1.1, -3}, {1, 1, -1}, 0.5);  // no line on a diagonal
  const GridCrossings crossings(wall, grid, 0.0);
  std::size_t front = 0;
  for (const GridCrossing& c : crossings.along(0)) {
    if (c.at < 0) continue;
    ++front;
    EXPECT_NEAR(c.at, 1.25, 1e-12);  // round-off
    const auto [first, last] = crossings.on(c.node, 0);
    EXPECT_EQ(last - first, 1);
    EXPECT_EQ(first->at, c.at);
  }
  EXPECT_EQ(front, 16u);  // 4 × 4 lines
}

TEST(GridCrossings, ASlitIsBlockedUpToTwiceTheTolerance) {
  // Two plates in the plane x = 0 with 0.2 m between them, and a line right through the slit.
  SurfaceMesh mesh{{{0, -2, -2},
                    {0, -0.1, -2},
                    {0, -0.1, 0},
                    {0, -2, 0},
                    {0, 0.1, -2},
                    {0, 2, -2},
                    {0, 2, 0},
                    {0, 0.1, 0}},
                   {{{0, 1, 2, -1}}, {{0, 2, 3, -1}}, {{4, 5, 6, -1}}, {{4, 6, 7, -1}}}};
  const SpaceGrid grid({{{-0.5, 0.5}, {-1.0, 0.0, 1.0}, {-1.0, -0.5}}});
  const std::size_t through = grid.node({0, 1, 0});
  EXPECT_FALSE(GridCrossings(mesh, grid, 0.0).blocked(through, 0));
  EXPECT_FALSE(GridCrossings(mesh, grid, 0.09).blocked(through, 0));
  EXPECT_TRUE(GridCrossings(mesh, grid, 0.11).blocked(through, 0));
}

}  // namespace
}  // namespace cutwater
