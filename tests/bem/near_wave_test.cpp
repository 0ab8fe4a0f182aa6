#include <gtest/gtest.h>

#include "tests/bem/Bodies.h"

// The split wave term near the image of a panel against plain brute force.
namespace cutwater::test {
namespace {

Panel quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  SurfaceMesh mesh{{a, b, c, d}, {Face{{0, 1, 2, 3}}}};
  return makePanels(mesh, false).panels[0];
}

/// The wave part with a panel cut into 4^depth parts of 5 × 5 points.
WaveIntegral bruteForce(const Vec3& x, const Panel& panel, double K, int depth) {
  WaveIntegral sum{};
  if (depth > 0) {
    for (const Panel& part : quarters(panel)) {
      const WaveIntegral share = bruteForce(x, part, K, depth - 1);
      sum.value += share.value;
      sum.along += share.along;
    }
    return sum;
  }
  for (const QuadraturePoint& point : panelQuadrature(panel, 5)) {
    const double dx = point.x.x() - x.x(), dy = point.x.y() - x.y(), h = std::hypot(dx, dy);
    const WavePoint w(K, K * h, -K * (x.z() + point.x.z()));
    sum.value += point.weight * w.value;
    sum.along += point.weight * ((panel.normal.x() * dx + panel.normal.y() * dy) / h * w.slope -
                                 panel.normal.z() * w.rise);
  }
  return sum;
}

RankinePanel rankineOf(const Panel& panel) {
  return RankinePanel(std::span(panel.corner.data(), static_cast<std::size_t>(panel.corners)));
}

NearImage imageOf(const Vec3& x, const Panel& panel) {
  QuarteredPanel quartered(panel);
  return nearImage(x, quartered, rankineOf(panel), panel.normal);
}

WaveIntegral split(const Vec3& x, const Panel& panel, double K) {
  const QuadraturePoint field{x, 1.0};
  const NearSums sums({&field, 1}, false, panelQuadrature(panel, 2), K);
  return nearWave(sums, 1.0, imageOf(x, panel), panel.normal, K);
}

// What is left after the split varies as R ln R over a panel; 2 × 2 points leave a small part of
// K·size of it: 1e-3 of the whole for panels a quarter of a wave number long (Kh = 0.25).
TEST(NearWaveConvergence, SplitTermOfAWaterlinePanelAndItsNeighbours) {
  const Panel wall = quad({0, 0.1, 0}, {0.25, 0, 0}, {0.25, 0, -0.25}, {0, 0.1, -0.25});
  const double K = 1.0;
  for (const Vec3& x : {wall.centroid, Vec3(0.4, 0.05, -0.12), Vec3(0.1, -0.1, 0.0)}) {
    const WaveIntegral exact = bruteForce(x, wall, K, 4), got = split(x, wall, K);
    EXPECT_LT(std::abs(got.value - exact.value), 1e-3 * std::abs(exact.value));
    EXPECT_LT(std::abs(got.along - exact.along),
              3e-3 * std::abs(exact.value) * K + 1e-3 * std::abs(exact.along));
  }
}

// The wave term knows the distance only: field and source exchanged, one of them perhaps at −y, are
// the same sums, to round-off of their order.
TEST(NearWaveIdentity, ExchangedSumsAreThoseOfExchangedPanels) {
  const auto a = sevenPoints(quad({0, 1, 0}, {2, 1.1, 0}, {2, 0.9, -1}, {0, 0.8, -1}));
  const auto b = panelQuadrature(quad({2, 1.1, 0}, {4, 0.8, 0}, {4, 0.7, -1}, {2, 0.9, -1}), 2);
  for (const bool mirrored : {false, true})
    for (const double K : {0.05, 0.5, 3.0}) {
      const NearSums back = NearSums(a, mirrored, b, K).exchanged(mirrored),
                     direct(b, mirrored, a, K);
      const auto same = [](double x, double y) { EXPECT_NEAR(x, y, 1e-12 * (1.0 + std::abs(y))); };
      same(back.weights, direct.weights);
      same(back.smooth, direct.smooth);
      same(back.rest, direct.rest);
      same(back.restUp, direct.restUp);
      same(back.oscillation, direct.oscillation);
      for (const auto along :
           {&NearSums::smoothAlong, &NearSums::restAlong, &NearSums::oscillationAlong}) {
        same((back.*along).x, (direct.*along).x);
        same((back.*along).y, (direct.*along).y);
      }
    }
}

// 4 and 7 points on either panel against 12 × 12. Of waves they leave θ⁴/270 and θ⁶/12500,
// θ = K·diameter/2, on each of two panels. Of the rest, smooth but for R ln R where the panels
// meet, K·size/100.
TEST(NearWaveConvergence, FewPointsOnBothPanels) {
  const Panel wall = quad({0, 0, 0}, {3, 0, 0}, {3, 0, -2}, {0, 0, -2}),
              next = quad({3, 0, 0}, {6, 0.5, 0}, {6, 0.4, -2}, {3, 0, -2});
  for (const auto& [degree, K] : {std::pair{3, 0.2}, {3, 0.6}, {5, 0.6}, {5, 1.0}}) {
    const auto points = [degree = degree](const Panel& panel) {
      return degree == 3 ? panelQuadrature(panel, 2) : sevenPoints(panel);
    };
    const NearSums few(points(wall), false, points(next), K),
        many(panelQuadrature(wall, 12), false, panelQuadrature(next, 12), K);
    const double theta = 0.5 * K * diameter(wall), size = many.weights;
    const double ofWaves =
        2.0 * size * (degree == 3 ? std::pow(theta, 4) / 270.0 : std::pow(theta, 6) / 12500.0);
    const double ofRest = 0.01 * 2.0 * theta * size;
    EXPECT_LT(std::abs(few.oscillation - many.oscillation), ofWaves) << K;
    EXPECT_LT(std::abs(few.oscillationAlong.x - many.oscillationAlong.x), ofWaves) << K;
    EXPECT_LT(std::abs(few.oscillationAlong.y - many.oscillationAlong.y), ofWaves) << K;
    EXPECT_LT(std::abs(few.smooth - many.smooth), ofRest) << K;
    EXPECT_LT(std::abs(few.smoothAlong.x - many.smoothAlong.x), ofRest) << K;
  }
}

// In the plane of the lid ρ = r, and ∫∫ ln r over the square of side 2 about its centre is
// 2 ln 2 − 6 + π.
TEST(NearWaveClosedForm, LogarithmOverALidPanelAboutItsCentre) {
  const Panel lid = quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  EXPECT_NEAR(imageOf(Vec3::Zero(), lid).log, 2.0 * std::log(2.0) - 6.0 + kPi, 1e-12);
}

// The quadrature of tilted panels must agree with the exact form of panels on z = 0, from 1e-8
// below.
TEST(NearWaveConvergence, QuadratureOfTheLogarithmMeetsTheExactFormOnTheLid) {
  const Panel lid = quad({1, -1, 0}, {3, -1, 0}, {3, 1, 0}, {1, 1, 0});
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0.3, 1.4, 0), Vec3(-1.5, 0.2, 0)}) {
    const double exact = imageOf(x, lid).log;
    EXPECT_NEAR(imageOf(x - Vec3(0, 0, 1e-8), lid).log, exact, 1e-5 * lid.area);
  }
}

}  // namespace
}  // namespace cutwater::test
