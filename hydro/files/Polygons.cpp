#include "hydro/files/Polygons.h"

#include <algorithm>

namespace cutwater {
namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The polygon seen along its vector area, counter-clockwise.
std::vector<Vec2> seenFromOutside(const SurfaceMesh& mesh, const std::vector<int>& corners) {
  const auto at = [&](std::size_t i) -> const Vec3& {
    return mesh.vertices[static_cast<std::size_t>(corners[i % corners.size()])];
  };
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += (at(i) - at(0)).cross(at(i + 1) - at(0));
  const Vec3 n = area.norm() > 0 ? Vec3(area.normalized()) : Vec3::UnitZ();
  const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<Vec2> seen;
  for (std::size_t i = 0; i < corners.size(); ++i)
    seen.emplace_back(u.dot(at(i) - at(0)), v.dot(at(i) - at(0)));
  return seen;
}

bool inTriangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

bool isEar(const std::vector<Vec2>& p, const std::vector<std::size_t>& left, std::size_t i) {
  const std::size_t n = left.size();
  const std::size_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
  if (cross(p[a], p[b], p[c]) <= 0) return false;
  for (std::size_t k : left) {
    if (k == a || k == b || k == c || p[k] == p[a] || p[k] == p[b] || p[k] == p[c]) continue;
    if (inTriangle(p[k], p[a], p[b], p[c])) return false;
  }
  return true;
}

bool isConvex(const std::vector<Vec2>& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (cross(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) < 0) return false;
  return true;
}

}  // namespace

void addPolygon(SurfaceMesh& mesh, const std::vector<int>& corners) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    mesh.faces.push_back({{corners[0], corners[1], corners[2], -1}});
    return;
  }
  const std::vector<Vec2> p = seenFromOutside(mesh, corners);
  if (corners.size() == 4 && isConvex(p)) {
    mesh.faces.push_back({{corners[0], corners[1], corners[2], corners[3]}});
    return;
  }
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  while (left.size() > 2) {
    std::size_t ear = 0;
    while (ear < left.size() && !isEar(p, left, ear)) ++ear;
    if (ear == left.size()) ear = 1;  // degenerate: any cut keeps the surface closed
    const std::size_t n = left.size(), b = ear % n;
    mesh.faces.push_back(
        {{corners[left[(b + n - 1) % n]], corners[left[b]], corners[left[(b + 1) % n]], -1}});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(b));
  }
}

}  // namespace cutwater
