#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Adds panels that fill a plane outline of any shape to a mesh that holds its vertices: between
/// those of the outline, and new ones inside on a square grid. Triangles by Delaunay's rule, joined
/// in pairs to quadrilaterals where these are good. O(corners³) at worst.
/// @param outline  counter-clockwise about its normal.
/// @param size     panel edge [m].
void addFlatPolygon(const std::vector<int>& outline, double size, SurfaceMesh& mesh);

}  // namespace cutwater
