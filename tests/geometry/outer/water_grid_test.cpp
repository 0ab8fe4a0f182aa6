#include <gtest/gtest.h>

#include "hydro/geometry/outer/WaterGrid.h"
#include "tests/geometry/outer/OuterBodies.h"

namespace cutwater {
namespace {

TEST(WaterGrid, WaterSurroundsABodyAndIsNotInIt) {
  const WaterGrid water = test::waterAround(test::box({-2, -1, -1}, {2, 1, 1}), 0.25);
  EXPECT_FALSE(test::wetAt(water, {0, 0, -0.5}));
  EXPECT_FALSE(test::wetAt(water, {1.5, 0.5, 0.5}));
  EXPECT_TRUE(test::wetAt(water, {2.3, 0, -0.5}));
  EXPECT_TRUE(test::wetAt(water, {0, 0, -1.2}));
  EXPECT_TRUE(test::wetAt(water, {0, 0, 1.3}));
}

TEST(WaterGrid, ABowlIsFilledToItsRimAndNoHigher) {
  SurfaceMesh bowl = test::bowl({-2, -1, -1}, {2, 1, 1});
  EXPECT_FALSE(test::wetAt(test::waterAround(bowl, 0.25), {0, 0, -0.5}));
  EXPECT_FALSE(test::wetAt(test::waterAround(bowl, 0.25), {0, 0, 0.5}));
  // Its rim is cut down to 0.4 m at one end: above that the water comes in, but does not fall.
  for (Vec3& p : bowl.vertices)
    if (p.x() > 0 && p.z() > 0) p.z() = 0.4;
  EXPECT_TRUE(test::wetAt(test::waterAround(bowl, 0.125), {0.5, 0, 0.7}));
  EXPECT_FALSE(test::wetAt(test::waterAround(bowl, 0.125), {0.5, 0, 0.2}));
}

TEST(WaterGrid, AHoleInTheBottomLetsTheWaterIn) {
  SurfaceMesh bowl = test::bowl({-2, -1, -1}, {2, 1, 1});
  std::erase_if(bowl.faces, [&](const Face& f) { return meanCorner(bowl, f).z() == -1; });
  EXPECT_TRUE(test::wetAt(test::waterAround(bowl, 0.25), {0, 0, -0.5}));
}

TEST(WaterGrid, MoonpoolsAreWetAndNestedSolidsAreNot) {
  std::vector<std::array<int, 3>> ring;
  for (const auto& c : test::cells({-3, -3, -2}, {3, 3, 1}))
    if (std::abs(c[0] + 0.5) > 1 || std::abs(c[1] + 0.5) > 1) ring.push_back(c);
  const WaterGrid pool = test::waterAround(triangulated(test::cubes(ring)), 0.25);
  EXPECT_TRUE(test::wetAt(pool, {0, 0, -1}));
  EXPECT_FALSE(test::wetAt(pool, {2, 0, -1}));
  const WaterGrid nested = test::waterAround(
      joined(test::box({-2, -1, -1}, {2, 1, 1}), test::box({-1, -0.5, -0.5}, {1, 0.5, 0.5})), 0.2);
  EXPECT_FALSE(test::wetAt(nested, {0, 0, -0.25}));
}

TEST(WaterGrid, ACoarserGridKnowsWhatTheFineOneDoes) {
  const SurfaceMesh body =
      joined(test::box({-2, -1, -1}, {2, 1, 1}), test::box({2.2, -1, -1}, {3, 1, 1}));
  const WaterGrid fine = test::waterAround(body, 0.1);
  const int top = (fine.grid().count(2) - 1) / 4 * 4;
  const WaterGrid coarse = fine.coarser(4, top);
  for (std::size_t node = 0; node < coarse.grid().nodes(); ++node) {
    const auto at = coarse.grid().index(node);
    EXPECT_EQ(coarse.wet(node), fine.wet(fine.grid().node({4 * at[0], 4 * at[1], 4 * at[2]})));
  }
  EXPECT_FALSE(coarse.along(0).empty());
  for (const SurfaceCrossing& c : coarse.along(0)) {
    // The gap between the boxes is met nowhere: its walls are behind the first face from outside.
    EXPECT_NE(coarse.wet(c.node), coarse.wet(c.node + 1));
    const double off = std::min(
        {std::abs(c.at + 2), std::abs(c.at - 2), std::abs(c.at - 2.2), std::abs(c.at - 3)});
    EXPECT_LT(off, 1e-12);  // round-off
  }
}

}  // namespace
}  // namespace cutwater
