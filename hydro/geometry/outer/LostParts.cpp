#include "hydro/geometry/outer/LostParts.h"

#include <array>

namespace cutwater {
namespace {

double cellVolume(const SpaceGrid& grid, const SpaceGrid::Index& at) {
  return grid.width(0, at[0]) * grid.width(1, at[1]) * grid.width(2, at[2]);
}

/// Whether all corners of the coarse cell around a node are wet; its low corner in `low`.
bool allWet(const WaterGrid& fine, int step, SpaceGrid::Index& low) {
  for (std::size_t d = 0; d < 3; ++d) low[d] -= low[d] % step;
  for (int corner = 0; corner < 8; ++corner) {
    SpaceGrid::Index at = low;
    for (int d = 0; d < 3; ++d) {
      int& i = at[static_cast<std::size_t>(d)];
      if ((corner >> d & 1) != 0 && i + step < fine.grid().count(d)) i += step;
    }
    if (!fine.wet(fine.grid().node(at))) return false;
  }
  return true;
}

}  // namespace

LostParts partsBetweenNodes(const WaterGrid& fine, int step, int top) {
  const SpaceGrid& grid = fine.grid();
  LostParts lost;
  double inCell = 0.0, most = 0.0;  // of a run of nodes in one coarse cell
  std::size_t cell = grid.nodes();
  const std::size_t end = grid.stride(2) * static_cast<std::size_t>(top + 1);
  for (std::size_t node = 0; node < end; ++node) {
    if (fine.wet(node)) continue;
    const SpaceGrid::Index at = grid.index(node);
    SpaceGrid::Index low = at;
    if (!allWet(fine, step, low)) continue;
    const double volume = cellVolume(grid, at);
    lost.volume += volume;
    inCell = grid.node(low) == cell ? inCell + volume : volume;
    cell = grid.node(low);
    if (inCell > most) most = inCell, lost.place = grid.place(at);
  }
  return lost;
}

LostParts partsBetweenCrossings(const WaterGrid& fine, const GridCrossings& crossings, int top) {
  const SpaceGrid& grid = fine.grid();
  LostParts worst;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<GridCrossing>& list = crossings.along(axis);
    LostParts lost;
    double most = 0.0;
    for (std::size_t i = 0; i < list.size();) {
      std::size_t last = i;
      while (last + 1 < list.size() && list[last + 1].node == list[i].node) ++last;
      const std::size_t node = list[i].node;
      const SpaceGrid::Index at = grid.index(node);
      if (last > i && at[2] <= top && fine.wet(node) && fine.wet(node + grid.stride(axis))) {
        const double length = list[last].at - list[i].at;
        const double volume =
            length * grid.width((axis + 1) % 3, at[static_cast<std::size_t>((axis + 1) % 3)]) *
            grid.width((axis + 2) % 3, at[static_cast<std::size_t>((axis + 2) % 3)]);
        lost.volume += volume;
        if (volume > most) most = volume, lost.place = grid.place(at);
      }
      i = last + 1;
    }
    if (lost.volume > worst.volume) worst = lost;
  }
  return worst;
}

}  // namespace cutwater
