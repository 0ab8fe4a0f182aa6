#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/SectionCurves.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

using Side = SectionCutter::Side;

std::vector<double> xStations(const SurfaceMesh& mesh) {
  std::vector<double> x;
  for (const Vec3& p : mesh.vertices) x.push_back(p.x());
  return x;
}

std::vector<SectionCurve> sectionsAt(const SurfaceMesh& mesh, double x, Side side = Side::Above) {
  return SectionCutter(mesh, xStations(mesh)).curvesAt(x, side);
}

TEST(SectionCurves, RepeatedPointsAreLeftOut) {
  const SectionCurve curve =
      curveThrough({{0, 0, 0}, {0, 3, 0}, {0, 3, 0}, {0, 3, -4}, {0, 3, -4}});
  ASSERT_EQ(curve.points.size(), 3u);
  EXPECT_EQ(curve.arc, (std::vector<double>{0, 3, 7}));
  EXPECT_EQ(curve.length(), 7.0);
  EXPECT_EQ(curveThrough({}).length(), 0.0);
  EXPECT_EQ(curveThrough({{1, 2, 3}}).at(0.5), Vec3(1, 2, 3));
}

TEST(SectionCurvesClosedForm, APointIsHeldWithinTheCurve) {
  const SectionCurve curve = curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 0, -2}});
  EXPECT_EQ(curve.at(-1.0), Vec3(0, 4, 0));
  EXPECT_EQ(curve.at(0.5), Vec3(0, 4, -0.5));
  EXPECT_EQ(curve.at(2.0), Vec3(0, 4, -2));
  EXPECT_EQ(curve.at(3.0), Vec3(0, 3, -2));
  EXPECT_EQ(curve.at(99.0), Vec3(0, 0, -2));
}

// Nine places at eighths of the length.
TEST(SectionCurvesClosedForm, DistancesOfLines) {
  const SectionCurve line = curveThrough({{0, 0, 0}, {0, 1, 0}, {0, 8, 0}}),
                     beside = curveThrough({{3, 0, 0}, {3, 8, 0}}),
                     fan = curveThrough({{0, 0, 0}, {8, 8, 0}});
  EXPECT_EQ(distanceBetween(line, line).greatest, 0.0);
  EXPECT_NEAR(distanceBetween(line, beside).greatest, 3.0, 1e-14);
  EXPECT_NEAR(distanceBetween(line, beside).mean, 3.0, 1e-14);
  const CurveDistance d = distanceBetween(line, fan);
  EXPECT_NEAR(d.greatest, 8.0, 1e-14);
  double sum = 0.0;
  for (int i = 0; i <= 8; ++i) sum += std::pow(i, 4) / 9;
  EXPECT_NEAR(d.mean, std::pow(sum, 0.25), 1e-13);
  EXPECT_EQ(distanceBetween(fan, line).mean, d.mean);
}

TEST(SectionCurves, ACornerIsWhereTheLineTurnsWithinTheWindow) {
  const SectionCurve box =
      curveThrough({{0, 4, 0}, {0, 4, -1}, {0, 4, -2}, {0, 2, -2}, {0, 0, -2}});
  EXPECT_EQ(cornersOf(box, 0.5, 1.5), (std::vector<double>{2.0}));
  EXPECT_TRUE(cornersOf(box, 0.5, 1.6).empty());  // a right angle is 1.57
  EXPECT_TRUE(cornersOf(box, 2.1, 1.0).empty());  // nearer than the window to the start
  const SectionCurve fold = curveThrough({{0, 0, 0}, {0, 0, -3}, {0, 0, -1}});
  EXPECT_EQ(cornersOf(fold, 0.5, 3.0), (std::vector<double>{3.0}));  // back on itself
}

// Arcs of w before and behind a point of a circle of radius R have chords at an angle of w/R.
TEST(SectionCurvesClosedForm, ABendCountsWhereItsRadiusIsSmall) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 1000; ++i)
    points.emplace_back(0.0, 2 * std::cos(kPi * i / 1000), -2 * std::sin(kPi * i / 1000));
  const SectionCurve circle = curveThrough(points);
  const double window = 0.4;
  EXPECT_FALSE(cornersOf(circle, window, 0.99 * window / 2).empty());
  EXPECT_TRUE(cornersOf(circle, window, 1.01 * window / 2).empty());
}

TEST(SectionCurves, OfTwoCornersTooNearTheSharperStays) {
  const SectionCurve curve = curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 3.8, -2.1}, {0, 0, -2.1}});
  const double sharp = 2.0, window = 0.5;
  const std::vector<double> corners = cornersOf(curve, window, 0.3);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0], sharp);  // 63° there, 27° at the second
}

TEST(SectionCutterClosedForm, ABoxHasItsSection) {
  const SurfaceMesh half = wetBox({20, 8, 3, 1}, 5, 2, 3), whole = bothHalves(half);
  for (const double x : {-9.9, -6.0, 0.1, 2.0, 9.9}) {
    const std::vector<SectionCurve> port = sectionsAt(half, x), both = sectionsAt(whole, x);
    ASSERT_EQ(port.size(), 1u) << x;
    EXPECT_FALSE(port[0].closed);
    EXPECT_NEAR(port[0].length(), 3 + 4, 1e-12);  // round-off
    EXPECT_LT((port[0].points.front() - Vec3(x, 4, 0)).norm(), 1e-12);
    EXPECT_LT((port[0].at(3) - Vec3(x, 4, -3)).norm(), 1e-12);
    EXPECT_LT((port[0].points.back() - Vec3(x, 0, -3)).norm(), 1e-12);
    ASSERT_EQ(both.size(), 1u) << x;
    EXPECT_NEAR(both[0].length(), 3 + 8 + 3, 1e-12);
    EXPECT_LT((both[0].points.back() - Vec3(x, -4, 0)).norm(), 1e-12);  // to starboard
  }
}

TEST(SectionCutter, OnAFlatEndTheSideThatIsAskedForIsCut) {
  const SurfaceMesh box = wetBox({20, 8, 3, 1}, 5, 2, 3);
  const SectionCutter cutter(box, xStations(box));
  EXPECT_EQ(cutter.low(), -10.0);
  EXPECT_EQ(cutter.high(), 10.0);
  EXPECT_TRUE(cutter.curvesAt(-10, Side::Below).empty());
  EXPECT_TRUE(cutter.curvesAt(10, Side::Above).empty());
  for (const auto& curves : {cutter.curvesAt(-10, Side::Above), cutter.curvesAt(10, Side::Below)}) {
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length(), 7.0, 1e-12);
  }
}

TEST(SectionCutter, EachHullHasACurveAndASunkBodyAClosedOne) {
  const SurfaceMesh hull = bothHalves(wetBox({20, 2, 1, 1}, 5, 2, 3));
  const SurfaceMesh two = joined(test::moved(hull, {0, 5, 0}), test::moved(hull, {0, -5, 0}));
  EXPECT_EQ(sectionsAt(two, 1.0).size(), 2u);
  const std::vector<SectionCurve> sunk =
      sectionsAt(test::moved(closedSphere(2.0, 24, 12), {0, 0, -5}), 0.7);
  ASSERT_EQ(sunk.size(), 1u);
  EXPECT_TRUE(sunk[0].closed);
  EXPECT_EQ(sunk[0].points.front(), sunk[0].points.back());
  for (const Vec3& p : sunk[0].points) EXPECT_LE(p.z(), sunk[0].points.front().z());
  // An inscribed polygon of a circle of radius √(4 − 0.49): 24 × 12 faces lack 1 % of it.
  EXPECT_NEAR(sunk[0].length(), 2 * kPi * std::sqrt(3.51), 0.15);
  EXPECT_LT(sunk[0].length(), 2 * kPi * std::sqrt(3.51));
}

TEST(SectionCutterIdentity, CurvesLieOnTheirStationWhateverItIs) {
  const SurfaceMesh hull = wetFrigate(32, 7);
  std::vector<double> station;
  for (const Vec3& p : hull.vertices) station.push_back(p.x() + 0.3 * p.z());
  const SectionCutter cutter(hull, station);
  for (const double c : {-50.0, -3.0, 17.0, 55.0})
    for (const SectionCurve& curve : cutter.curvesAt(c, Side::Above))
      for (const Vec3& p : curve.points) EXPECT_NEAR(p.x() + 0.3 * p.z(), c, 1e-12);  // of 60 m
}

TEST(SectionCutterIdentity, NeitherTheOrderOfFacesNorTheSideMatters) {
  const SurfaceMesh hull = bothHalves(triangulated(wetWigley(wigley(1), 20, 6)));
  const SurfaceMesh image = mirroredInY(hull);
  for (const double x : {-1.2, 0.01, 0.75}) {
    const std::vector<SectionCurve> a = sectionsAt(hull, x),
                                    b = sectionsAt(test::shuffled(hull), x),
                                    c = sectionsAt(image, x);
    ASSERT_EQ(a.size(), 1u);
    ASSERT_EQ(b.size(), 1u);
    ASSERT_EQ(c.size(), 1u);
    EXPECT_LT(distanceBetween(a[0], b[0]).greatest, 1e-14);
    for (int i = 0; i <= 10; ++i) {
      Vec3 p = c[0].at(c[0].length() * (10 - i) / 10);
      p.y() = -p.y();
      EXPECT_LT((a[0].at(a[0].length() * i / 10) - p).norm(), 1e-13);  // round-off of the length
    }
  }
}

}  // namespace
}  // namespace cutwater
