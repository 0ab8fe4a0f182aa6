#include "hydro/geometry/PanelQuadrature.h"

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

Panel withLastCornerSet(const Panel& panel) {
  Panel quad = panel;
  if (panel.corners == 3) quad.corner[3] = panel.corner[2];
  return quad;
}

}  // namespace

const std::vector<std::pair<double, double>>& gaussLegendre(int n) {
  static const auto rules = makeRules();
  return rules.at(static_cast<std::size_t>(n));
}

std::vector<QuadraturePoint> panelQuadrature(const Panel& panel, int n) {
  const Panel quad = withLastCornerSet(panel);
  std::vector<QuadraturePoint> points;
  points.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (const auto& [u, weightU] : gaussLegendre(n))
    for (const auto& [v, weightV] : gaussLegendre(n))
      points.push_back({bilinear(quad, u, v), weightU * weightV * jacobian(quad, u, v)});
  return points;
}

std::vector<QuadraturePoint> polarQuadrature(const Panel& panel, const Vec3& apex, int n) {
  std::vector<QuadraturePoint> points;
  for (int i = 0; i < panel.corners; ++i) {
    const Vec3 a = panel.corner[static_cast<std::size_t>(i)] - apex;
    const Vec3 b = panel.corner[static_cast<std::size_t>((i + 1) % panel.corners)] - apex;
    const double twiceArea = a.cross(b).dot(panel.normal);
    for (const auto& [s, weightS] : gaussLegendre(n))
      for (const auto& [t, weightT] : gaussLegendre(n))
        points.push_back({apex + s * (a + t * (b - a)), twiceArea * s * weightS * weightT});
  }
  return points;
}

std::array<Panel, 4> quarters(const Panel& panel) {
  const Panel quad = withLastCornerSet(panel);
  std::array<Panel, 4> parts;
  for (int i = 0; i < 4; ++i) {
    const double u = 0.5 * (i % 2), v = 0.5 * (i / 2);
    Panel& part = parts[static_cast<std::size_t>(i)];
    part = quad;
    part.corners = 4;
    part.corner = {bilinear(quad, u, v), bilinear(quad, u + 0.5, v),
                   bilinear(quad, u + 0.5, v + 0.5), bilinear(quad, u, v + 0.5)};
    part.centroid = bilinear(quad, u + 0.25, v + 0.25);
    part.area = 0.25 * jacobian(quad, u + 0.25, v + 0.25);
  }
  return parts;
}

}  // namespace cutwater
