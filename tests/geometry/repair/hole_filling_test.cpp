#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/repair/HoleFilling.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

Vec3 middleOf(const SurfaceMesh& mesh, const Face& f) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < f.size(); ++i) sum += mesh.corner(f, i) / f.size();
  return sum;
}

/// Without the faces whose middle is one of these.
SurfaceMesh withoutFacesAt(SurfaceMesh mesh, const std::vector<Vec3>& places) {
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::any_of(places.begin(), places.end(),
                       [&](const Vec3& p) { return (middleOf(mesh, f) - p).norm() < 1e-9; });
  });
  return mesh;
}

/// 8 × 4 × 3 m, of squares of 1 m, open on calm water.
SurfaceMesh openBarge() {
  return test::openOnWater(test::cubes(test::cells({0, -2, -3}, {8, 2, 0})));
}

void expectBarge(const SurfaceMesh& mesh) {
  EXPECT_EQ(test::openEdgesBelowWater(mesh), 0);
  EXPECT_NEAR(volumeIntegrals(mesh).volume, 96.0, 1e-12);  // round-off
  EXPECT_LT((test::vectorAreaOf(mesh) - Vec3(0, 0, -32)).norm(), 1e-12);
}

TEST(HoleFilling, TheWaterlineIsNoHole) {
  SurfaceMesh barge = openBarge();
  const std::size_t faces = barge.faces.size();
  EXPECT_TRUE(fillHoles(barge, 0.1, "barge").empty());
  EXPECT_EQ(barge.faces.size(), faces);
  SurfaceMesh nothing;
  EXPECT_TRUE(fillHoles(nothing, 0.1, "nothing").empty());
}

TEST(HoleFillingClosedForm, ASquareHoleIsAsWideAsItsSide) {
  SurfaceMesh barge = withoutFacesAt(openBarge(), {{2.5, 0.5, -3}});
  const std::vector<FilledHole> holes = fillHoles(barge, 1.001, "barge");
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(holes[0].width, 1.0, 1e-14);  // 4 × 1 m² over 4 m
  EXPECT_LT((holes[0].place - Vec3(2.5, 0.5, -3)).norm(), 1e-14);
  EXPECT_FALSE(holes[0].keel);
  expectBarge(barge);
}

// A regular polygon of n corners on a circle of diameter d: 4 A / U = d cos(π/n).
TEST(HoleFillingClosedForm, ARoundHoleIsAsWideAsItsDiameter) {
  SurfaceMesh cone;
  constexpr int kCorners = 24;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * kPi * i / kCorners;
    cone.vertices.emplace_back(std::cos(angle), std::sin(angle), -2.0);
  }
  cone.vertices.emplace_back(0, 0, -5);
  for (int i = 0; i < kCorners; ++i) cone.faces.push_back({{(i + 1) % kCorners, i, kCorners, -1}});
  const std::vector<FilledHole> holes = fillHoles(cone, 2.1, "cone");
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(holes[0].width, 2 * std::cos(kPi / kCorners), 1e-13);  // round-off
  EXPECT_LT((holes[0].place - Vec3(0, 0, -2)).norm(), 1e-14);
  EXPECT_EQ(cone.faces.size(), kCorners + kCorners - 2u);
  EXPECT_TRUE(openEdges(cone).empty());  // also that the faces agree
}

// Whichever of them is followed first.
TEST(HoleFilling, HolesThatTouchInAVertexAreTwo) {
  for (const double side : {1.0, -1.0})
    for (const bool mixed : {false, true}) {
      SurfaceMesh barge = withoutFacesAt(
          openBarge(), {{2.5, 0.5 * side, -3}, {3.5, -0.5 * side, -3}, {4.5, 0.5 * side, -3}});
      if (mixed) barge = test::shuffled(barge);
      const std::vector<FilledHole> holes = fillHoles(barge, 1.5, "barge");
      EXPECT_EQ(holes.size(), 3u);
      for (const FilledHole& h : holes) EXPECT_NEAR(h.width, 1.0, 1e-14);
      expectBarge(barge);
    }
}

TEST(HoleFilling, AHoleRoundAnEdgeKeepsTheSurfaceClosed) {
  SurfaceMesh barge = withoutFacesAt(openBarge(), {{2.5, 1.5, -3}, {2.5, 2, -2.5}});
  const std::vector<FilledHole> holes = fillHoles(barge, 2.0, "barge");
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(test::openEdgesBelowWater(barge), 0);
  // A rim of six corners around the chine: the cover cuts it off, a prism of ½ m³, or not.
  EXPECT_GE(volumeIntegrals(barge).volume, 95.5 - 1e-12);
  EXPECT_LE(volumeIntegrals(barge).volume, 96.0 + 1e-12);
}

// The rim of a hole at calm water is no loop: it is closed across the water, from end to end.
TEST(HoleFilling, AHoleAtTheWaterlineIsClosedAcrossIt) {
  SurfaceMesh barge = withoutFacesAt(openBarge(), {{2.5, 2, -0.5}});
  const std::vector<FilledHole> holes = fillHoles(barge, 1.5, "barge");
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(holes[0].width, 1.0, 1e-14);
  EXPECT_FALSE(holes[0].keel);
  expectBarge(barge);
}

TEST(HoleFillingClosedForm, TwoHalvesThatDoNotMeetAreJoinedAtTheKeel) {
  const double gap = 0.1;  // between the halves [m]
  SurfaceMesh port = test::openOnWater(test::cubes(test::cells({0, 0, -3}, {40, 2, 0})));
  std::erase_if(port.faces, [&](const Face& f) { return middleOf(port, f).y() == 0.0; });
  const SurfaceMesh half = test::moved(welded(port, 0.0), {0, 0.5 * gap, 0});
  SurfaceMesh both = joined(half, mirroredInY(half));
  const std::vector<FilledHole> holes = fillHoles(both, 3.0, "halves");
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_TRUE(holes[0].keel);
  EXPECT_EQ(test::openEdgesBelowWater(both), 0);
  EXPECT_NEAR(volumeIntegrals(both).volume, 40 * 3 * (4 + gap), 1e-10);  // round-off of 492
  EXPECT_NEAR(holes[0].place.y(), 0.0, 1e-12);
}

TEST(HoleFilling, AWideHoleIsRefusedWithItsPlaceAndWidth) {
  std::vector<Vec3> places;
  for (const double x : {2.5, 3.5})
    for (const double y : {-0.5, 0.5}) places.emplace_back(x, y, -3);
  SurfaceMesh barge = withoutFacesAt(openBarge(), places);  // 2 × 2 m
  test::expectRefusal(Fault::HullNotClosed,
                      {"barge.obj: hull has a hole 2 m wide below water at (3", "up to 1.9 m"},
                      [&] { fillHoles(barge, 1.9, "barge.obj"); });
  SurfaceMesh again = withoutFacesAt(openBarge(), places);
  EXPECT_EQ(fillHoles(again, 2.1, "barge.obj").size(), 1u);
  expectBarge(again);
}

TEST(HoleFillingIdentity, NeitherTheOrderOfFacesNorTheSideMatters) {
  const SurfaceMesh spoilt =
      withoutFacesAt(openBarge(), {{2.5, 0.5, -3}, {5.5, 2, -1.5}, {6.5, 2, -1.5}});
  const auto widths = [](SurfaceMesh mesh) {
    std::vector<std::pair<double, Vec3>> all;
    for (const FilledHole& h : fillHoles(mesh, 2.0, "barge")) all.emplace_back(h.width, h.place);
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return all;
  };
  const auto plain = widths(spoilt), mixed = widths(test::shuffled(spoilt)),
             image = widths(mirroredInY(spoilt));
  ASSERT_EQ(plain.size(), 2u);
  ASSERT_EQ(mixed.size(), 2u);
  ASSERT_EQ(image.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    // Round-off of sums in another order.
    EXPECT_NEAR(mixed[k].first, plain[k].first, 1e-14);
    EXPECT_LT((mixed[k].second - plain[k].second).norm(), 1e-14);
    EXPECT_NEAR(image[k].first, plain[k].first, 1e-14);
    EXPECT_NEAR(image[k].second.y(), -plain[k].second.y(), 1e-14);
  }
}

}  // namespace
}  // namespace cutwater
