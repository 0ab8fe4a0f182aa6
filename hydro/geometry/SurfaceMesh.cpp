#include "hydro/geometry/SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& c) const noexcept {
    std::uint64_t h = 1469598103934665603ull;
    for (std::int64_t i : c) h = (h ^ static_cast<std::uint64_t>(i)) * 1099511628211ull;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }
};

/// Vertices already kept, sorted into cubes a little larger than the tolerance, so that everything
/// within it lies in the 27 cubes around a point.
class VertexGrid {
 public:
  VertexGrid(double tolerance, double extent)
      : tolerance2_(tolerance * tolerance), cell_(std::max(tolerance, 1e-12 * extent) * 1.0001) {
    if (cell_ <= 0) cell_ = 1.0;
  }

  /// Index of the vertex within the tolerance of p, or −1.
  int find(const Vec3& p, const std::vector<Vec3>& kept) const {
    const Cell c = cellOf(p);
    int best = -1;
    const std::int64_t reach = tolerance2_ > 0 ? 1 : 0;  // equal points share a cube
    for (std::int64_t i = -reach; i <= reach; ++i)
      for (std::int64_t j = -reach; j <= reach; ++j)
        for (std::int64_t k = -reach; k <= reach; ++k) {
          const auto range = map_.equal_range({c[0] + i, c[1] + j, c[2] + k});
          for (auto it = range.first; it != range.second; ++it) {
            const Vec3& q = kept[static_cast<std::size_t>(it->second)];
            if ((q - p).squaredNorm() <= tolerance2_ && (best < 0 || it->second < best))
              best = it->second;
          }
        }
    return best;
  }

  void add(const Vec3& p, int index) { map_.emplace(cellOf(p), index); }

 private:
  Cell cellOf(const Vec3& p) const {
    Cell c{};
    for (int i = 0; i < 3; ++i)
      c[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / cell_));
    return c;
  }
  double tolerance2_, cell_;
  std::unordered_multimap<Cell, int, CellHash> map_;
};

/// The face without repeated corners; size 0 if fewer than three different ones are left or
/// opposite corners of a quad have met.
std::vector<int> withoutRepeats(const std::vector<int>& corners) {
  std::vector<int> out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] != corners[(i + 1) % corners.size()]) out.push_back(corners[i]);
  std::vector<int> sorted = out;
  std::sort(sorted.begin(), sorted.end());
  if (out.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    out.clear();
  return out;
}

void checkFaces(const SurfaceMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int i = 0; i < mesh.faces[f].size(); ++i)
      if (const int v = mesh.faces[f][i]; v < 0 || v >= n)
        throw HydroError(Fault::MeshIndexOutOfRange, "welded: face " + std::to_string(f) +
                                                         " names vertex " + std::to_string(v) +
                                                         " of " + std::to_string(n));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!mesh.vertices[v].allFinite())
      throw HydroError(Fault::MeshNotFinite, "welded: vertex " + std::to_string(v) +
                                                 " has a coordinate that is not finite");
}

}  // namespace

Vec3 vectorArea(const SurfaceMesh& mesh, const Face& face) {
  const auto p = [&](int i) { return mesh.corner(face, i); };
  if (face.size() == 3) return 0.5 * (p(1) - p(0)).cross(p(2) - p(0));
  return 0.5 * (p(2) - p(0)).cross(p(3) - p(1));
}

Vec3 meanCorner(const SurfaceMesh& mesh, const Face& face) {
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < face.size(); ++i) mean += mesh.corner(face, i) / face.size();
  return mean;
}

SurfaceMesh mirroredInY(const SurfaceMesh& mesh) {
  SurfaceMesh out = turnedOver(mesh);
  for (Vec3& p : out.vertices) p.y() = p.y() == 0.0 ? 0.0 : -p.y();
  return out;
}

SurfaceMesh turnedOver(const SurfaceMesh& mesh) {
  SurfaceMesh out = mesh;
  for (Face& f : out.faces) std::reverse(f.v.begin(), f.v.begin() + f.size());
  return out;
}

SurfaceMesh joined(const SurfaceMesh& a, const SurfaceMesh& b) {
  SurfaceMesh out = a;
  const int offset = static_cast<int>(a.vertices.size());
  out.vertices.insert(out.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (Face f : b.faces) {
    for (int i = 0; i < f.size(); ++i) f.v[static_cast<std::size_t>(i)] += offset;
    out.faces.push_back(f);
  }
  return out;
}

SurfaceMesh bothHalves(const SurfaceMesh& port) {
  return welded(joined(port, mirroredInY(port)), 1e-9 * bounds(port).diagonal());
}

SurfaceMesh welded(const SurfaceMesh& mesh, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw HydroError(Fault::BadArgument, "welded: tolerance " + std::to_string(tolerance));
  checkFaces(mesh);
  SurfaceMesh out;
  VertexGrid grid(tolerance, bounds(mesh).diagonal());
  std::vector<int> newIndex(mesh.vertices.size(), -1);
  const auto keep = [&](int old) {
    int& index = newIndex[static_cast<std::size_t>(old)];
    if (index >= 0) return index;
    const Vec3& p = mesh.vertices[static_cast<std::size_t>(old)];
    index = grid.find(p, out.vertices);
    if (index < 0) {
      index = static_cast<int>(out.vertices.size());
      out.vertices.push_back(p);
      grid.add(p, index);
    }
    return index;
  };
  for (const Face& f : mesh.faces) {
    std::vector<int> corners;
    for (int i = 0; i < f.size(); ++i) corners.push_back(keep(f[i]));
    corners = withoutRepeats(corners);
    if (corners.empty()) continue;
    Face kept;
    std::copy(corners.begin(), corners.end(), kept.v.begin());
    out.faces.push_back(kept);
  }
  return out;
}

Bounds bounds(const SurfaceMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Bounds b{mesh.vertices[0], mesh.vertices[0]};
  for (const Vec3& p : mesh.vertices) {
    b.low = b.low.cwiseMin(p);
    b.high = b.high.cwiseMax(p);
  }
  return b;
}

std::vector<OpenEdge> openEdges(const SurfaceMesh& mesh) {
  const auto key = [](int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) |
           static_cast<std::uint32_t>(b);
  };
  std::unordered_map<std::uint64_t, int> count;
  for (const Face& f : mesh.faces)
    for (int i = 0; i < f.size(); ++i) ++count[key(f[i], f[(i + 1) % f.size()])];
  std::vector<OpenEdge> open;
  for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
    const Face& f = mesh.faces[k];
    for (int i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      const auto back = count.find(key(b, a));
      if (back == count.end() || back->second != count[key(a, b)])
        open.push_back({a, b, static_cast<int>(k)});
    }
  }
  return open;
}

SurfaceMesh triangulated(const SurfaceMesh& mesh) {
  SurfaceMesh result;
  result.vertices = mesh.vertices;
  const auto add = [&result](int a, int b, int c) {
    const Face triangle{{a, b, c, -1}};
    const double size = (result.corner(triangle, 1) - result.corner(triangle, 0)).squaredNorm() +
                        (result.corner(triangle, 2) - result.corner(triangle, 0)).squaredNorm();
    if (vectorArea(result, triangle).norm() > 1e-9 * size) result.faces.push_back(triangle);
  };
  for (const Face& face : mesh.faces) {
    add(face.v[0], face.v[1], face.v[2]);
    if (face.size() == 4) add(face.v[0], face.v[2], face.v[3]);
  }
  return result;
}

}  // namespace cutwater
