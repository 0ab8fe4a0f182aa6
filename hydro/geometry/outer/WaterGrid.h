#pragma once
#include "hydro/geometry/outer/GridCrossings.h"

namespace cutwater {

/// Where the outer surface crosses an edge of a grid: from a node that the water reaches to one
/// that it does not.
struct SurfaceCrossing {
  std::uint32_t node;  ///< lower end of the edge
  int face;            ///< the first one met from the water; −1: held back by a loose edge only
  double at;           ///< coordinate along the edge's axis [m]
};

/// Which nodes of a grid the water reaches, and the outer surface between them and the others.
///     const WaterGrid water(grid, GridCrossings(triangles, grid, tolerance), false);
///
/// The water comes from the sides and the bottom of the grid, along edges that no face crosses. It
/// never falls: above calm water it moves sideways and up only. So a hull that is open above water
/// is a bowl, filled to where its rim is lowest; inner skins, nested solids, doubled faces and the
/// sense of faces make no difference; a plate with water on both sides is no part of the surface.
class WaterGrid {
 public:
  /// @param halfAtY  the grid's first plane of y is the centreplane, through which no water comes.
  WaterGrid(SpaceGrid grid, const GridCrossings& crossings, bool halfAtY);

  /// Every `step`-th plane of the part up to plane `top` of z. Water reaches the nodes that it
  /// reaches here; a crossing between two of them is the one first met from the water.
  WaterGrid coarser(int step, int top) const;

  const SpaceGrid& grid() const { return grid_; }
  bool wet(std::size_t node) const { return wet_[node] != 0; }
  bool halfAtY() const { return halfAtY_; }
  /// Crossings of the edges of one axis, by node.
  const std::vector<SurfaceCrossing>& along(int axis) const {
    return along_[static_cast<std::size_t>(axis)];
  }
  /// The crossing on an edge, or null.
  const SurfaceCrossing* on(std::size_t node, int axis) const;

 private:
  WaterGrid(SpaceGrid grid, bool halfAtY) : grid_(std::move(grid)), halfAtY_(halfAtY) {}
  void flood(const GridCrossings& crossings);
  void findSurface(const GridCrossings& crossings, int axis);
  void sampleCrossings(const WaterGrid& fine, int step, int axis);
  SpaceGrid grid_;
  bool halfAtY_;
  std::vector<std::uint8_t> wet_;
  std::array<std::vector<SurfaceCrossing>, 3> along_;
};

}  // namespace cutwater
