#pragma once
#include <array>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// Small surfaces whose area and volume are known, and what tests ask of any surface.
namespace cutwater::test {

/// The surface of a body of unit cubes, normals out, vertices shared. A cube is named by its lowest
/// corner; cubes that touch must share a face, not an edge alone.
SurfaceMesh cubes(const std::vector<std::array<int, 3>>& cells);

/// All cubes from one corner to the opposite one, the last not included.
std::vector<std::array<int, 3>> cells(const std::array<int, 3>& low,
                                      const std::array<int, 3>& high);

/// Without the faces that lie in calm water, as wet surfaces are.
SurfaceMesh openOnWater(SurfaceMesh mesh);

/// The same faces in another order, each beginning with another of its corners.
SurfaceMesh shuffled(SurfaceMesh mesh);

/// Have both the same faces, to the last bit of every corner, in whatever order?
bool sameFaces(const SurfaceMesh& a, const SurfaceMesh& b);

/// Sum of the vector areas [m²]: zero for a closed surface.
Vec3 vectorAreaOf(const SurfaceMesh& mesh);

/// How many open edges do not lie in calm water.
int openEdgesBelowWater(const SurfaceMesh& mesh);

}  // namespace cutwater::test
