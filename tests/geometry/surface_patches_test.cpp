#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/SurfacePatches.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

/// How many faces each patch has, fewest first.
std::vector<std::size_t> patchSizes(const std::vector<SurfacePatch>& patches) {
  std::vector<std::size_t> sizes;
  for (const SurfacePatch& p : patches) {
    EXPECT_EQ(p.turned.size(), p.faces.size());
    sizes.push_back(p.faces.size());
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

void turnFace(Face& f) { std::reverse(f.v.begin(), f.v.begin() + f.size()); }

/// A strip of quadrilaterals around a ring, its ends joined after half a turn, or after none.
SurfaceMesh ringStrip(bool halfTurn) {
  constexpr int kParts = 12;
  SurfaceMesh mesh;
  for (int i = 0; i < kParts; ++i) {
    const double angle = 2 * kPi * i / kParts, twist = halfTurn ? 0.5 * angle : 0.0;
    for (const double side : {-1.0, 1.0}) {
      const double r = 5 + side * std::cos(twist);
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                 -3 + side * std::sin(twist));
    }
  }
  for (int i = 0; i < kParts; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % kParts);
    const bool turned = halfTurn && i + 1 == kParts;
    mesh.faces.push_back({{a, turned ? b + 1 : b, turned ? b : b + 1, a + 1}});
  }
  return mesh;
}

TEST(SurfacePatches, ASurfaceOfNoFacesHasNoPatch) {
  EXPECT_TRUE(surfacePatches({}, "empty").empty());
  EXPECT_TRUE(agreeing({}, "empty").faces.empty());
}

TEST(SurfacePatches, EachPieceIsAPatch) {
  const SurfaceMesh box = test::cubes(test::cells({0, 0, -2}, {2, 2, 0}));
  const SurfaceMesh two = joined(box, test::moved(test::cubes({{0, 0, -1}}), {5, 0, 0}));
  EXPECT_EQ(patchSizes(surfacePatches(two, "two")), (std::vector<std::size_t>{6, 24}));
  EXPECT_EQ(patchSizes(surfacePatches(test::shuffled(two), "two")),
            (std::vector<std::size_t>{6, 24}));
}

TEST(SurfacePatches, APatchEndsWhereThreeFacesMeet) {
  SurfaceMesh box = test::cubes(test::cells({0, 0, -1}, {3, 1, 0}));  // 14 faces
  std::vector<int> ring;                                              // a bulkhead at x = 1
  for (const Vec3& p : {Vec3(1, 0, -1), Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 0, 0)})
    ring.push_back(static_cast<int>(std::find(box.vertices.begin(), box.vertices.end(), p) -
                                    box.vertices.begin()));
  box.faces.push_back({{ring[0], ring[1], ring[2], ring[3]}});
  EXPECT_EQ(patchSizes(surfacePatches(box, "box")), (std::vector<std::size_t>{1, 5, 9}));
}

TEST(SurfacePatches, APatchEndsAtEdgesBetweenCutVertices) {
  // Two squares with a common edge, its vertices the last two.
  const SurfaceMesh mesh{{{0, 0, -1}, {0, 1, -1}, {2, 0, -1}, {2, 1, -1}, {1, 0, -1}, {1, 1, -1}},
                         {{{0, 4, 5, 1}}, {{4, 2, 3, 5}}}};
  EXPECT_EQ(surfacePatches(mesh, "squares").size(), 1u);
  EXPECT_EQ(surfacePatches(mesh, "squares", 4).size(), 2u);
  EXPECT_EQ(surfacePatches(mesh, "squares", 5).size(), 1u);  // one vertex of the edge is older
}

TEST(SurfacePatchesIdentity, FacesTurnedAsSaidAgree) {
  SurfaceMesh mesh = test::turnedAtRandom(test::cubes(test::cells({0, 0, -3}, {4, 3, 0})));
  ASSERT_FALSE(openEdges(mesh).empty());
  const std::vector<SurfacePatch> patches = surfacePatches(mesh, "box");
  ASSERT_EQ(patches.size(), 1u);
  for (std::size_t i = 0; i < patches[0].faces.size(); ++i)
    if (patches[0].turned[i]) turnFace(mesh.faces[static_cast<std::size_t>(patches[0].faces[i])]);
  EXPECT_TRUE(openEdges(mesh).empty());
  EXPECT_EQ(std::abs(volumeIntegrals(mesh).volume), 36.0);  // whole numbers: exact
}

TEST(SurfacePatches, AOneSidedSurfaceIsRefusedWithItsPlace) {
  EXPECT_EQ(surfacePatches(ringStrip(false), "ring").size(), 1u);
  test::expectRefusal(Fault::HullInverted,
                      {"ring.obj: the surface is one-sided", "first seen at ("},
                      [] { surfacePatches(ringStrip(true), "ring.obj"); });
  test::expectRefusal(Fault::HullInverted, {"ring.obj: ", "one-sided"},
                      [] { agreeing(ringStrip(true), "ring.obj"); });
}

// One large face outvotes all the small ones, however many these are.
TEST(SurfacePatches, TheSenseOfMostOfTheAreaWins) {
  SurfaceMesh strip;
  for (const double x : {0.0, 1.0, 2.0, 3.0, 10.0})
    for (const double y : {0.0, 1.0}) strip.vertices.emplace_back(x, y, -1.0);
  for (int i = 0; i < 4; ++i) strip.faces.push_back({{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}});
  ASSERT_EQ(test::vectorAreaOf(strip), Vec3(0, 0, 10));
  SurfaceMesh spoilt = strip;
  turnFace(spoilt.faces[3]);  // 7 of 10 m²
  EXPECT_EQ(test::vectorAreaOf(agreeing(spoilt, "strip")), Vec3(0, 0, -10));
  spoilt = strip;
  for (std::size_t k = 0; k < 3; ++k) turnFace(spoilt.faces[k]);
  EXPECT_EQ(test::vectorAreaOf(agreeing(spoilt, "strip")), Vec3(0, 0, 10));
}

TEST(SurfacePatchesIdentity, PiecesKeepSensesOfTheirOwn) {
  const SurfaceMesh box = test::cubes(test::cells({0, 0, -2}, {2, 2, 0}));
  const SurfaceMesh both = joined(box, turnedOver(test::moved(box, {5, 0, 0})));
  const SurfaceMesh same = agreeing(both, "both");
  for (std::size_t k = 0; k < both.faces.size(); ++k)
    EXPECT_EQ(same.faces[k].v, both.faces[k].v);  // neither inwards nor outwards is its business
  SurfaceMesh spoilt = both;
  for (const std::size_t k : {3u, 7u, 30u}) turnFace(spoilt.faces[k]);
  EXPECT_EQ(volumeIntegrals(agreeing(spoilt, "both")).volume, volumeIntegrals(both).volume);
}

}  // namespace
}  // namespace cutwater
