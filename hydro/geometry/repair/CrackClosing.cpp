#include "hydro/geometry/repair/CrackClosing.h"

#include <algorithm>
#include <map>

#include "hydro/geometry/MeshEdges.h"

namespace cutwater {
namespace {

constexpr int kPasses = 12;  // a face may be divided on one edge after the other

/// Vertices of open edges in the order of their x.
class LooseVertices {
 public:
  LooseVertices(const SurfaceMesh& mesh, const std::vector<OpenEdge>& edges) : mesh_(mesh) {
    for (const OpenEdge& e : edges) {
      order_.push_back(e.from);
      order_.push_back(e.to);
    }
    const auto byPlace = [&](int a, int b) { return std::pair(x(a), a) < std::pair(x(b), b); };
    std::sort(order_.begin(), order_.end(), byPlace);
    order_.erase(std::unique(order_.begin(), order_.end()), order_.end());
  }

  /// Those strictly inside an edge, from its start to its end.
  std::vector<int> within(const OpenEdge& e, double tolerance) const {
    const Vec3 a = at(e.from), ab = at(e.to) - a;
    const double length = ab.norm();
    const double low = std::min(x(e.from), x(e.to)) - tolerance,
                 high = std::max(x(e.from), x(e.to)) + tolerance;
    auto it = std::lower_bound(order_.begin(), order_.end(), low,
                               [&](int v, double value) { return x(v) < value; });
    std::vector<std::pair<double, int>> found;
    for (; it != order_.end() && x(*it) <= high; ++it) {
      const double t = (at(*it) - a).dot(ab) / length;
      if (*it != e.from && *it != e.to && t > tolerance && t < length - tolerance &&
          (at(*it) - a - t / length * ab).norm() < tolerance)
        found.emplace_back(t, *it);
    }
    std::sort(found.begin(), found.end());
    std::vector<int> vertices;
    for (const auto& [t, v] : found) vertices.push_back(v);
    return vertices;
  }

 private:
  const Vec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
  double x(int v) const { return at(v).x(); }
  const SurfaceMesh& mesh_;
  std::vector<int> order_;
};

/// The triangle as a fan from the corner across the edge.
void addDivided(const Face& f, const OpenEdge& e, const std::vector<int>& on, SurfaceMesh& mesh) {
  int tip = f[0];
  for (int i = 1; i < 3; ++i)
    if (f[i] != e.from && f[i] != e.to) tip = f[i];
  int from = e.from;
  for (const int to : on) {
    mesh.faces.push_back({{from, to, tip, -1}});
    from = to;
  }
  mesh.faces.push_back({{from, e.to, tip, -1}});
}

/// Two faces on the same corners the other way round enclose nothing: both go. Of two alike one
/// stays.
SurfaceMesh withoutFolds(const SurfaceMesh& mesh) {
  std::map<std::array<int, 3>, std::vector<std::size_t>> faces;
  for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
    std::array<int, 3> v{mesh.faces[k][0], mesh.faces[k][1], mesh.faces[k][2]};
    std::sort(v.begin(), v.end());
    faces[v].push_back(k);
  }
  const auto isEven = [&](std::size_t k) {
    const Face& f = mesh.faces[k];
    return (f[0] < f[1]) == ((f[1] < f[2]) == (f[0] < f[2]));
  };
  std::vector<bool> kept(mesh.faces.size(), true);
  for (const auto& entry : faces) {
    const std::vector<std::size_t>& same = entry.second;
    for (std::size_t i = 1; i < same.size(); ++i) kept[same[i]] = false;
    if (std::any_of(same.begin(), same.end(),
                    [&](std::size_t k) { return isEven(k) != isEven(same[0]); }))
      kept[same[0]] = false;
  }
  SurfaceMesh out{mesh.vertices, {}};
  for (std::size_t k = 0; k < mesh.faces.size(); ++k)
    if (kept[k]) out.faces.push_back(mesh.faces[k]);
  return out;
}

/// Faces, and whether all their edges are examined.
class CrackCloser {
 public:
  CrackCloser(const SurfaceMesh& mesh, double tolerance, std::size_t firstLoose)
      : mesh_(mesh), tolerance_(tolerance) {
    for (std::size_t k = 0; k < mesh.faces.size(); ++k) loose_.push_back(k >= firstLoose);
  }

  SurfaceMesh close() {
    for (int pass = 0; pass < kPasses; ++pass) {
      leaveOutThin();
      if (!divide()) break;
    }
    return withoutFolds(mesh_);
  }

 private:
  void leaveOutThin() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < mesh_.faces.size(); ++k) {
      const Face& f = mesh_.faces[k];
      double longest = 0.0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, (mesh_.corner(f, i) - mesh_.corner(f, (i + 1) % 3)).norm());
      if (loose_[k] && 2 * vectorArea(mesh_, f).norm() < tolerance_ * longest) continue;
      loose_[kept] = loose_[k];
      mesh_.faces[kept++] = f;
    }
    mesh_.faces.resize(kept);
    loose_.resize(kept);
  }

  std::vector<OpenEdge> edges() const {
    std::vector<OpenEdge> edges = looseEdges(mesh_);
    for (std::size_t k = 0; k < mesh_.faces.size(); ++k)
      for (int i = 0; loose_[k] && i < 3; ++i)
        edges.push_back({mesh_.faces[k][i], mesh_.faces[k][(i + 1) % 3], static_cast<int>(k)});
    return edges;
  }

  /// Each face on one of its edges; false if there is none to divide.
  bool divide() {
    const std::vector<OpenEdge> candidates = edges();
    const LooseVertices vertices(mesh_, candidates);
    std::vector<bool> taken(mesh_.faces.size(), false);
    SurfaceMesh parts;
    for (const OpenEdge& e : candidates) {
      if (taken[static_cast<std::size_t>(e.face)]) continue;
      const Face& f = mesh_.faces[static_cast<std::size_t>(e.face)];
      std::vector<int> on = vertices.within(e, tolerance_);
      std::erase_if(on, [&](int v) { return v == f[0] || v == f[1] || v == f[2]; });
      if (on.empty()) continue;
      taken[static_cast<std::size_t>(e.face)] = true;
      addDivided(f, e, on, parts);
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < mesh_.faces.size(); ++k) {
      if (taken[k]) continue;
      loose_[kept] = loose_[k];
      mesh_.faces[kept++] = mesh_.faces[k];
    }
    mesh_.faces.resize(kept);
    loose_.resize(kept);
    mesh_.faces.insert(mesh_.faces.end(), parts.faces.begin(), parts.faces.end());
    loose_.resize(mesh_.faces.size(), true);
    return !parts.faces.empty();
  }

  SurfaceMesh mesh_;
  double tolerance_;
  std::vector<bool> loose_;
};

}  // namespace

SurfaceMesh withoutCracks(const SurfaceMesh& mesh, double tolerance, std::size_t firstLoose) {
  return CrackCloser(triangulated(mesh), tolerance, firstLoose).close();
}

}  // namespace cutwater
