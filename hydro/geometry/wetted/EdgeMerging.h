#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Merges the ends of edges of a triangle mesh, the cheapest first: what ThinnedHull.h says, for a
/// mesh that is divided along calm water.
class EdgeMerging {
 public:
  /// @param triangles  no triangle on both sides of z = 0.
  /// @param half  a port half, open on y = 0: vertices there stay there, and merge only along it.
  EdgeMerging(SurfaceMesh triangles, bool half);
  /// Until there are at most so many triangles, or nothing more can go.
  void mergeTo(std::size_t most);
  SurfaceMesh result() const;

 private:
  // Planes that a vertex must not leave.
  static constexpr std::uint8_t kCentreplane = 1, kWater = 2, kStays = 4;
  struct Merger {
    double cost;
    Vec3 to;
  };
  struct Candidate {
    double cost;
    int a, b, age;  // a < b
    bool operator<(const Candidate& other) const {
      return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);  // the cheapest on top
    }
  };
  struct Misfit;

  const Vec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
  const Face& face(int k) const { return mesh_.faces[static_cast<std::size_t>(k)]; }
  std::uint8_t held(int v) const { return held_[static_cast<std::size_t>(v)]; }
  const std::vector<int>& facesAt(int v) const { return facesAt_[static_cast<std::size_t>(v)]; }
  int age(int a, int b) const;
  double side(const Face& f) const;
  bool below(const Face& f) const { return side(f) < 0.0; }
  std::vector<int> neighbours(int v) const;

  void holdVertices();
  void consider(int a, int b);
  void considerAll();
  void mergeCheapest();
  void merge(int a, int b, const Vec3& to);
  std::optional<Merger> merger(int a, int b) const;
  bool keepsTopology(int a, int b) const;
  bool liesAlongPlane(int a, int b) const;
  void addWaterline(const Face& f, int a, int b, Misfit& misfit) const;
  bool keepsSides(int a, const Vec3& from, const Vec3& to) const;
  bool keepsNormals(int a, int b, const Vec3& to) const;
  /// Calls visit(face) for each triangle at a or b.
  template <class Visit>
  void around(int a, int b, const Visit& visit) const;

  SurfaceMesh mesh_;
  bool half_;
  double size_;  // [m]
  std::size_t count_;
  std::vector<std::uint8_t> held_;
  std::vector<int> age_;  // how often a vertex has moved
  std::vector<std::vector<int>> facesAt_;
  std::priority_queue<Candidate> candidates_;
};

}  // namespace cutwater
