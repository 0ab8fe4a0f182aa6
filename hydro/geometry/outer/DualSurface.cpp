#include "hydro/geometry/outer/DualSurface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <unordered_map>

namespace cutwater {
namespace {

// Directions with less than this share of the greatest eigenvalue are held by no plane: two faces
// that meet at 16° or less are one round surface.
constexpr double kLeastEigenvalue = 0.02;
constexpr double kBeyondCell = 0.05;  // of a cell's width that a vertex may leave it

// Edge e of a cell: axis e / 4, at the low or high side of the next axis (bit 0) and of the one
// after that (bit 1).
constexpr int kEdges = 12;
using CellVertices = std::array<int, kEdges>;

int edgeOf(int axis, int next, int afterNext) { return 4 * axis + next + 2 * afterNext; }

/// Which of a cell's twelve edges belong to one piece of surface.
class Pieces {
 public:
  Pieces() {
    for (int e = 0; e < kEdges; ++e) of_[index(e)] = e;
  }
  int root(int e) const {
    while (of_[index(e)] != e) e = of_[index(e)];
    return e;
  }
  void join(int a, int b) { of_[index(root(a))] = root(b); }

 private:
  static std::size_t index(int e) { return static_cast<std::size_t>(e); }
  std::array<int, kEdges> of_{};
};

class Dual {
 public:
  Dual(const WaterGrid& water, const std::vector<Vec3>& normals, bool endsAtWater)
      : water_(water), grid_(water.grid()), normals_(normals), endsAtWater_(endsAtWater) {}

  DualSurface surface() {
    std::size_t crossings = 0;
    for (int axis = 0; axis < 3; ++axis) crossings += water_.along(axis).size();
    cells_.reserve(crossings);
    for (int axis = 0; axis < 3; ++axis)
      for (const SurfaceCrossing& c : water_.along(axis)) addFace(c, axis);
    return std::move(out_);
  }

 private:
  /// The quadrilateral of the four cells around an edge; none on the grid's boundary.
  void addFace(const SurfaceCrossing& c, int axis) {
    const auto a = static_cast<std::size_t>((axis + 1) % 3),
               b = static_cast<std::size_t>((axis + 2) % 3);
    const SpaceGrid::Index at = grid_.index(c.node);
    if (at[a] == 0 || at[b] == 0 || at[a] + 1 >= grid_.count(static_cast<int>(a)) ||
        at[b] + 1 >= grid_.count(static_cast<int>(b)))
      return;
    constexpr int kAround[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    Face face;
    for (std::size_t i = 0; i < 4; ++i) {
      SpaceGrid::Index cell = at;
      cell[a] -= kAround[i][0];
      cell[b] -= kAround[i][1];
      face.v[i] =
          verticesOf(cell)[static_cast<std::size_t>(edgeOf(axis, kAround[i][0], kAround[i][1]))];
    }
    if (water_.wet(c.node)) std::reverse(face.v.begin(), face.v.end());
    out_.mesh.faces.push_back(face);
  }

  const CellVertices& verticesOf(const SpaceGrid::Index& cell) {
    const auto [found, isNew] = cells_.try_emplace(static_cast<std::uint32_t>(grid_.node(cell)));
    if (isNew) found->second = made(cell);
    return found->second;
  }

  CellVertices made(const SpaceGrid::Index& cell) {
    std::array<const SurfaceCrossing*, kEdges> crossing{};
    for (int e = 0; e < kEdges; ++e)
      crossing[static_cast<std::size_t>(e)] = water_.on(grid_.node(lowerEnd(cell, e)), e / 4);
    const Pieces pieces = piecesOf(cell, crossing);
    CellVertices vertices;
    vertices.fill(-1);
    for (int root = 0; root < kEdges; ++root) {
      if (crossing[static_cast<std::size_t>(root)] == nullptr || pieces.root(root) != root)
        continue;
      std::vector<int> edges;
      for (int e = 0; e < kEdges; ++e)
        if (crossing[static_cast<std::size_t>(e)] != nullptr && pieces.root(e) == root)
          edges.push_back(e);
      for (const int e : edges)
        vertices[static_cast<std::size_t>(e)] = static_cast<int>(out_.mesh.vertices.size());
      addVertex(cell, crossing, edges);
    }
    return vertices;
  }

  SpaceGrid::Index lowerEnd(const SpaceGrid::Index& cell, int e) const {
    SpaceGrid::Index at = cell;
    at[static_cast<std::size_t>((e / 4 + 1) % 3)] += e & 1;
    at[static_cast<std::size_t>((e / 4 + 2) % 3)] += e >> 1 & 1;
    return at;
  }

  /// Two crossings on a side of the cell are of one piece. Where all four edges of a side are
  /// crossed, what is solid stays apart.
  Pieces piecesOf(const SpaceGrid::Index& cell,
                  const std::array<const SurfaceCrossing*, kEdges>& crossing) const {
    Pieces pieces;
    for (int d = 0; d < 3; ++d) {
      for (int side = 0; side < 2; ++side) {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        const std::array<int, 4> edges{edgeOf(a, 0, side), edgeOf(a, 1, side), edgeOf(b, side, 0),
                                       edgeOf(b, side, 1)};
        std::vector<int> crossed;
        for (const int e : edges)
          if (crossing[static_cast<std::size_t>(e)] != nullptr) crossed.push_back(e);
        if (crossed.size() == 2) pieces.join(crossed[0], crossed[1]);
        if (crossed.size() != 4) continue;
        SpaceGrid::Index corner = cell;
        corner[static_cast<std::size_t>(d)] += side;
        const bool solid = !water_.wet(grid_.node(corner));
        pieces.join(edges[0], edges[solid ? 2 : 3]);
        pieces.join(edges[1], edges[solid ? 3 : 2]);
      }
    }
    return pieces;
  }

  void addVertex(const SpaceGrid::Index& cell,
                 const std::array<const SurfaceCrossing*, kEdges>& crossing,
                 std::vector<int> edges) {
    VertexHold hold;
    hold.onCentreplane = water_.halfAtY() && cell[1] == 0;
    hold.onWater = endsAtWater_ && cell[2] == grid_.count(2) - 2;
    if (hold.onWater) keepThoseOnTop(edges);
    Vec3 mean = Vec3::Zero();
    for (const int e : edges) mean += place(cell, e, *crossing[static_cast<std::size_t>(e)]);
    mean /= static_cast<double>(edges.size());
    const Vec3 free(1.0, hold.onCentreplane ? 0.0 : 1.0, hold.onWater ? 0.0 : 1.0);
    mean = mean.cwiseProduct(free);
    Mat3 squares = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    for (const int e : edges) {
      const SurfaceCrossing& c = *crossing[static_cast<std::size_t>(e)];
      if (c.face < 0) continue;
      const Vec3& n = normals_[static_cast<std::size_t>(c.face)];
      const Vec3 inPlane = n.cwiseProduct(free);
      squares += inPlane * inPlane.transpose();
      right += inPlane * n.dot(place(cell, e, c) - mean);
    }
    out_.mesh.vertices.push_back(within(cell, mean + nearest(squares, right, hold), free));
    out_.hold.push_back(hold);
  }

  /// On calm water the crossings in the plane itself decide, if there are any.
  static void keepThoseOnTop(std::vector<int>& edges) {
    std::vector<int> top;
    for (const int e : edges)
      if ((e / 4 == 0 && (e >> 1 & 1) == 1) || (e / 4 == 1 && (e & 1) == 1)) top.push_back(e);
    if (!top.empty()) edges = std::move(top);
  }

  Vec3 place(const SpaceGrid::Index& cell, int e, const SurfaceCrossing& c) const {
    Vec3 p = grid_.place(lowerEnd(cell, e));
    p[e / 4] = c.at;
    return p;
  }

  /// Of the points nearest to all planes the one nearest to the mean.
  static Vec3 nearest(const Mat3& squares, const Vec3& right, VertexHold& hold) {
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(squares);
    const double least = std::max(kLeastEigenvalue * eigen.eigenvalues()[2], 1e-9);
    Vec3 move = Vec3::Zero();
    hold.planes = 0;
    for (int i = 0; i < 3; ++i) {
      if (eigen.eigenvalues()[i] <= least) continue;
      const Vec3 direction = eigen.eigenvectors().col(i);
      move += direction * (direction.dot(right) / eigen.eigenvalues()[i]);
      ++hold.planes;
    }
    if (hold.planes == 2) hold.along = eigen.eigenvectors().col(0);
    return move;
  }

  Vec3 within(const SpaceGrid::Index& cell, Vec3 p, const Vec3& free) const {
    for (int d = 0; d < 3; ++d) {
      const int i = cell[static_cast<std::size_t>(d)];
      const double low = grid_.plane(d, i), high = grid_.plane(d, i + 1),
                   beyond = kBeyondCell * (high - low);
      if (free[d] > 0) p[d] = std::clamp(p[d], low - beyond, high + beyond);
    }
    return p;
  }

  const WaterGrid& water_;
  const SpaceGrid& grid_;
  const std::vector<Vec3>& normals_;
  bool endsAtWater_;
  std::unordered_map<std::uint32_t, CellVertices> cells_;
  DualSurface out_;
};

}  // namespace

DualSurface dualSurface(const WaterGrid& water, const std::vector<Vec3>& normals,
                        bool endsAtWater) {
  return Dual(water, normals, endsAtWater).surface();
}

}  // namespace cutwater
