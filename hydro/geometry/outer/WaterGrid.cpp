#include "hydro/geometry/outer/WaterGrid.h"

#include <algorithm>

namespace cutwater {

WaterGrid::WaterGrid(SpaceGrid grid, const GridCrossings& crossings, bool halfAtY)
    : WaterGrid(std::move(grid), halfAtY) {
  flood(crossings);
  for (int axis = 0; axis < 3; ++axis) findSurface(crossings, axis);
}

void WaterGrid::flood(const GridCrossings& crossings) {
  wet_.assign(grid_.nodes(), 0);
  std::vector<std::uint32_t> front;
  const auto reach = [&](std::size_t node) {
    if (wet_[node] != 0) return;
    wet_[node] = 1;
    front.push_back(static_cast<std::uint32_t>(node));
  };
  const int nx = grid_.count(0), ny = grid_.count(1), nz = grid_.count(2);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j)
      for (const int i : {0, nx - 1}) reach(grid_.node({i, j, k}));
    for (int i = 0; i < nx; ++i) {
      if (!halfAtY_) reach(grid_.node({i, 0, k}));
      reach(grid_.node({i, ny - 1, k}));
    }
  }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) reach(grid_.node({i, j, 0}));
  while (!front.empty()) {
    const std::size_t node = front.back();
    front.pop_back();
    const SpaceGrid::Index at = grid_.index(node);
    for (int axis = 0; axis < 3; ++axis) {
      const int i = at[static_cast<std::size_t>(axis)];
      const std::size_t stride = grid_.stride(axis);
      if (i + 1 < grid_.count(axis) && !crossings.blocked(node, axis)) reach(node + stride);
      const bool falls = axis == 2 && grid_.plane(2, i) > 0;
      if (i > 0 && !falls && !crossings.blocked(node - stride, axis)) reach(node - stride);
    }
  }
}

void WaterGrid::findSurface(const GridCrossings& crossings, int axis) {
  std::vector<SurfaceCrossing>& out = along_[static_cast<std::size_t>(axis)];
  const std::size_t stride = grid_.stride(axis);
  const int count = grid_.count(axis);
  for (std::size_t node = 0; node + stride < wet_.size(); ++node) {
    if (wet_[node] == wet_[node + stride]) continue;
    const int i = grid_.index(node)[static_cast<std::size_t>(axis)];
    if (i + 1 >= count) continue;
    const auto [first, last] = crossings.on(node, axis);
    if (first == last) {
      out.push_back({static_cast<std::uint32_t>(node), -1,
                     0.5 * (grid_.plane(axis, i) + grid_.plane(axis, i + 1))});
    } else {
      const GridCrossing& met = wet_[node] != 0 ? *first : *(last - 1);
      out.push_back({met.node, met.face, met.at});
    }
  }
}

WaterGrid WaterGrid::coarser(int step, int top) const {
  SpaceGrid::Planes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= (axis == 2 ? top : grid_.count(axis) - 1); i += step)
      planes[static_cast<std::size_t>(axis)].push_back(grid_.plane(axis, i));
  WaterGrid coarse(SpaceGrid(std::move(planes)), halfAtY_);
  coarse.wet_.resize(coarse.grid_.nodes());
  for (std::size_t node = 0; node < coarse.wet_.size(); ++node) {
    const SpaceGrid::Index at = coarse.grid_.index(node);
    coarse.wet_[node] = wet_[grid_.node({step * at[0], step * at[1], step * at[2]})];
  }
  for (int axis = 0; axis < 3; ++axis) coarse.sampleCrossings(*this, step, axis);
  return coarse;
}

void WaterGrid::sampleCrossings(const WaterGrid& fine, int step, int axis) {
  const std::size_t stride = grid_.stride(axis), fineStride = fine.grid_.stride(axis);
  for (std::size_t node = 0; node + stride < wet_.size(); ++node) {
    if (wet_[node] == wet_[node + stride]) continue;
    const SpaceGrid::Index at = grid_.index(node);
    if (at[static_cast<std::size_t>(axis)] + 1 >= grid_.count(axis)) continue;
    std::size_t from = fine.grid_.node({step * at[0], step * at[1], step * at[2]});
    const bool rising = wet_[node] != 0;
    if (rising) {
      while (fine.wet_[from + fineStride] != 0) from += fineStride;
    } else {
      from += static_cast<std::size_t>(step - 1) * fineStride;
      while (fine.wet_[from] != 0) from -= fineStride;
    }
    const SurfaceCrossing& met = *fine.on(from, axis);
    along_[static_cast<std::size_t>(axis)].push_back(
        {static_cast<std::uint32_t>(node), met.face, met.at});
  }
}

const SurfaceCrossing* WaterGrid::on(std::size_t node, int axis) const {
  const std::vector<SurfaceCrossing>& list = along(axis);
  const auto found =
      std::lower_bound(list.begin(), list.end(), node,
                       [](const SurfaceCrossing& c, std::size_t n) { return c.node < n; });
  return found != list.end() && found->node == node ? &*found : nullptr;
}

}  // namespace cutwater
