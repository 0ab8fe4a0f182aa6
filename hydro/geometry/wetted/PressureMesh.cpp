#include "hydro/geometry/wetted/PressureMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <string>
#include <unordered_map>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

std::size_t place(int index) { return static_cast<std::size_t>(index); }

Face triangle(int a, int b, int c) { return {{a, b, c, -1}}; }

std::uint64_t edgeKey(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
         static_cast<std::uint64_t>(std::max(a, b));
}

void addTriangle(std::vector<Face>& faces, int a, int b, int c) {
  if (a != b && b != c && c != a) faces.push_back(triangle(a, b, c));
}

/// Divides triangles at one station after another.
class StationSplitter {
 public:
  explicit StationSplitter(SurfaceMesh triangles)
      : mesh_(std::move(triangles)), tolerance_(1e-9 * bounds(mesh_).diagonal()) {}

  void split(double station) {
    crossing_.clear();
    side_.clear();
    for (const Vec3& p : mesh_.vertices) side_.push_back(sideOf(p.x() - station));
    std::vector<Face> divided;
    for (const Face& f : mesh_.faces) divide(f, station, divided);
    mesh_.faces = std::move(divided);
  }

  SurfaceMesh result() && { return std::move(mesh_); }

 private:
  int sideOf(double ahead) const { return (ahead > tolerance_) - (ahead < -tolerance_); }

  /// The triangle, or its parts on both sides: the corner that is alone on its side, or that lies
  /// on the plane between the others, comes first.
  void divide(const Face& f, double station, std::vector<Face>& out) {
    for (int i = 0; i < 3; ++i) {
      const int a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3];
      const int toB = side_[place(a)] * side_[place(b)], toC = side_[place(a)] * side_[place(c)];
      const bool between = side_[place(a)] == 0 && side_[place(b)] * side_[place(c)] < 0;
      if (between) {
        const int m = crossing(b, c, station);
        out.push_back(triangle(a, b, m));
        out.push_back(triangle(a, m, c));
        return;
      }
      if (toB < 0 && toC < 0) return cutOff(a, b, c, station, out);
    }
    out.push_back(f);
  }

  /// Corner a is alone; what is left is divided by the shorter diagonal.
  void cutOff(int a, int b, int c, double station, std::vector<Face>& out) {
    const int ab = crossing(a, b, station), ac = crossing(a, c, station);
    out.push_back(triangle(a, ab, ac));
    const auto distance2 = [&](int i, int k) {
      return (mesh_.vertices[place(i)] - mesh_.vertices[place(k)]).squaredNorm();
    };
    if (distance2(ab, c) < distance2(b, ac)) {
      out.push_back(triangle(ab, b, c));
      out.push_back(triangle(ab, c, ac));
    } else {
      out.push_back(triangle(ab, b, ac));
      out.push_back(triangle(b, c, ac));
    }
  }

  /// The vertex where an edge meets the plane, one for all faces that share it.
  int crossing(int a, int b, double station) {
    if (a > b) std::swap(a, b);
    const auto [it, isNew] =
        crossing_.emplace(edgeKey(a, b), static_cast<int>(mesh_.vertices.size()));
    if (isNew) {
      const Vec3 p = mesh_.vertices[place(a)], q = mesh_.vertices[place(b)];
      Vec3 between = p + (station - p.x()) / (q.x() - p.x()) * (q - p);
      between.x() = station;
      mesh_.vertices.push_back(between);
      side_.push_back(0);
    }
    return it->second;
  }

  SurfaceMesh mesh_;
  double tolerance_;
  std::vector<int> side_;  ///< of the station: 1 ahead, −1 behind, 0 on it, per vertex
  std::unordered_map<std::uint64_t, int> crossing_;
};

/// Halves edges, the longest first.
class EdgeHalver {
 public:
  explicit EdgeHalver(SurfaceMesh triangles) : mesh_(std::move(triangles)) {
    for (std::size_t k = 0; k < mesh_.faces.size(); ++k)
      for (int i = 0; i < 3; ++i) add(mesh_.faces[k][i], mesh_.faces[k][(i + 1) % 3], k);
  }

  RefinedMesh refine(double longest, std::size_t most) && {
    double reached = 0.0;
    while (!longest_.empty()) {
      const Edge edge = longest_.top();
      const auto sides = facesOf_.find(edge.key);
      if (edge.length2 <= longest * longest || mesh_.faces.size() + sides->second.size() > most) {
        reached = std::sqrt(edge.length2);
        break;
      }
      longest_.pop();
      const std::vector<std::size_t> faces = std::move(sides->second);
      facesOf_.erase(sides);
      halve(edge.key, faces);
    }
    return {std::move(mesh_), reached};
  }

 private:
  struct Edge {
    double length2;
    std::uint64_t key;
    bool operator<(const Edge& other) const {
      return std::pair(length2, key) < std::pair(other.length2, other.key);
    }
  };

  void add(int a, int b, std::size_t face) {
    std::vector<std::size_t>& faces = facesOf_[edgeKey(a, b)];
    if (faces.empty())
      longest_.push(
          {(mesh_.vertices[place(a)] - mesh_.vertices[place(b)]).squaredNorm(), edgeKey(a, b)});
    faces.push_back(face);
  }

  void halve(std::uint64_t key, const std::vector<std::size_t>& faces) {
    const int low = static_cast<int>(key >> 32), high = static_cast<int>(key & 0xffffffffu),
              middle = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(0.5 * (mesh_.vertices[place(low)] + mesh_.vertices[place(high)]));
    for (const std::size_t face : faces) {
      const Face f = mesh_.faces[face];
      int i = 0;
      while (f[i] == low || f[i] == high) ++i;
      const int apex = f[i], from = f[(i + 1) % 3], to = f[(i + 2) % 3];
      const std::size_t other = mesh_.faces.size();
      mesh_.faces[face] = triangle(apex, from, middle);
      mesh_.faces.push_back(triangle(apex, middle, to));
      std::vector<std::size_t>& moved = facesOf_[edgeKey(to, apex)];
      std::replace(moved.begin(), moved.end(), face, other);
      add(from, middle, face);
      add(middle, to, other);
      add(middle, apex, face);
      add(middle, apex, other);
    }
  }

  SurfaceMesh mesh_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> facesOf_;
  std::priority_queue<Edge> longest_;
};

}  // namespace

SurfaceMesh evenTriangles(const SurfaceMesh& mesh) {
  SurfaceMesh out{mesh.vertices, {}};
  double excess = 0.0;  // six times the volume above that of the mean
  for (const Face& f : mesh.faces) {
    if (f.size() == 3) {
      addTriangle(out.faces, f[0], f[1], f[2]);
      continue;
    }
    const Vec3& a = mesh.corner(f, 0);
    // With the diagonal from corner 0 the face encloses this much more than the mean.
    const double more =
        -0.5 * (mesh.corner(f, 1) - a).cross(mesh.corner(f, 2) - a).dot(mesh.corner(f, 3) - a);
    const int first = std::abs(excess + more) <= std::abs(excess - more) ? 0 : 1;
    excess += first == 0 ? more : -more;
    addTriangle(out.faces, f[first], f[first + 1], f[first + 2]);
    addTriangle(out.faces, f[first], f[first + 2], f[(first + 3) % 4]);
  }
  return out;
}

SurfaceMesh splitAt(const SurfaceMesh& mesh, std::span<const double> stations) {
  StationSplitter splitter(evenTriangles(mesh));
  for (const double station : stations) {
    if (!std::isfinite(station))
      throw HydroError(Fault::ValueOutOfRange,
                       "splitAt: a station at x = " + std::to_string(station) + " m");
    splitter.split(station);
  }
  return std::move(splitter).result();
}

RefinedMesh refined(const SurfaceMesh& mesh, double longest, std::size_t most) {
  if (!(longest > 0.0))
    throw HydroError(Fault::ValueOutOfRange,
                     "refined: edges of " + std::to_string(longest) + " m; give a length above 0");
  return EdgeHalver(evenTriangles(mesh)).refine(longest, most);
}

double linearPressureError(double edge, double waveNumber) {
  return edge * waveNumber * edge * waveNumber / 12.0;
}

double edgeFor(double error, double waveNumber) {
  if (!(error > 0.0) || !(waveNumber > 0.0))
    throw HydroError(Fault::ValueOutOfRange,
                     "edgeFor: an error of " + std::to_string(error) + " in a wave of number " +
                         std::to_string(waveNumber) + " 1/m; give numbers above 0");
  return std::sqrt(12.0 * error) / waveNumber;
}

}  // namespace cutwater
