#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/SectionStrands.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

namespace cutwater {
namespace {

std::vector<SectionStrand> strandsOf(const SurfaceMesh& wet, double reach) {
  std::vector<double> x;
  for (const Vec3& p : wet.vertices) x.push_back(p.x());
  return sectionStrands(SectionCutter(wet, x), reach);
}

/// Places rise, and from one to the next nothing moves by more than reach.
void expectFollowed(const SectionStrand& strand, double reach) {
  ASSERT_EQ(strand.place.size(), strand.curves.size());
  for (std::size_t k = 1; k < strand.place.size(); ++k) {
    EXPECT_GT(strand.place[k], strand.place[k - 1]);
    EXPECT_LE(distanceBetween(strand.curves[k - 1], strand.curves[k]).greatest, reach);
  }
}

/// Port half of a wedge 20 m long and 4 m deep whose lower half goes on for 5 m: a bow with a bulb.
/// The half breadth falls by 0.1 a metre; the bulb's top is level.
SurfaceMesh bulbousWedge() {
  const auto breadth = [](double x) { return 0.1 * (20 - x); };
  const auto lower = [](double x) { return 0.1 * (25 - x); };
  SurfaceMesh mesh;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& p : {a, b, c, d}) mesh.vertices.push_back(p);
    mesh.faces.push_back({{first, first + 1, first + 2, first + 3}});
  };
  for (int x = 0; x < 25; ++x) {
    const double p = x, q = x + 1.0;
    if (x < 20)
      quad({p, breadth(p), 0}, {q, breadth(q), 0}, {q, breadth(q), -2}, {p, breadth(p), -2});
    const double pIn = std::max(0.0, breadth(p)), qIn = std::max(0.0, breadth(q));
    quad({p, pIn, -2}, {q, qIn, -2}, {q, lower(q), -2}, {p, lower(p), -2});
    quad({p, lower(p), -2}, {q, lower(q), -2}, {q, lower(q), -4}, {p, lower(p), -4});
    quad({p, lower(p), -4}, {q, lower(q), -4}, {q, 0, -4}, {p, 0, -4});
  }
  return welded(mesh, 1e-9);
}

TEST(SectionStrandsClosedForm, ABoxIsOneStrandFromEndToEnd) {
  for (const SurfaceMesh& box :
       {wetBox({20, 8, 3, 1}, 5, 2, 3), bothHalves(wetBox({20, 8, 3, 1}, 5, 2, 3))}) {
    const std::vector<SectionStrand> strands = strandsOf(box, 0.5);
    ASSERT_EQ(strands.size(), 1u);
    EXPECT_EQ(strands[0].place.front(), -10.0);
    EXPECT_EQ(strands[0].place.back(), 10.0);
    EXPECT_TRUE(strands[0].start.alone());
    EXPECT_TRUE(strands[0].end.alone());
    for (const SectionCurve& c : strands[0].curves)
      EXPECT_NEAR(c.length(), strands[0].curves[0].length(), 1e-12);  // round-off
    expectFollowed(strands[0], 1.001 * 20 / 160);  // stations are what moves: at least 160
  }
}

TEST(SectionStrands, SamplesAreDenserWhereTheSectionMovesFast) {
  const SurfaceMesh ball = wetHemisphere(10.0, 80, 40);
  for (const double reach : {0.5, 0.1}) {
    const std::vector<SectionStrand> strands = strandsOf(ball, reach);
    ASSERT_EQ(strands.size(), 1u);
    expectFollowed(strands[0], reach);
  }
  // Near its ends a section's radius grows as the root of the distance: 160 equal steps begin with
  // one of 1.6 m.
  EXPECT_GT(strandsOf(ball, 0.1)[0].place.size(), 2 * strandsOf(ball, 20.0)[0].place.size());
}

TEST(SectionStrands, EachOfSeveralHullsIsAStrand) {
  const SurfaceMesh one = bothHalves(wetWigley({20, 3, 2, 0}, 24, 6));
  const SurfaceMesh three =
      joined(one, joined(test::moved(one, {0, 8, 0}), test::moved(one, {-30, 0, 0})));
  const std::vector<SectionStrand> strands = strandsOf(three, 0.3);
  ASSERT_EQ(strands.size(), 3u);
  std::vector<double> starts;
  for (const SectionStrand& s : strands) {
    EXPECT_TRUE(s.start.alone() && s.end.alone());
    expectFollowed(s, 0.3);
    starts.push_back(s.place.front());
  }
  std::sort(starts.begin(), starts.end());
  // Curves shorter than a third of the reach are not where a sharp stem begins to be followed.
  EXPECT_NEAR(starts[0], -40.0, 0.5);
  EXPECT_NEAR(starts[1], -10.0, 0.5);
  EXPECT_NEAR(starts[2], -10.0, 0.5);
}

TEST(SectionStrandsClosedForm, ABulbIsTheGuestOfTheHullThatItGoesOnFrom) {
  const std::vector<SectionStrand> strands = strandsOf(bulbousWedge(), 0.4);
  ASSERT_EQ(strands.size(), 2u);
  const bool first = strands[0].place.front() < strands[1].place.front();
  const SectionStrand &hull = strands[first ? 0 : 1], &bulb = strands[first ? 1 : 0];
  EXPECT_EQ(hull.place.front(), 0.0);
  EXPECT_EQ(bulb.place.back(), 25.0);
  EXPECT_NEAR(hull.place.back(), 20.0, 1e-5);  // the place of a jump is known to 2.5e-8 of 25 m
  EXPECT_NEAR(bulb.place.front(), 20.0, 1e-5);
  ASSERT_EQ(hull.end.guests.size(), 1u);
  EXPECT_FALSE(hull.end.hosted);
  EXPECT_TRUE(bulb.start.hosted);
  EXPECT_TRUE(bulb.start.guests.empty());
  EXPECT_TRUE(hull.start.alone() && bulb.end.alone());
  EXPECT_NEAR(hull.end.guests[0].length(), 0.5 + 2 + 0.5, 1e-5);
  EXPECT_NEAR(hull.curves.back().length(), 2 + 3, 1e-5);
}

// Turned end for end, the bulb is the guest of the strand's start.
TEST(SectionStrandsIdentity, TurnedEndForEndTheStrandsAreTheSame) {
  SurfaceMesh turned = mirroredInY(bulbousWedge());
  for (Vec3& p : turned.vertices) p = {-p.x(), -p.y(), p.z()};  // by half a turn: port again
  const std::vector<SectionStrand> strands = strandsOf(turned, 0.4);
  ASSERT_EQ(strands.size(), 2u);
  std::size_t guests = 0;
  for (const SectionStrand& s : strands) {
    guests += s.start.guests.size();
    EXPECT_TRUE(s.end.guests.empty());
    expectFollowed(s, 0.4);
  }
  EXPECT_EQ(guests, 1u);
}

TEST(SectionStrands, WhatIsSmallerThanAThirdOfTheReachIsLeftOut) {
  const SurfaceMesh hull = bothHalves(wetBox({20, 8, 3, 1}, 5, 2, 3));
  SurfaceMesh knob = closedSphere(0.1, 12, 6);
  for (Vec3& p : knob.vertices) p = {20 * p.x(), p.y(), p.z() - 8};  // so long that samples meet it
  const double girth = 2 * kPi * 0.1;
  EXPECT_EQ(strandsOf(joined(hull, knob), 3.1 * girth).size(), 1u);
  EXPECT_EQ(strandsOf(joined(hull, knob), 0.5 * girth).size(), 2u);
}

TEST(SectionStrandsIdentity, TheOrderOfFacesDoesNotMatter) {
  const SurfaceMesh wedge = triangulated(bulbousWedge());
  const std::vector<SectionStrand> a = strandsOf(wedge, 0.4),
                                   b = strandsOf(test::shuffled(wedge), 0.4);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].place, b[k].place);
}

}  // namespace
}  // namespace cutwater
