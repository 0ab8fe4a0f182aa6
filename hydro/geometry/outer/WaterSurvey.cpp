#include "hydro/geometry/outer/WaterSurvey.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshCut.h"

namespace cutwater {
namespace {

constexpr double kNodes = 1.5e6;
constexpr double kMayBeOff = 0.01;  // share of the crossings

SpaceGrid surveyGrid(const Bounds& wet, double& spacing) {
  const Vec3 size = wet.high - wet.low;
  spacing = std::cbrt(std::max(size.x(), 1e-3 * size.maxCoeff()) *
                      std::max(size.y(), 1e-3 * size.maxCoeff()) *
                      std::max(size.z(), 1e-3 * size.maxCoeff()) / kNodes);
  return SpaceGrid(coarsePlanes({wet, spacing, false, {}}));
}

/// The mirror image of a crossing on a grid whose planes of y are alike on both sides.
const SurfaceCrossing* mirrored(const WaterGrid& water, const SurfaceCrossing& c, int axis) {
  const SpaceGrid& grid = water.grid();
  SpaceGrid::Index at = grid.index(c.node);
  at[1] = grid.count(1) - 1 - at[1] - (axis == 1 ? 1 : 0);
  return water.on(grid.node(at), axis);
}

bool isSymmetric(const WaterGrid& water, double tolerance) {
  std::size_t off = 0, all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const SurfaceCrossing& c : water.along(axis)) {
      const SurfaceCrossing* image = mirrored(water, c, axis);
      const double there = axis == 1 ? -c.at : c.at;
      ++all;
      // Where a surface lies along the line a tolerance of place is many of the line.
      if (image == nullptr || std::abs(image->at - there) > tolerance) ++off;
    }
  }
  return static_cast<double>(off) <= kMayBeOff * static_cast<double>(all);
}

/// Projected area of the grid's lines of one axis at a node.
double lineArea(const SpaceGrid& grid, std::size_t node, int axis) {
  const SpaceGrid::Index at = grid.index(node);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  return grid.width(a, at[static_cast<std::size_t>(a)]) *
         grid.width(b, at[static_cast<std::size_t>(b)]);
}

double along(const SurfaceMesh& triangles, int face, int axis) {
  return std::abs(vectorArea(triangles, triangles.faces[static_cast<std::size_t>(face)])
                      .normalized()[axis]);
}

// Lines of all three directions meet a face; each counts by the cosine, so that together they count
// its area once.
void measureSurface(const SurfaceMesh& triangles, WaterSurvey& s) {
  const SpaceGrid& grid = s.water.grid();
  for (int axis = 0; axis < 3; ++axis)
    for (const SurfaceCrossing& c : s.water.along(axis))
      if (c.face >= 0) s.area += lineArea(grid, c.node, axis) * along(triangles, c.face, axis);
  for (std::size_t node = 0; node < grid.nodes(); ++node)
    if (!s.water.wet(node)) s.volume += lineArea(grid, node, 0) * grid.width(0, grid.index(node)[0]);
}

void measurePlates(const SurfaceMesh& triangles, WaterSurvey& s) {
  const SpaceGrid& grid = s.water.grid();
  for (int axis = 0; axis < 3; ++axis) {
    for (const GridCrossing& c : s.crossings.along(axis)) {
      if (!s.water.wet(c.node) || !s.water.wet(c.node + grid.stride(axis))) continue;
      const auto [first, last] = s.crossings.on(c.node, axis);
      if (last - first != 1) continue;  // a thin body
      if (s.plateArea == 0.0) {
        s.platePlace = grid.place(grid.index(c.node));
        s.platePlace[axis] = c.at;
      }
      s.plateArea += lineArea(grid, c.node, axis) * along(triangles, c.face, axis);
    }
  }
}

}  // namespace

WaterSurvey surveyWater(const SurfaceMesh& triangles, double openTolerance,
                        double mirrorTolerance) {
  const Bounds wet = bounds(cutBelow(triangles));
  double spacing = 0.0;
  const SpaceGrid grid = surveyGrid(wet, spacing);
  GridCrossings crossings(triangles, grid, openTolerance);
  WaterGrid water(grid, crossings, false);
  WaterSurvey s{std::move(water), std::move(crossings), spacing, false, wet};
  s.symmetric = isSymmetric(s.water, mirrorTolerance);
  measureSurface(triangles, s);
  measurePlates(triangles, s);
  return s;
}

}  // namespace cutwater
