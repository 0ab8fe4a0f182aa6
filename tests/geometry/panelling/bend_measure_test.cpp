#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/BendMeasure.h"

namespace cutwater {
namespace {

/// A circular section of this radius over an angle, of so many chords that these do not matter.
SectionCurve bilge(double radius, double angle) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 20'000; ++i) {
    const double a = angle * i / 20'000;
    points.emplace_back(0.0, radius * std::cos(a), -radius * std::sin(a));
  }
  return curveThrough(points);
}

/// 2 m down the side, 4 m along the bottom.
SectionCurve boxSection() { return curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 0, -2}}); }

TEST(BendMeasureClosedForm, AlongAStraightLineItIsTheLength) {
  const BendMeasure measure(curveThrough({{0, 3, 0}, {0, 2, -1}, {0, 0, -3}}), {}, 0.7);
  const double length = 3 * std::sqrt(2.0);
  // Each of about 40 chords turns by the root of round-off, 1e-8, at most.
  EXPECT_NEAR(measure.total(), length, 1e-6);
  EXPECT_TRUE(measure.corners().empty());
  for (const double m : {0.0, 0.3, 1.7, length}) EXPECT_NEAR(measure.arcAt(m), m, 1e-6);
}

// The turn between n chords is (n − 1)/n of the whole: at the ends there is none to be seen.
TEST(BendMeasureClosedForm, ATurnOfOneRadianCountsAsFourTenthsOfAPanel) {
  for (const double size : {0.1, 0.5, 2.0, 50.0})
    for (const double angle : {0.5, kPi / 2, kPi}) {
      const double length = 3.0 * angle;
      const int n = std::max(2, static_cast<int>(std::ceil(length / (0.15 * size))));
      const BendMeasure measure(bilge(3.0, angle), {}, size);
      // The polygon's own chords of 1e-4 rad are off the circle by their square.
      EXPECT_NEAR(measure.total(), length + 0.4 * size * angle * (n - 1) / n, 1e-5 * size + 1e-7);
    }
}

// ∫(1 + w e^{−d/size}) ds along both straight lines, w = 90° − 20°.
TEST(BendMeasureClosedForm, ACornerCountsOnBothSidesAndFadesAlongThem) {
  const double w = 70 * kPi / 180;
  for (const double size : {0.3, 0.5, 2.0}) {
    const auto extra = [&](double length) { return w * size * (1 - std::exp(-length / size)); };
    const BendMeasure measure(boxSection(), {2.0}, size);
    ASSERT_EQ(measure.corners().size(), 1u);
    EXPECT_NEAR(measure.corners()[0], 2.0 + extra(2.0), 1e-6);
    EXPECT_NEAR(measure.total(), 6.0 + extra(2.0) + extra(4.0), 1e-6);
    EXPECT_NEAR(measure.arcAt(measure.corners()[0]), 2.0, 1e-12);
    // 1 + w times denser at the corner; the steps of the measure, 0.15 of a panel, blur it.
    const double near = 0.01 * size;
    EXPECT_NEAR(measure.arcAt(measure.corners()[0] + near) - 2.0, near / (1 + w), 0.1 * near);
  }
}

// A hollow corner, as of a keel's foot, has slow water; of a soft one nothing is left at 20°.
TEST(BendMeasureClosedForm, AHollowCornerDoesNotCountAndASoftOneFadesOut) {
  const BendMeasure hollow(curveThrough({{0, 4, 0}, {0, 1, 0}, {0, 1, -3}}), {3.0}, 0.5);
  EXPECT_NEAR(hollow.total(), 6.0, 1e-6);
  const auto soft = [](double degrees) {
    const double a = degrees * kPi / 180;
    const SectionCurve curve =
        curveThrough({{0, 5, 0}, {0, 5, -3}, {0, 5 - 3 * std::sin(a), -3 - 3 * std::cos(a)}});
    return BendMeasure(curve, {3.0}, 0.5).total();
  };
  EXPECT_NEAR(soft(19.9), 6.0, 1e-6);
  EXPECT_NEAR(soft(21), 6.0 + kPi / 180 * 2 * 0.5 * (1 - std::exp(-6.0)), 1e-6);
}

TEST(BendMeasureClosedForm, ACornerThatIsNotNamedIsABend) {
  // Turns in one plane add up to a right angle, wherever chords begin; the chord across the corner
  // is shorter than its part of the length, which is what counts.
  EXPECT_NEAR(BendMeasure(boxSection(), {}, 0.5).total(), 6.0 + 0.4 * 0.5 * kPi / 2, 1e-6);
}

// The mirror image, walked along from its other end, still down one side and along the bottom.
TEST(BendMeasureIdentity, ItDoesNotMatterWhereTheCurveBegins) {
  SectionCurve curve =
      curveThrough({{0, 5, 0}, {0, 5, -1}, {0, 4, -3}, {0, 2, -3.5}, {0, 0, -3.6}});
  std::vector<Vec3> points = curve.points;
  std::reverse(points.begin(), points.end());
  for (Vec3& p : points) p.y() *= -1.0;
  const double corner = 1.0, size = 0.4;
  const BendMeasure a(curve, {corner}, size),
      b(curveThrough(points), {curve.length() - corner}, size);
  EXPECT_NEAR(a.total(), b.total(), 1e-9);  // round-off of turns near zero, see above
  EXPECT_NEAR(b.arcAt(b.corners()[0]), curve.length() - corner, 1e-9);  // behind all bends
  EXPECT_NEAR(a.corners()[0] + b.corners()[0], a.total(), 1e-9);
  for (const double part : {0.1, 0.35, 0.8})
    EXPECT_NEAR(a.arcAt(part * a.total()), curve.length() - b.arcAt((1 - part) * b.total()), 1e-9);
}

TEST(BendMeasure, LengthRisesWithIt) {
  const SectionCurve curve = curveThrough({{0, 4, 0}, {0, 4, -2}, {0, 3.5, -2.6}, {0, 0, -3}});
  const BendMeasure measure(curve, {2.0}, 0.6);
  EXPECT_EQ(measure.arcAt(0.0), 0.0);
  EXPECT_NEAR(measure.arcAt(measure.total()), curve.length(), 1e-14);
  EXPECT_NEAR(measure.arcAt(2 * measure.total()), curve.length(), 1e-14);  // held at the end
  double before = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const double arc = measure.arcAt(measure.total() * i / 100);
    EXPECT_GT(arc, before);
    before = arc;
  }
}

// Equal steps of the measure are shorter where the section bends.
TEST(BendMeasure, StepsAreShorterInTheBilge) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 10; ++i) points.emplace_back(0.0, 3.0, -0.2 * i);
  for (int i = 1; i <= 40; ++i) {
    const double a = 0.5 * kPi * i / 40;  // a bilge of 0.5 m radius
    points.emplace_back(0.0, 2.5 + 0.5 * std::cos(a), -2 - 0.5 * std::sin(a));
  }
  points.emplace_back(0.0, 0.0, -2.5);
  const SectionCurve curve = curveThrough(points);
  const BendMeasure measure(curve, {}, 1.0);
  const double step = measure.total() / 60;
  double least = 1e300, most = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double part = measure.arcAt((i + 1) * step) - measure.arcAt(i * step);
    least = std::min(least, part);
    most = std::max(most, part);
  }
  // 1 m of length counts 1 + 0.4 × 1 m / 0.5 m in the bilge; chords of 0.15 m blur its ends.
  EXPECT_NEAR(most / least, 1.8, 0.1);
}

}  // namespace
}  // namespace cutwater
