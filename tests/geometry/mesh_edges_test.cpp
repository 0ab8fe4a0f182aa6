#include <gtest/gtest.h>

#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

TEST(MeshEdges, EveryEdgeOfAClosedHullIsUsedOnceInEitherSense) {
  const SurfaceMesh hull = closedSphere(2.0, 9, 5);
  const std::vector<EdgeUse> uses = edgeUses(hull);
  std::size_t corners = 0;
  for (const Face& f : hull.faces) corners += static_cast<std::size_t>(f.size());
  ASSERT_EQ(uses.size(), corners);
  for (std::size_t i = 0; i < uses.size(); i += 2) {
    EXPECT_EQ(uses[i].edge, uses[i + 1].edge);
    EXPECT_NE(uses[i].rising, uses[i + 1].rising);
    EXPECT_LT(uses[i].face, uses[i + 1].face);
  }
  EXPECT_TRUE(looseEdges(hull).empty());
}

TEST(MeshEdges, AnEdgeIsNamedByItsLowerVertexThenItsHigherOne) {
  const SurfaceMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{2, 0, 1, -1}}}};
  const std::vector<EdgeUse> uses = edgeUses(one);
  ASSERT_EQ(uses.size(), 3u);
  EXPECT_EQ(uses[0].edge, 0x0'0000'0001u);  // from 0 to 1
  EXPECT_TRUE(uses[0].rising);
  EXPECT_EQ(uses[1].edge, 0x0'0000'0002u);  // from 2 to 0
  EXPECT_FALSE(uses[1].rising);
  EXPECT_EQ(uses[2].edge, 0x1'0000'0002u);
}

// Open edges are those without a partner that runs the other way; loose ones those of an odd number
// of faces, however they run.
TEST(MeshEdges, ATurnedFaceHasOpenEdgesButNoLooseOnes) {
  SurfaceMesh hull = closedBox({10, 4, 2, 1}, 2, 1, 1);
  std::swap(hull.faces[0].v[0], hull.faces[0].v[2]);
  EXPECT_FALSE(openEdges(hull).empty());
  EXPECT_TRUE(looseEdges(hull).empty());
  hull.faces.pop_back();
  EXPECT_EQ(looseEdges(hull).size(), 4u);  // the rim of a quadrilateral that is missing
}

TEST(MeshEdges, PlacesAreNamedToSixDigits) {
  EXPECT_EQ(placeText({1.25, -3.0, 1.0 / 3.0}), "(1.25, -3, 0.333333)");
}

}  // namespace
}  // namespace cutwater
