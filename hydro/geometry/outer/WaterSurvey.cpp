#include "hydro/geometry/outer/WaterSurvey.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/SurfaceTree.h"

namespace cutwater {
namespace {

constexpr double kNodes = 1.5e6;
constexpr double kMayHeel = 1e-3;  // ∫ y dV over V and the half breadth, as of a repaired hull

SpaceGrid surveyGrid(const Bounds& wet, double& spacing) {
  const Vec3 size = wet.high - wet.low;
  spacing = std::cbrt(std::max(size.x(), 1e-3 * size.maxCoeff()) *
                      std::max(size.y(), 1e-3 * size.maxCoeff()) *
                      std::max(size.z(), 1e-3 * size.maxCoeff()) / kNodes);
  return SpaceGrid(coarsePlanes({wet, spacing, false, {}}));
}

/// Projected area of the grid's lines of one axis at a node.
double lineArea(const SpaceGrid& grid, std::size_t node, int axis) {
  const SpaceGrid::Index at = grid.index(node);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  return grid.width(a, at[static_cast<std::size_t>(a)]) *
         grid.width(b, at[static_cast<std::size_t>(b)]);
}

double along(const SurfaceMesh& triangles, int face, int axis) {
  return std::abs(
      vectorArea(triangles, triangles.faces[static_cast<std::size_t>(face)]).normalized()[axis]);
}

/// Places where the water meets the surface, and the faces met.
std::vector<Vec3> placesOf(const SurfaceMesh& triangles, const WaterGrid& water,
                           SurfaceMesh& seen) {
  std::vector<Vec3> places;
  std::vector<bool> isSeen(triangles.faces.size(), false);
  for (int axis = 0; axis < 3; ++axis) {
    for (const SurfaceCrossing& c : water.along(axis)) {
      if (c.face < 0) continue;
      places.push_back(water.grid().place(water.grid().index(c.node)));
      places.back()[axis] = c.at;
      isSeen[static_cast<std::size_t>(c.face)] = true;
    }
  }
  seen.vertices = triangles.vertices;
  for (std::size_t f = 0; f < isSeen.size(); ++f)
    if (isSeen[f]) seen.faces.push_back(triangles.faces[f]);
  return places;
}

// Lines of all three directions meet a face; each counts by the cosine, so that together they count
// its area once.
void measureSurface(const SurfaceMesh& triangles, WaterSurvey& s) {
  const SpaceGrid& grid = s.water.grid();
  for (int axis = 0; axis < 3; ++axis)
    for (const SurfaceCrossing& c : s.water.along(axis))
      if (c.face >= 0) s.area += lineArea(grid, c.node, axis) * along(triangles, c.face, axis);
  for (std::size_t node = 0; node < grid.nodes(); ++node) {
    if (s.water.wet(node)) continue;
    const SpaceGrid::Index at = grid.index(node);
    const double volume = lineArea(grid, node, 0) * grid.width(0, at[0]);
    s.volume += volume;
    s.middle += volume * grid.place(at);
  }
  if (s.volume > 0) s.middle /= s.volume;
}

void measurePlates(const SurfaceMesh& triangles, WaterSurvey& s) {
  const SpaceGrid& grid = s.water.grid();
  for (int axis = 0; axis < 3; ++axis) {
    for (const GridCrossing& c : s.crossings.along(axis)) {
      if (!s.water.wet(c.node) || !s.water.wet(c.node + grid.stride(axis))) continue;
      const auto [first, last] = s.crossings.on(c.node, axis);
      if ((last - 1)->at - first->at > 1e-6 * s.spacing || first != &c) continue;  // a thin body
      if (s.plateArea == 0.0) {
        s.platePlace = grid.place(grid.index(c.node));
        s.platePlace[axis] = c.at;
      }
      s.plateArea += lineArea(grid, c.node, axis) * along(triangles, c.face, axis);
    }
  }
}

}  // namespace

WaterSurvey surveyWater(const SurfaceMesh& triangles, double openTolerance) {
  const Bounds wet = bounds(cutBelow(triangles));
  double spacing = 0.0;
  const SpaceGrid grid = surveyGrid(wet, spacing);
  GridCrossings crossings(triangles, grid, openTolerance);
  WaterGrid water(grid, crossings, false);
  WaterSurvey s{std::move(water), std::move(crossings), spacing, wet};
  measureSurface(triangles, s);
  measurePlates(triangles, s);
  return s;
}

bool isMirrorImage(const SurfaceMesh& triangles, const WaterSurvey& s, double tolerance) {
  if (std::abs(s.middle.y()) > kMayHeel * std::max(s.wet.high.y(), -s.wet.low.y())) return false;
  SurfaceMesh seen;
  const std::vector<Vec3> places = placesOf(triangles, s.water, seen);
  return holdsMirrorImages(SurfaceTree(seen), places, tolerance);
}

}  // namespace cutwater
