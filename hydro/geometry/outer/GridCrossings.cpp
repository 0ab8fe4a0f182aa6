#include "hydro/geometry/outer/GridCrossings.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/ParallelFor.h"
#include "hydro/geometry/MeshEdges.h"

namespace cutwater {
namespace {

// A line through the edge of two triangles must meet one of them, whatever the round-off.
constexpr double kInside = 1e-9;
// Faces this much along a line do not cross it: sine of the angle.
constexpr double kAlong = 1e-12;
constexpr double kPiece = 8.0;  // loose edges are looked at in pieces of so many cells

/// Distance between the segments a b and c d.
double segmentDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w),
               vw = v.dot(w), area2 = uu * vv - uv * uv;
  double s = area2 > 1e-14 * uu * vv ? std::clamp((uv * vw - vv * uw) / area2, 0.0, 1.0) : 0.0;
  double least = 1e300;
  for (int i = 0; i < 3; ++i) {  // in turn the nearest point of each: exact after two
    const double t = vv > 0 ? std::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0.0;
    least = std::min(least, (a + s * u - c - t * v).norm());
    s = uu > 0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
  }
  return least;
}

}  // namespace

GridCrossings::GridCrossings(const SurfaceMesh& triangles, const SpaceGrid& grid,
                             double openTolerance)
    : blocked_(grid.nodes(), 0) {
  parallelFor(3, 0, [&](std::size_t axis) { rasterize(triangles, grid, static_cast<int>(axis)); });
  for (int axis = 0; axis < 3; ++axis)
    for (const GridCrossing& c : along(axis))
      blocked_[c.node] = static_cast<std::uint8_t>(blocked_[c.node] | 1 << axis);
  if (openTolerance > 0) blockLooseEdges(triangles, grid, openTolerance);
}

void GridCrossings::rasterize(const SurfaceMesh& triangles, const SpaceGrid& grid, int axis) {
  std::vector<GridCrossing>& out = along_[static_cast<std::size_t>(axis)];
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const Face& face = triangles.faces[f];
    const Vec3 &p = triangles.corner(face, 0), u = triangles.corner(face, 1) - p,
               v = triangles.corner(face, 2) - p;
    const double det = u[a] * v[b] - u[b] * v[a];
    if (std::abs(det) <= kAlong * u.norm() * v.norm()) continue;
    const double lowA = p[a] + std::min({0.0, u[a], v[a]}),
                 highA = p[a] + std::max({0.0, u[a], v[a]});
    const double lowB = p[b] + std::min({0.0, u[b], v[b]}),
                 highB = p[b] + std::max({0.0, u[b], v[b]});
    const int firstB = grid.above(b, lowB);
    SpaceGrid::Index at{};
    for (int i = grid.above(a, lowA); i < grid.count(a) && grid.plane(a, i) <= highA; ++i) {
      for (int j = firstB; j < grid.count(b) && grid.plane(b, j) <= highB; ++j) {
        const double qa = grid.plane(a, i) - p[a], qb = grid.plane(b, j) - p[b];
        const double s = (qa * v[b] - qb * v[a]) / det, t = (u[a] * qb - u[b] * qa) / det;
        if (s < -kInside || t < -kInside || s + t > 1 + kInside) continue;
        const double place = p[axis] + s * u[axis] + t * v[axis];
        const int below = grid.above(axis, place) - 1;
        if (below < 0 || below >= grid.count(axis) - 1) continue;
        at[static_cast<std::size_t>(a)] = i;
        at[static_cast<std::size_t>(b)] = j;
        at[static_cast<std::size_t>(axis)] = below;
        out.push_back({static_cast<std::uint32_t>(grid.node(at)), static_cast<int>(f), place});
      }
    }
  }
  std::sort(out.begin(), out.end(), [](const GridCrossing& l, const GridCrossing& r) {
    return l.node != r.node ? l.node < r.node : l.at < r.at;
  });
}

void GridCrossings::blockLooseEdges(const SurfaceMesh& triangles, const SpaceGrid& grid,
                                    double tolerance) {
  const double piece =
      kPiece * (grid.plane(0, grid.count(0) - 1) - grid.plane(0, 0)) / grid.count(0);
  for (const OpenEdge& e : looseEdges(triangles)) {
    const Vec3 &p = triangles.vertices[static_cast<std::size_t>(e.from)],
               along = triangles.vertices[static_cast<std::size_t>(e.to)] - p;
    const int pieces = 1 + static_cast<int>(along.norm() / piece);
    for (int i = 0; i < pieces; ++i)
      blockNear(p + along * i / pieces, p + along * (i + 1) / pieces, grid, tolerance);
  }
}

void GridCrossings::blockNear(const Vec3& p, const Vec3& q, const SpaceGrid& grid,
                              double tolerance) {
  SpaceGrid::Index first{}, last{}, at{};
  for (int d = 0; d < 3; ++d) {
    const auto i = static_cast<std::size_t>(d);
    first[i] = std::max(grid.above(d, std::min(p[d], q[d]) - tolerance) - 1, 0);
    last[i] = std::min(grid.above(d, std::max(p[d], q[d]) + tolerance), grid.count(d) - 1);
  }
  const auto check = [&](int d) {
    if (at[static_cast<std::size_t>(d)] + 1 >= grid.count(d)) return;
    const Vec3 here = grid.place(at);
    Vec3 next = here;
    next[d] = grid.plane(d, at[static_cast<std::size_t>(d)] + 1);
    std::uint8_t& blocked = blocked_[grid.node(at)];
    if ((blocked >> d & 1) == 0 && segmentDistance(here, next, p, q) < tolerance)
      blocked = static_cast<std::uint8_t>(blocked | 1 << d);
  };
  for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
      for (at[0] = first[0]; at[0] <= last[0]; ++at[0])
        for (int d = 0; d < 3; ++d) check(d);
}

std::pair<const GridCrossing*, const GridCrossing*> GridCrossings::on(std::size_t node,
                                                                      int axis) const {
  const std::vector<GridCrossing>& list = along(axis);
  const GridCrossing* first =
      std::lower_bound(list.data(), list.data() + list.size(), node,
                       [](const GridCrossing& c, std::size_t n) { return c.node < n; });
  const GridCrossing* last = first;
  while (last != list.data() + list.size() && last->node == node) ++last;
  return {first, last};
}

}  // namespace cutwater
