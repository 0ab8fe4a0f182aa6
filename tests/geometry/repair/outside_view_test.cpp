#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "hydro/geometry/repair/OutsideView.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

constexpr int kManySightRays = 400;

/// 6 × 4 × 3 m, open on calm water.
SurfaceMesh sightBarge() {
  return test::openOnWater(test::cubes(test::cells({-3, -2, -3}, {3, 2, 0})));
}

/// All faces of a surface as one patch.
SurfacePatch wholePatch(const SurfaceMesh& mesh, bool turned = false) {
  SurfacePatch patch;
  patch.faces.resize(mesh.faces.size());
  std::iota(patch.faces.begin(), patch.faces.end(), 0);
  patch.turned.assign(mesh.faces.size(), turned);
  return patch;
}

// Under a convex hull nothing is in the way of a ray that goes down, and its sides see the water
// all around but for rays that go up and then back to the hull.
TEST(OutsideView, AConvexHullIsSeenFromOutsideOnly) {
  const SurfaceMesh barge = sightBarge();
  const OutsideView view(barge);
  for (int f = 0; f < static_cast<int>(barge.faces.size()); ++f) {
    const OutsideView::Shares shares = view.of(f, kManySightRays);
    EXPECT_EQ(shares.other, 0.0) << f;
    if (vectorArea(barge, barge.faces[static_cast<std::size_t>(f)]).z() < -0.5)
      EXPECT_NEAR(shares.normal, 1.0, 1e-12) << f;  // a sum of eighths
    else
      EXPECT_GT(shares.normal, 0.7) << f;
  }
}

TEST(OutsideViewIdentity, ATurnedFaceIsSeenFromItsOtherSide) {
  const SurfaceMesh barge = sightBarge(), inwards = turnedOver(barge);
  const OutsideView view(barge), turned(inwards);
  for (const int f : {0, 5, 17, 30}) {
    const OutsideView::Shares a = view.of(f, 48), b = turned.of(f, 48);
    // The middle of a face is a sum in another order.
    EXPECT_NEAR(a.normal, b.other, 1e-12);
    EXPECT_NEAR(a.other, b.normal, 1e-12);
  }
  const OutsideView::PatchView asIs = view.of(wholePatch(barge)),
                               other = view.of(wholePatch(barge, true));
  EXPECT_EQ(asIs.shares.normal, other.shares.other);
  EXPECT_EQ(asIs.shares.other, other.shares.normal);
  EXPECT_GT(asIs.shares.normal, 0.7);
}

TEST(OutsideView, WhatIsInsideIsHidden) {
  const SurfaceMesh barge = sightBarge(), tank = test::cubes({{0, 0, -2}});
  const SurfaceMesh both = joined(barge, tank);
  const OutsideView view(both);
  SurfacePatch inside = wholePatch(tank);
  for (int& f : inside.faces) f += static_cast<int>(barge.faces.size());
  const OutsideView::PatchView seen = view.of(inside);
  EXPECT_EQ(seen.shares.normal + seen.shares.other, 0.0);
  EXPECT_NEAR(seen.hiddenArea, 1.0, 1e-12);
  EXPECT_EQ(seen.hiddenFace, inside.faces.front());
  SurfacePatch shell = wholePatch(barge);
  EXPECT_EQ(view.of(shell).hiddenArea, 0.0);
  EXPECT_EQ(view.of(shell).hiddenFace, -1);
  // Of a patch that is half of each, the hidden share is that of the area: 6 of 6 + 84 m².
  shell.faces.insert(shell.faces.end(), inside.faces.begin(), inside.faces.end());
  shell.turned.resize(shell.faces.size(), false);
  EXPECT_NEAR(view.of(shell).hiddenArea, 6.0 / 90.0, 1.0 / 90.0);  // of 90 faces that are asked
}

// A deck under calm water is inside though nothing lies above it: its rays end in the waterplane.
TEST(OutsideView, WhatLiesUnderTheWaterplaneIsInside) {
  SurfaceMesh barge = sightBarge();
  const int deck = static_cast<int>(barge.faces.size()),
            first = static_cast<int>(barge.vertices.size());
  for (const Vec3& p : {Vec3(-1, -1, -1), Vec3(1, -1, -1), Vec3(1, 1, -1), Vec3(-1, 1, -1)})
    barge.vertices.push_back(p);
  barge.faces.push_back({{first, first + 1, first + 2, first + 3}});
  const OutsideView::Shares shares = OutsideView(barge).of(deck, kManySightRays);
  EXPECT_EQ(shares.normal, 0.0);
  EXPECT_EQ(shares.other, 0.0);
}

TEST(OutsideView, APlateInOpenWaterIsSeenFromBothSides) {
  const SurfaceMesh plate{{{-1, 0, -4}, {1, 0, -4}, {1, 0, -2}, {-1, 0, -2}}, {{{0, 1, 2, 3}}}};
  const OutsideView view(plate);
  const OutsideView::Shares shares = view.of(0, kManySightRays);
  EXPECT_NEAR(shares.normal, 1.0, 1e-12);  // sums of eighths
  EXPECT_NEAR(shares.other, 1.0, 1e-12);
  EXPECT_NEAR(view.of(wholePatch(plate)).shares.other, 1.0, 1e-12);
}

TEST(OutsideView, ATunnelIsSeenThroughItsOpenEnds) {
  std::vector<std::array<int, 3>> body = test::cells({0, 0, -3}, {3, 3, 0});
  std::erase_if(body, [](const auto& c) { return c[1] == 1 && c[2] == -2; });  // along x
  const SurfaceMesh hull = test::openOnWater(test::cubes(body));
  const OutsideView view(hull);
  for (int f = 0; f < static_cast<int>(hull.faces.size()); ++f) {
    const OutsideView::Shares shares = view.of(f, kManySightRays);
    EXPECT_GT(shares.normal, 0.02) << f;
    EXPECT_EQ(shares.other, 0.0) << f;
  }
}

}  // namespace
}  // namespace cutwater
