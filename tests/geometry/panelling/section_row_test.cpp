#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hydro/geometry/panelling/SectionRow.h"

namespace cutwater {
namespace {

/// From the port waterline down 2 m and 4 m to the centreline.
SectionCurve halfBox() { return curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 0, -2}}); }

double distanceFrom(const SectionCurve& curve, const Vec3& p) {
  double least = 1e300;
  for (int i = 0; i <= 60'000; ++i)
    least = std::min(least, (curve.at(curve.length() * i / 60'000) - p).norm());
  return least;
}

std::vector<double> edgeLengths(const SectionRow& row) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < row.points.size(); ++i)
    lengths.push_back((row.points[i] - row.points[i - 1]).norm());
  return lengths;
}

bool hasPoint(const SectionRow& row, const Vec3& p, double within) {
  return std::any_of(row.points.begin(), row.points.end(),
                     [&](const Vec3& q) { return (p - q).norm() < within; });
}

TEST(SectionRow, ACornerNeedsRoomForAPanelOnEitherSide) {
  EXPECT_EQ(roomyCorners(halfBox(), 1.0, kKnuckle), (std::vector<double>{2.0}));
  EXPECT_EQ(roomyCorners(halfBox(), 5.7, kKnuckle), (std::vector<double>{2.0}));
  EXPECT_TRUE(roomyCorners(halfBox(), 5.8, kKnuckle).empty());  // 0.35 of it is more than 2 m
  EXPECT_TRUE(roomyCorners(halfBox(), 1.0, 1.6).empty());       // it turns by 1.57
  // Two knuckles 0.5 m apart: room for both, or for one.
  const SectionCurve step = curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 3.5, -2}, {0, 3.5, -4}});
  EXPECT_EQ(roomyCorners(step, 1.0, kKnuckle).size(), 2u);
  EXPECT_EQ(roomyCorners(step, 1.6, kKnuckle).size(), 1u);
}

TEST(SectionRowClosedForm, ABoxIsDividedFromItsEndsToItsKnuckle) {
  const SectionRow row = sectionRow(halfBox(), {1.0, 2.0, 0.0, 0.0, 0.0});  // no corners counted
  EXPECT_EQ(row.breaks, (std::vector<int>{0, 2, 6}));
  ASSERT_EQ(row.points.size(), 7u);
  const Vec3 wanted[] = {{0, 4, 0},  {0, 4, -1}, {0, 4, -2}, {0, 3, -2},
                         {0, 2, -2}, {0, 1, -2}, {0, 0, -2}};
  // Turns of straight chords are the root of round-off, 1e-8.
  for (std::size_t i = 0; i < 7; ++i) EXPECT_LT((row.points[i] - wanted[i]).norm(), 1e-6) << i;
}

TEST(SectionRow, PanelsAreNarrowerTowardsASharpBilgeOnBothSides) {
  const SectionRow row = sectionRow(halfBox(), {1.0, 2.0, 0.0, 0.0});
  ASSERT_EQ(row.breaks.size(), 3u);
  std::vector<double> edges = edgeLengths(row);
  const auto bilge = edges.begin() + row.breaks[1];
  EXPECT_TRUE(std::is_sorted(edges.begin(), bilge, std::greater<>()));
  EXPECT_TRUE(std::is_sorted(bilge, edges.end()));
  EXPECT_LT(*bilge, 0.75);  // 1 + w e^{−d} = 1.9 times denser half a panel from it
}

TEST(SectionRow, PanelsAreNarrowerTowardsCalmWaterOnly) {
  const SectionCurve side = curveThrough({{0, 4, 0}, {0, 4, -8}});
  const std::vector<double> even = edgeLengths(sectionRow(side, {1.0, 2.0, 0.0, 0.0})),
                            crowded = edgeLengths(sectionRow(side, {1.0, 2.0, 0.5, 0.0}));
  ASSERT_EQ(even.size(), 8u);
  ASSERT_EQ(crowded.size(), 8u);
  for (const double length : even) EXPECT_NEAR(length, 1.0, 1e-6);
  EXPECT_TRUE(std::is_sorted(crowded.begin(), crowded.end()));
  EXPECT_NEAR(crowded.front(), 0.5, 0.02);  // 1 − c of the mean, as far as a part is short
  EXPECT_NEAR(crowded.back(), 1.5, 0.02);
  const SectionCurve deep = curveThrough({{0, 4, -1}, {0, 4, -9}});  // no end on calm water
  for (const double length : edgeLengths(sectionRow(deep, {1.0, 2.0, 0.5, 0.0})))
    EXPECT_NEAR(length, 1.0, 1e-6);
}

TEST(SectionRowIdentity, ASymmetricSectionIsDividedAlikeOnBothSides) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    const double a = kPi * i / 400;
    points.emplace_back(0.0, 3 * std::cos(a), -2 * std::sin(a));
  }
  points.front().z() = points.back().z() = 0.0;
  const SectionCurve curve = curveThrough(points);
  for (const double size : {0.37, 0.8, 2.1}) {
    const SectionRow row = sectionRow(curve, {size, 1.0, 0.4, 0.1});
    const std::size_t n = row.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 image(0, -row.points[n - 1 - i].y(), row.points[n - 1 - i].z());
      EXPECT_LT((row.points[i] - image).norm(), 1e-9);      // round-off of summed turns
      EXPECT_LT(distanceFrom(curve, row.points[i]), 1e-4);  // steps of the search
    }
  }
}

TEST(SectionRowClosedForm, APartIsFoundWhereItLies) {
  const SectionCurve part = curveThrough({{0, 4, -1}, {0, 4, -2}, {0, 1, -2}});
  const CurveSpan span = spanOn(halfBox(), part, 0.2);
  ASSERT_TRUE(span.found());
  EXPECT_NEAR(span.from, 1.0, 1e-14);
  EXPECT_NEAR(span.to, 5.0, 1e-14);
  const CurveSpan whole = spanOn(halfBox(), halfBox(), 0.2);
  EXPECT_EQ(whole.from, 0.0);
  EXPECT_NEAR(whole.to, 6.0, 1e-14);
  const SectionCurve loop =
      curveThrough({{0, 0, -1}, {0, 2, -2}, {0, 0, -3}, {0, -2, -2}, {0, 0, -1}});
  const CurveSpan around = spanOn(loop, loop, 0.2);  // its end is its beginning
  EXPECT_EQ(around.from, 0.0);
  EXPECT_NEAR(around.to, loop.length(), 1e-13);
}

TEST(SectionRow, WhatIsNoPartIsNotFound) {
  EXPECT_FALSE(CurveSpan{}.found());
  const SectionCurve away = curveThrough({{0, 4.3, -1}, {0, 4.3, -2}});
  EXPECT_FALSE(spanOn(halfBox(), away, 0.2).found());
  EXPECT_TRUE(spanOn(halfBox(), away, 0.4).found());  // within reach
  const SectionCurve shortCut =
      curveThrough({{0, 4, 0}, {0, 0, -2}});  // both ends on it, 4.5 of 6 m
  EXPECT_FALSE(spanOn(halfBox(), shortCut, 0.2).found());
}

// A bow with a bulb: the stem runs down the centreline to 2 m, the bulb from there out and back.
TEST(SectionRow, AHostHasItsGuestsRowsAndAStem) {
  const SectionCurve host =
      curveThrough({{9, 0.01, 0}, {9, 0.01, -2}, {9, 1, -3}, {9, 1, -5}, {9, 0, -6}});
  const SectionCurve guest = curveThrough({{9, 0.01, -2}, {9, 1, -3}, {9, 1, -5}, {9, 0, -6}});
  const PanelSize size{0.5, 1.0, 0.2, 0.1};
  const SectionRow row = hostRow(host, {guest}, size), own = sectionRow(guest, size);
  ASSERT_GT(row.points.size(), own.points.size());
  const std::size_t stem = row.points.size() - own.points.size();
  for (std::size_t i = 0; i < own.points.size(); ++i)
    EXPECT_EQ(row.points[stem + i], own.points[i]);
  for (std::size_t i = 0; i < stem; ++i) EXPECT_EQ(row.points[i].y(), 0.0) << i;
  EXPECT_EQ(row.points.front(), Vec3(9, 0, 0));
  EXPECT_TRUE(std::is_sorted(row.breaks.begin(), row.breaks.end(), std::less_equal<>()));
  EXPECT_EQ(row.breaks.front(), 0);
  EXPECT_EQ(row.breaks.back(), static_cast<int>(row.points.size()) - 1);
}

TEST(SectionRowIdentity, TheOrderOfGuestsDoesNotMatter) {
  const SectionCurve host = curveThrough({{0, 6, 0}, {0, 6, -3}, {0, -6, -3}, {0, -6, 0}});
  const SectionCurve port = curveThrough({{0, 6, 0}, {0, 6, -3}, {0, 2, -3}}),
                     starboard = curveThrough({{0, -2, -3}, {0, -6, -3}, {0, -6, 0}});
  const PanelSize size{0.7, 1.4, 0.2, 0.1};
  const SectionRow a = hostRow(host, {port, starboard}, size),
                   b = hostRow(host, {starboard, port}, size);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.breaks, b.breaks);
  for (const SectionCurve& guest : {port, starboard})
    for (const Vec3& p : sectionRow(guest, size).points)
      EXPECT_TRUE(hasPoint(a, p, 0.07))
          << p.transpose();  // but where a stem's corner is about there
}

}  // namespace
}  // namespace cutwater
