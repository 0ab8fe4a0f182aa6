#include <gtest/gtest.h>

#include <cmath>

#include "hydro/bem/matrices/PanelMoments.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

// Cumulants of a panel's area: what a wave of any direction finds there, to the fourth power.
namespace cutwater::test {
namespace {

Complex logarithmAlong(const Panel& panel, const Eigen::Vector3cd& k) {
  const PanelMoments m(panel);
  const auto along = [&k](const Vec3& axis) {
    return k.x() * axis.x() + k.y() * axis.y() + k.z() * axis.z();
  };
  return m.logarithm(along(m.u), along(m.v));
}

/// Mean of (k·s)ⁿ over a triangle, n = 2, 3, 4, with c_i = k·(corner i): 2n!/(n + 2)! times the sum
/// of all products of n of the c_i.
std::array<Complex, 3> triangleMeans(const std::array<Complex, 3>& c) {
  std::array<Complex, 3> sums{};
  for (std::size_t n = 2; n <= 4; ++n)
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; i + j <= n; ++j) {
        const auto power = [](Complex x, std::size_t p) {
          Complex y = 1.0;
          for (std::size_t q = 0; q < p; ++q) y *= x;
          return y;
        };
        sums[n - 2] += power(c[0], i) * power(c[1], j) * power(c[2], n - i - j);
      }
  return {sums[0] / 6.0, sums[1] / 10.0, sums[2] / 15.0};
}

/// ½μ₂ + μ₃/6 + (μ₄ − 3μ₂²)/24 of a panel cut into two triangles by its diagonal.
Complex exactLogarithm(const Panel& panel, const Eigen::Vector3cd& k) {
  std::array<Complex, 3> mean{};
  for (std::size_t t = 1; t + 1 < static_cast<std::size_t>(panel.corners); ++t) {
    const Vec3 &a = panel.corner[0], &b = panel.corner[t], &c = panel.corner[t + 1];
    const double share = 0.5 * (b - a).cross(c - a).dot(panel.normal) / panel.area;
    const auto along = [&](const Vec3& corner) -> Complex {
      return (k.transpose() * (corner - panel.centroid).cast<Complex>()).value();
    };
    const auto ofThis = triangleMeans({along(a), along(b), along(c)});
    for (std::size_t n = 0; n < 3; ++n) mean[n] += share * ofThis[n];
  }
  return 0.5 * mean[0] + mean[1] / 6.0 + (mean[2] - 3.0 * mean[0] * mean[0]) / 24.0;
}

std::vector<Panel> panelsOfEveryKind() {
  return {flatPanel({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}),                  // rectangle
          flatPanel({{0, 1, -1}, {4, 1.5, -1}, {3.5, 1.275, -3}, {0.5, 0.9, -3}}),  // hull side
          flatPanel({{0, 0, 0}, {2, 1, -1}, {-1, 2, 0}}),                           // triangle
          flatPanel({{0, 0, -5}, {0, 0.01, -5}, {9, 0.01, -5}, {9, 0, -5}})};       // sliver
}

const std::vector<Eigen::Vector3cd> kWaveVectors{
    Eigen::Vector3cd({0.0, -0.3}, {0.0, 0.0},
                     {0.3, 0.0}),  // what waves along x are: K e_z − iK e_x
    Eigen::Vector3cd({0.0, 0.2}, {0.0, -0.2}, {0.28, 0.0}),  // oblique ones
    Eigen::Vector3cd({0.4, 0.0}, {-0.1, 0.0}, {0.0, 0.0})};  // a slope

// The rule behind the moments is exact for powers up to the fourth, on any quadrilateral and
// triangle: round-off.
TEST(PanelMomentsClosedForm, CumulantsAreThoseOfTheTrianglesInAPanel) {
  for (const Panel& panel : panelsOfEveryKind())
    for (const Eigen::Vector3cd& k : kWaveVectors) {
      const Complex exact = exactLogarithm(panel, k);
      EXPECT_LT(std::abs(logarithmAlong(panel, k) - exact), 1e-13 * (1.0 + std::abs(exact)));
    }
}

// A rectangle of sides 2a, 2b: means a²/3 and b²/3 along its sides, no third moment, cumulants
// −2a⁴/15 and 0 across, wherever the axes u, v lie.
TEST(PanelMomentsClosedForm, RectangleKnowsItsSides) {
  const double a = 1.5, b = 0.4;
  const Panel panel = flatPanel({{2 * a, 2 * b, 0}, {0, 2 * b, 0}, {0, 0, 0}, {2 * a, 0, 0}});
  const PanelMoments m(panel);
  const auto [uu, uv, vv] = m.second;
  const Mat3 M = uu * m.u * m.u.transpose() + vv * m.v * m.v.transpose() +
                 0.5 * uv * (m.u * m.v.transpose() + m.v * m.u.transpose());
  EXPECT_LT((M - Mat3(Vec3(a * a / 3.0, b * b / 3.0, 0.0).asDiagonal())).norm(), 1e-14);
  for (const double third : m.third) EXPECT_NEAR(third, 0.0, 1e-14);
  const auto fourth = [&](const Vec3& k) {
    const double ku = k.dot(m.u), kv = k.dot(m.v);
    return m.fourth[0] * std::pow(ku, 4) + m.fourth[1] * std::pow(ku, 3) * kv +
           m.fourth[2] * ku * ku * kv * kv + m.fourth[3] * ku * std::pow(kv, 3) +
           m.fourth[4] * std::pow(kv, 4);
  };
  EXPECT_NEAR(fourth(Vec3::UnitX()), -2.0 / 15.0 * std::pow(a, 4), 1e-13);
  EXPECT_NEAR(fourth(Vec3::UnitY()), -2.0 / 15.0 * std::pow(b, 4), 1e-13);
  EXPECT_NEAR(fourth(Vec3(1.0, 1.0, 0.0)), -2.0 / 15.0 * (std::pow(a, 4) + std::pow(b, 4)), 1e-13);
}

TEST(PanelMomentsIdentity, AxesLieInThePanel) {
  for (const Panel& panel : panelsOfEveryKind()) {
    const PanelMoments m(panel);
    EXPECT_NEAR(m.u.norm(), 1.0, 1e-15);
    EXPECT_NEAR(m.u.dot(panel.normal), 0.0, 1e-12);
    EXPECT_LT((m.u.cross(m.v) - panel.normal).norm(), 1e-12);
  }
}

// The moments belong to the panel, not to where it lies or which corner is the first.
TEST(PanelMomentsIdentity, NeitherPlaceNorFirstCornerMatters) {
  for (const Panel& panel : panelsOfEveryKind()) {
    std::vector<Vec3> corners(panel.corner.begin(), panel.corner.begin() + panel.corners);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    for (Vec3& corner : corners) corner += Vec3(20.0, -7.0, -3.0);
    const Panel moved = flatPanel(corners);
    for (const Eigen::Vector3cd& k : kWaveVectors) {
      const Complex here = logarithmAlong(panel, k);
      // Corners at 20 m lose 4e-15 m of panels of a metre.
      EXPECT_LT(std::abs(logarithmAlong(moved, k) - here), 1e-13 * (1.0 + std::abs(here)));
    }
  }
}

// ln of the mean of e^{k·s} itself: the fifth cumulant is the first that is left out.
TEST(PanelMomentsConvergence, LeavesTheFifthPowerOfTheWaveNumber) {
  const Panel panel = flatPanel({{0, 0, 0}, {2, 1, -1}, {-1, 2, 0}});
  const auto error = [&panel](double scale) {
    const Eigen::Vector3cd k = scale * Eigen::Vector3cd({0.0, 1.0}, {0.0, -0.4}, {1.077, 0.0});
    Complex mean = 0.0;
    for (const QuadraturePoint& at : panelQuadrature(panel, 12))
      mean += at.weight / panel.area *
              std::exp((k.transpose() * (at.x - panel.centroid).cast<Complex>()).value());
    return std::abs(std::log(mean) - logarithmAlong(panel, k));
  };
  EXPECT_NEAR(std::log2(error(0.2) / error(0.1)), 5.0, 0.3);
  EXPECT_LT(error(0.1), 1e-5);
}

}  // namespace
}  // namespace cutwater::test
