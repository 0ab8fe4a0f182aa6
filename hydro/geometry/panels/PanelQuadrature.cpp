#include "hydro/geometry/panels/PanelQuadrature.h"

#include <cmath>

namespace cutwater {
namespace {

constexpr int kMostPoints = 16;

/// Newton's method on the Legendre polynomial from the usual cosine estimate.
std::vector<std::pair<double, double>> makeRule(int n) {
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 8; ++step) {
      double p = 1.0, before = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    rule.emplace_back(0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

std::vector<std::vector<std::pair<double, double>>> makeRules() {
  std::vector<std::vector<std::pair<double, double>>> rules(1);
  for (int n = 1; n <= kMostPoints; ++n) rules.push_back(makeRule(n));
  return rules;
}

Vec3 bilinear(const Panel& p, double u, double v) {
  return (1 - u) * (1 - v) * p.corner[0] + u * (1 - v) * p.corner[1] + u * v * p.corner[2] +
         (1 - u) * v * p.corner[3];
}

/// dS/(du dv), positive on a convex panel.
double jacobian(const Panel& p, double u, double v) {
  const Vec3 alongU = (1 - v) * (p.corner[1] - p.corner[0]) + v * (p.corner[2] - p.corner[3]);
  const Vec3 alongV = (1 - u) * (p.corner[3] - p.corner[0]) + u * (p.corner[2] - p.corner[1]);
  return alongU.cross(alongV).dot(p.normal);
}

void addQuad(const Panel& quad, int n, std::vector<QuadraturePoint>& points) {
  for (const auto& [u, weightU] : gaussLegendre(n))
    for (const auto& [v, weightV] : gaussLegendre(n))
      points.push_back({bilinear(quad, u, v), weightU * weightV * jacobian(quad, u, v)});
}

Vec3 middle(const Vec3& a, const Vec3& b) { return 0.5 * (a + b); }

/// The panel's plane with other corners.
Panel withCorners(const Panel& plane, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Panel quad = plane;
  quad.corners = 4;
  quad.corner = {a, b, c, d};
  quad.centroid = bilinear(quad, 0.5, 0.5);  // of a parallelogram; only its neighbourhood matters
  quad.area = jacobian(quad, 0.5, 0.5);
  return quad;
}

Panel triangle(const Panel& plane, const Vec3& a, const Vec3& b, const Vec3& c) {
  Panel part = withCorners(plane, a, b, c, c);
  part.corners = 3;
  part.centroid = (a + b + c) / 3.0;
  part.area = 0.25 * plane.area;
  return part;
}

}  // namespace

const std::vector<std::pair<double, double>>& gaussLegendre(int n) {
  static const auto rules = makeRules();
  return rules.at(static_cast<std::size_t>(n));
}

std::vector<QuadraturePoint> panelQuadrature(const Panel& panel, int n) {
  std::vector<QuadraturePoint> points;
  points.reserve(static_cast<std::size_t>((panel.corners == 3 ? 3 : 1) * n * n));
  const auto& c = panel.corner;
  if (panel.corners == 3) {
    const Vec3 ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
    const Vec3 centre = (c[0] + c[1] + c[2]) / 3.0;
    addQuad(withCorners(panel, c[0], ab, centre, ca), n, points);
    addQuad(withCorners(panel, c[1], bc, centre, ab), n, points);
    addQuad(withCorners(panel, c[2], ca, centre, bc), n, points);
  } else {
    addQuad(panel, n, points);
  }
  return points;
}

std::vector<QuadraturePoint> sevenPoints(const Panel& panel) {
  std::vector<QuadraturePoint> points;
  points.reserve(7);
  if (panel.corners == 3) {
    const auto& [a, b, c, unused] = panel.corner;
    const Vec3 sum = a + b + c;
    points.push_back({sum / 3.0, 0.225 * panel.area});
    for (const double root : {std::sqrt(15.0), -std::sqrt(15.0)})
      for (const Vec3& corner : {a, b, c}) {
        const double share = (6.0 + root) / 21.0;  // of the other two corners
        points.push_back(
            {share * sum + (1.0 - 3.0 * share) * corner, (155.0 + root) / 1200.0 * panel.area});
      }
    return points;
  }
  // The rule is three times as good along v as along u: v along the longer edges.
  const auto& c = panel.corner;
  const bool turned =
      (c[1] - c[0]).norm() + (c[3] - c[2]).norm() > (c[3] - c[0]).norm() + (c[2] - c[1]).norm();
  const auto put = [&](double u, double v, double weight) {
    const double x = 0.5 * (1.0 + (turned ? v : u)), y = 0.5 * (1.0 + (turned ? u : v));
    points.push_back({bilinear(panel, x, y), weight * jacobian(panel, x, y)});
  };
  put(0.0, 0.0, 2.0 / 7.0);
  for (const double side : {-1.0, 1.0}) {
    put(0.0, side * std::sqrt(14.0 / 15.0), 5.0 / 63.0);
    for (const double other : {-1.0, 1.0})
      put(side * std::sqrt(0.6), other * std::sqrt(1.0 / 3.0), 5.0 / 36.0);
  }
  return points;
}

Eigen::Matrix3d secondMoments(const Panel& panel) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const QuadraturePoint& point : panelQuadrature(panel, 2)) {
    const Vec3 s = point.x - panel.centroid;
    sum += point.weight * s * s.transpose();
  }
  return sum;
}

std::array<Panel, 4> quarters(const Panel& panel) {
  const auto& c = panel.corner;
  const Vec3 ab = middle(c[0], c[1]), bc = middle(c[1], c[2]);
  if (panel.corners == 3) {
    const Vec3 ca = middle(c[2], c[0]);
    return {triangle(panel, c[0], ab, ca), triangle(panel, ab, c[1], bc),
            triangle(panel, ca, bc, c[2]), triangle(panel, bc, ca, ab)};
  }
  const Vec3 cd = middle(c[2], c[3]), da = middle(c[3], c[0]), centre = middle(ab, cd);
  return {withCorners(panel, c[0], ab, centre, da), withCorners(panel, ab, c[1], bc, centre),
          withCorners(panel, centre, bc, c[2], cd), withCorners(panel, da, centre, cd, c[3])};
}

}  // namespace cutwater
