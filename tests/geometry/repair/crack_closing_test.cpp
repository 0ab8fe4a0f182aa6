#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/repair/CrackClosing.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

constexpr double kCrack = 1e-3;  // tolerance [m]
constexpr std::size_t kNoneLoose = 1'000'000;

/// A rectangle of 4 × 2 m: one triangle on its lower side, and on its upper side a fan whose rim
/// has this many corners on the diagonal, moved off it by `off`.
SurfaceMesh crackedRectangle(int between, double off) {
  SurfaceMesh mesh{{{0, 0, -1}, {4, 0, -1}, {4, 2, -1}, {0, 2, -1}}, {{{0, 1, 2, -1}}}};
  int last = 2;
  for (int k = 1; k <= between + 1; ++k) {
    int next = 0;
    if (k <= between) {
      const double t = 1 - static_cast<double>(k) / (between + 1);
      next = static_cast<int>(mesh.vertices.size());
      mesh.vertices.emplace_back(4 * t, 2 * t, -1 + off);
    }
    mesh.faces.push_back({{last, 3, next, -1}});
    last = next;
  }
  return mesh;
}

double smallestArea(const SurfaceMesh& mesh) {
  double least = 1e300;
  for (const Face& f : mesh.faces) least = std::min(least, vectorArea(mesh, f).norm());
  return least;
}

TEST(CrackClosing, AFaceIsDividedAtVerticesOnItsOpenEdge) {
  for (const int between : {1, 2, 5}) {
    const SurfaceMesh cracked = crackedRectangle(between, 0.0);
    const std::size_t n = cracked.faces.size();
    EXPECT_EQ(openEdges(cracked).size(), 4u + 2u + static_cast<std::size_t>(between));
    const SurfaceMesh whole = withoutCracks(cracked, kCrack, kNoneLoose);
    EXPECT_EQ(whole.faces.size(), n + static_cast<std::size_t>(between));
    EXPECT_EQ(openEdges(whole).size(), 4u);       // the rectangle's
    EXPECT_NEAR(surfaceArea(whole), 8.0, 1e-13);  // round-off
    EXPECT_GT(smallestArea(whole), 0.1);
    EXPECT_LT((test::vectorAreaOf(whole) - test::vectorAreaOf(cracked)).norm(), 1e-13);
  }
}

TEST(CrackClosing, AVertexMayBeOffTheEdgeByTheTolerance) {
  EXPECT_EQ(openEdges(withoutCracks(crackedRectangle(2, 0.9 * kCrack), kCrack, kNoneLoose)).size(),
            4u);
  const SurfaceMesh wide = crackedRectangle(2, 1.1 * kCrack);
  EXPECT_EQ(openEdges(withoutCracks(wide, kCrack, kNoneLoose)).size(), openEdges(wide).size());
}

TEST(CrackClosingIdentity, TheOrderOfFacesAndCornersDoesNotMatter) {
  SurfaceMesh mesh = crackedRectangle(5, 0.5 * kCrack);
  const SurfaceMesh a = withoutCracks(mesh, kCrack, kNoneLoose),
                    b = withoutCracks(test::shuffled(mesh), kCrack, kNoneLoose);
  EXPECT_EQ(a.faces.size(), b.faces.size());
  EXPECT_EQ(openEdges(b).size(), 4u);
  EXPECT_NEAR(surfaceArea(a), surfaceArea(b), 1e-13);
}

TEST(CrackClosingIdentity, ASoundSurfaceStaysAndIsTriangles) {
  const SurfaceMesh body = test::cubes(test::cells({0, 0, -2}, {3, 2, 0}));
  const SurfaceMesh same = withoutCracks(body, kCrack, 0), wanted = triangulated(body);
  ASSERT_EQ(same.faces.size(), wanted.faces.size());
  for (std::size_t k = 0; k < same.faces.size(); ++k) EXPECT_EQ(same.faces[k].v, wanted.faces[k].v);
  EXPECT_TRUE(withoutCracks({}, kCrack, 0).faces.empty());
}

// A vertex that lies on an edge of two faces is no crack, unless those are loose.
TEST(CrackClosing, ClosedEdgesAreLookedAtOfLooseFacesOnly) {
  SurfaceMesh mesh{
      {{0, 0, -1}, {4, 0, -1}, {4, 2, -1}, {0, 2, -1}, {2, 1, -1}, {2, 1, -3}, {3, 1, -3}},
      {{{0, 1, 2, -1}}, {{0, 2, 3, -1}}, {{4, 5, 6, -1}}}};
  EXPECT_EQ(withoutCracks(mesh, kCrack, kNoneLoose).faces.size(), 3u);
  EXPECT_EQ(withoutCracks(mesh, kCrack, 2).faces.size(), 3u);
  EXPECT_EQ(withoutCracks(mesh, kCrack, 0).faces.size(), 5u);
}

TEST(CrackClosing, ThinLooseFacesVanish) {
  SurfaceMesh mesh = test::cubes({{0, 0, -1}});
  mesh.vertices.insert(mesh.vertices.end(), {{5, 0, -1}, {7, 0, -1}, {6, 0.5 * kCrack, -1}});
  mesh.faces.push_back({{8, 9, 10, -1}});
  const std::size_t sound = triangulated(test::cubes({{0, 0, -1}})).faces.size();
  EXPECT_EQ(withoutCracks(mesh, kCrack, 0).faces.size(), sound);
  // Not loose, it is divided no further and stays.
  EXPECT_GT(withoutCracks(mesh, 0.4 * kCrack, 0).faces.size(), sound);
  EXPECT_GT(withoutCracks(mesh, kCrack, kNoneLoose).faces.size(), sound);
}

TEST(CrackClosing, FoldsVanishAndOfTwoAlikeOneStays) {
  const SurfaceMesh one{{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}, {{{0, 1, 2, -1}}}};
  SurfaceMesh fold = one, alike = one;
  fold.faces.push_back({{1, 0, 2, -1}});
  alike.faces.push_back({{1, 2, 0, -1}});
  EXPECT_TRUE(withoutCracks(fold, kCrack, kNoneLoose).faces.empty());
  EXPECT_EQ(withoutCracks(alike, kCrack, kNoneLoose).faces.size(), 1u);
  fold.faces.push_back(one.faces[0]);  // three on the same corners
  EXPECT_TRUE(withoutCracks(fold, kCrack, kNoneLoose).faces.empty());
}

}  // namespace
}  // namespace cutwater
