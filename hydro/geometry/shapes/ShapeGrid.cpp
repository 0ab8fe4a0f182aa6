#include "hydro/geometry/shapes/ShapeGrid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

std::vector<double> checkedCount(int n, const char* function) {
  if (n < 1)
    throw HydroError(Fault::BadArgument,
                     std::string(function) + ": " + std::to_string(n) + " divisions");
  return std::vector<double>(static_cast<std::size_t>(n) + 1);
}

/// Points in rows of equal length → faces. Row i holds P(u_i, ·).
SurfaceMesh facesBetween(const std::vector<std::vector<Vec3>>& rows) {
  SurfaceMesh mesh;
  const int m = static_cast<int>(rows[0].size());
  double largest = 0.0;
  for (const auto& row : rows)
    for (const Vec3& p : row) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  for (const auto& row : rows)
    for (Vec3 p : row) {
      for (int i = 0; i < 3; ++i)
        if (std::abs(p[i]) <= 1e-12 * largest) p[i] = 0.0;
      mesh.vertices.push_back(p);
    }
  for (int i = 0; i + 1 < static_cast<int>(rows.size()); ++i)
    for (int j = 0; j + 1 < m; ++j)
      mesh.faces.push_back({{i * m + j, (i + 1) * m + j, (i + 1) * m + j + 1, i * m + j + 1}});
  return welded(mesh, 1e-10 * largest);
}

}  // namespace

std::vector<double> uniform(int n) { return spacedAtEnds(n, 0.0); }

std::vector<double> spacedAtEnds(int n, double c) {
  std::vector<double> u = checkedCount(n, "spacedAtEnds");
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    u[static_cast<std::size_t>(i)] = t - c * std::sin(2 * kPi * t) / (2 * kPi);
  }
  u.back() = 1.0;
  return u;
}

std::vector<double> spacedAtStart(int n, double c) {
  std::vector<double> u = checkedCount(n, "spacedAtStart");
  for (int i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    u[static_cast<std::size_t>(i)] = t - c * std::sin(kPi * t) / kPi;
  }
  u.back() = 1.0;
  return u;
}

std::vector<double> equalArcs(int n, const std::function<Vec3(double)>& curve) {
  return arcsAt(uniform(n), curve);
}

std::vector<double> arcsAt(const std::vector<double>& fractions,
                           const std::function<Vec3(double)>& curve) {
  constexpr int kFine =
      4000;  // the polyline is then short of the curve by about 1e-7 of its length
  std::vector<double> length{0.0};
  Vec3 last = curve(0.0);
  for (int i = 1; i <= kFine; ++i) {
    const Vec3 p = curve(static_cast<double>(i) / kFine);
    length.push_back(length.back() + (p - last).norm());
    last = p;
  }
  if (length.back() <= 0.0) return fractions;  // the curve is a point
  std::vector<double> t = fractions;
  std::size_t k = 0;
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    const double wanted = length.back() * fractions[i];
    while (length[k + 1] < wanted) ++k;
    const double part = (wanted - length[k]) / (length[k + 1] - length[k]);
    t[i] = (static_cast<double>(k) + part) / kFine;
  }
  return t;
}

SurfaceMesh gridSurface(const std::vector<double>& u, const std::vector<double>& v,
                        const std::function<Vec3(double, double)>& point) {
  std::vector<std::vector<Vec3>> rows;
  for (double s : u) {
    auto& row = rows.emplace_back();
    for (double t : v) row.push_back(point(s, t));
  }
  return facesBetween(rows);
}

SurfaceMesh gridOfCurves(const std::vector<double>& u, const std::vector<double>& fractions,
                         const std::function<Vec3(double, double)>& point) {
  std::vector<std::vector<Vec3>> rows;
  for (double s : u) {
    auto& row = rows.emplace_back();
    for (double t : arcsAt(fractions, [&](double v) { return point(s, v); }))
      row.push_back(point(s, t));
  }
  return facesBetween(rows);
}

SurfaceMesh wallSided(const std::vector<double>& u, int up, int acrossDeck,
                      const std::function<Vec3(double)>& deckEdge) {
  const SurfaceMesh wall = gridSurface(u, uniform(up), [&](double s, double t) -> Vec3 {
    const Vec3 top = deckEdge(s);
    return {top.x(), top.y(), t == 1.0 ? 0.0 : top.z() * (1 - t)};
  });
  const SurfaceMesh deck = gridSurface(u, uniform(acrossDeck), [&](double s, double t) -> Vec3 {
    const Vec3 top = deckEdge(s);
    return {top.x(), top.y() * t, top.z()};
  });
  return joined(wall, deck);
}

SurfaceMesh closedFromHalves(const SurfaceMesh& wetHalf, const SurfaceMesh& dryHalf) {
  const SurfaceMesh wet = joined(wetHalf, mirroredInY(wetHalf));
  const SurfaceMesh all = joined(wet, joined(dryHalf, mirroredInY(dryHalf)));
  return welded(all, 1e-9 * bounds(all).diagonal());
}

}  // namespace cutwater
