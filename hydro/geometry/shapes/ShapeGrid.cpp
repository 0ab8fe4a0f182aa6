#include "hydro/geometry/shapes/ShapeGrid.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater {
namespace {

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
