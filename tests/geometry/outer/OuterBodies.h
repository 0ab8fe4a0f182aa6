#pragma once
#include <cmath>

#include "hydro/geometry/outer/SurfaceFitting.h"
#include "hydro/geometry/outer/WaterSurvey.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/Hulls.h"
#include "tests/support/Meshes.h"

/// Bodies of boxes for the tests of this folder, and grids around them.
namespace cutwater::test {

/// A closed box of triangles.
inline SurfaceMesh box(const Vec3& low, const Vec3& high) {
  SurfaceMesh unit = cubes(cells({0, 0, 0}, {1, 1, 1}));
  for (Vec3& p : unit.vertices) p = low + p.cwiseProduct(high - low);
  return triangulated(unit);
}

/// The same without its top.
inline SurfaceMesh bowl(const Vec3& low, const Vec3& high) {
  SurfaceMesh mesh = box(low, high);
  std::erase_if(mesh.faces, [&](const Face& f) { return meanCorner(mesh, f).z() == high.z(); });
  return mesh;
}

/// Points `spacing` apart around what lies between these corners, off all round numbers.
inline SpaceGrid gridAround(const Vec3& low, const Vec3& high, double spacing) {
  SpaceGrid::Planes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (double p = low[axis] - 1.37 * spacing; p < high[axis] + 2 * spacing; p += spacing)
      planes[static_cast<std::size_t>(axis)].push_back(p);
  return SpaceGrid(planes);
}

inline std::vector<Vec3> unitNormals(const SurfaceMesh& mesh) {
  std::vector<Vec3> normals;
  for (const Face& f : mesh.faces) normals.push_back(vectorArea(mesh, f).normalized());
  return normals;
}

/// Whether the water reaches the node next below a place.
inline bool wetAt(const WaterGrid& water, const Vec3& p) {
  const SpaceGrid& g = water.grid();
  return water.wet(g.node({g.above(0, p.x()), g.above(1, p.y()), g.above(2, p.z())}));
}

inline WaterGrid waterAround(const SurfaceMesh& mesh, double spacing, double slit = 0.0) {
  const Bounds b = bounds(mesh);
  const SpaceGrid grid = gridAround(b.low, b.high, spacing);
  return {grid, GridCrossings(mesh, grid, slit), false};
}

}  // namespace cutwater::test
