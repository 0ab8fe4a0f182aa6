#pragma once
#include "hydro/geometry/SurfaceMesh.h"
#include "hydro/geometry/outer/SpaceGrid.h"

namespace cutwater {

/// Where a face crosses an edge of a grid.
struct GridCrossing {
  std::uint32_t node;  ///< lower end of the edge
  int face;            ///< of the mesh
  double at;           ///< coordinate along the edge's axis [m]
};

/// All crossings of a surface of triangles with the lines of a grid.
class GridCrossings {
 public:
  /// @param triangles  of any winding, open or doubled; must outlive this object.
  /// @param openTolerance  [m] edges of the grid that pass a loose edge of the surface this near
  ///   are blocked too, so that slits below twice of it hold water back.
  /// O(triangles + crossings · log).
  GridCrossings(const SurfaceMesh& triangles, const SpaceGrid& grid, double openTolerance);

  /// Crossings of one axis, by node, then by place.
  const std::vector<GridCrossing>& along(int axis) const {
    return along_[static_cast<std::size_t>(axis)];
  }
  /// Those of one edge, rising: [first, last).
  std::pair<const GridCrossing*, const GridCrossing*> on(std::size_t node, int axis) const;
  /// Whether water can flow along the edge.
  bool blocked(std::size_t node, int axis) const { return (blocked_[node] >> axis & 1) != 0; }

 private:
  void rasterize(const SurfaceMesh& triangles, const SpaceGrid& grid, int axis);
  void blockLooseEdges(const SurfaceMesh& triangles, const SpaceGrid& grid, double tolerance);
  void blockNear(const Vec3& p, const Vec3& q, const SpaceGrid& grid, double tolerance);
  std::array<std::vector<GridCrossing>, 3> along_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace cutwater
