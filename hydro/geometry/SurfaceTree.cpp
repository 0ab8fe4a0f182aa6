#include "hydro/geometry/SurfaceTree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutwater {
namespace {

constexpr int kLeaf = 4;               // triangles
constexpr double kMayBeOff = 0.01;     // share of the places
constexpr std::size_t kPlaces = 4000;  // looked at

/// [Möller & Trumbore 1997]
bool crosses(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c,
             double reach) {
  const Vec3 ab = b - a, ac = c - a, p = direction.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-14 * ab.norm() * ac.norm()) return false;
  const Vec3 s = origin - a, q = s.cross(ab);
  const double u = s.dot(p) / det, v = direction.dot(q) / det, t = ac.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-12 && t < reach;
}

/// The point of a triangle nearest to p: the foot on its plane if that is inside, else on an edge.
Vec3 nearestOn(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const bool inside = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                      n.dot((a - c).cross(p - c)) >= 0;
  if (inside && n.squaredNorm() > 0) return p - n * (n.dot(p - a) / n.squaredNorm());
  Vec3 nearest = a;
  for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const Vec3 e = v - u;
    const double l2 = e.squaredNorm();
    const Vec3 q = u + e * (l2 > 0 ? std::clamp((p - u).dot(e) / l2, 0.0, 1.0) : 0.0);
    if ((p - q).squaredNorm() < (p - nearest).squaredNorm()) nearest = q;
  }
  return nearest;
}

double squaredDistanceToBox(const Vec3& p, const Vec3& low, const Vec3& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(Vec3::Zero()).squaredNorm();
}

}  // namespace

SurfaceTree::SurfaceTree(const SurfaceMesh& mesh) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int i = 1; i + 1 < mesh.faces[f].size(); ++i)
      triangles_.push_back({mesh.corner(mesh.faces[f], 0), mesh.corner(mesh.faces[f], i),
                            mesh.corner(mesh.faces[f], i + 1), static_cast<int>(f)});
  if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

int SurfaceTree::build(int first, int count) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Vec3 low = Vec3::Constant(1e300), high = -low;
  const auto begin = triangles_.begin() + first;
  std::for_each(begin, begin + count, [&](const Triangle& t) {
    low = low.cwiseMin(t.a.cwiseMin(t.b).cwiseMin(t.c));
    high = high.cwiseMax(t.a.cwiseMax(t.b).cwiseMax(t.c));
  });
  Node node{low, high, first, count, 0};
  if (count > kLeaf) {
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const int half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](const Triangle& s, const Triangle& t) {
      return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
    });
    build(first, half);
    node.right = build(first + half, count - half);
    node.count = 0;
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

bool SurfaceTree::meets(const Vec3& origin, const Vec3& direction, int except, double reach) const {
  if (nodes_.empty()) return false;
  const Vec3 inverse = direction.cwiseInverse();
  std::vector<int> open{0};
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    const Vec3 t1 = (node.low - origin).cwiseProduct(inverse);
    const Vec3 t2 = (node.high - origin).cwiseProduct(inverse);
    if (!(t1.cwiseMin(t2).maxCoeff() <= std::min(reach, t1.cwiseMax(t2).minCoeff()))) continue;
    if (t1.cwiseMax(t2).minCoeff() < 0) continue;
    if (node.count == 0) {
      open.push_back(node.right);
      open.push_back(index + 1);
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = triangles_[static_cast<std::size_t>(i)];
      if (t.face != except && crosses(origin, direction, t.a, t.b, t.c, reach)) return true;
    }
  }
  return false;
}

double SurfaceTree::distance(const Vec3& point) const { return (nearest(point) - point).norm(); }

Vec3 SurfaceTree::nearest(const Vec3& point) const {
  double least = 1e300;
  Vec3 nearest = Vec3::Constant(1e150);
  std::vector<int> open{0};
  while (!open.empty() && !nodes_.empty()) {
    const int index = open.back();
    open.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (squaredDistanceToBox(point, node.low, node.high) >= least) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = triangles_[static_cast<std::size_t>(i)];
      const Vec3 q = nearestOn(point, t.a, t.b, t.c);
      if ((q - point).squaredNorm() >= least) continue;
      least = (q - point).squaredNorm();
      nearest = q;
    }
    if (node.count > 0) continue;
    int nearer = index + 1, farther = node.right;
    const auto far = [&](int child) {
      const Node& n = nodes_[static_cast<std::size_t>(child)];
      return squaredDistanceToBox(point, n.low, n.high);
    };
    if (far(nearer) > far(farther)) std::swap(nearer, farther);
    open.push_back(farther);
    open.push_back(nearer);
  }
  return nearest;
}

std::vector<int> SurfaceTree::near(const Vec3& low, const Vec3& high) const {
  const auto apart = [&](const Vec3& l, const Vec3& h) {
    return (l - high).maxCoeff() > 0 || (low - h).maxCoeff() > 0;
  };
  std::vector<int> found, open{0};
  while (!open.empty() && !nodes_.empty()) {
    const int index = open.back();
    open.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (apart(node.low, node.high)) continue;
    if (node.count == 0) {
      open.push_back(node.right);
      open.push_back(index + 1);
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = triangles_[static_cast<std::size_t>(i)];
      if (!apart(t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)))
        found.push_back(t.face);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool holdsMirrorImages(const SurfaceTree& tree, const std::vector<Vec3>& places, double tolerance) {
  const std::size_t step = std::max<std::size_t>(1, places.size() / kPlaces);
  std::size_t seen = 0, off = 0;
  for (std::size_t i = 0; i < places.size(); i += step) {
    ++seen;
    if (tree.distance({places[i].x(), -places[i].y(), places[i].z()}) > tolerance) ++off;
  }
  return static_cast<double>(off) <= kMayBeOff * static_cast<double>(seen);
}

}  // namespace cutwater
