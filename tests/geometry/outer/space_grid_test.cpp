#include <gtest/gtest.h>

#include "hydro/geometry/outer/SpaceGrid.h"

namespace cutwater {
namespace {

TEST(SpaceGrid, NumbersOfNodesGoThereAndBack) {
  const SpaceGrid grid({{{0, 1, 2, 4}, {0, 1, 3}, {-2, -1}}});
  EXPECT_EQ(grid.nodes(), 24u);
  for (std::size_t node = 0; node < grid.nodes(); ++node)
    EXPECT_EQ(grid.node(grid.index(node)), node);
  EXPECT_EQ(grid.node({1, 2, 1}) + grid.stride(0), grid.node({2, 2, 1}));
  EXPECT_EQ(grid.node({1, 1, 0}) + grid.stride(2), grid.node({1, 1, 1}));
  EXPECT_EQ(grid.place({3, 2, 0}), Vec3(4, 3, -2));
}

TEST(SpaceGrid, WidthsAddUpToTheLength) {
  const SpaceGrid grid({{{0, 1, 2, 4}, {0, 1, 3}, {-2, -1}}});
  double sum = 0.0;
  for (int i = 0; i < grid.count(0); ++i) sum += grid.width(0, i);
  EXPECT_EQ(sum, 4.0);
  EXPECT_EQ(grid.above(0, 1.0), 1);
  EXPECT_EQ(grid.above(0, 1.5), 2);
  EXPECT_EQ(grid.above(0, 4.5), 4);
}

}  // namespace
}  // namespace cutwater
