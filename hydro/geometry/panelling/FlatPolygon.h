#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Adds panels that fill a plane outline of any shape, counter-clockwise about its normal, to a mesh that
/// holds its vertices: those of the outline, and new ones inside on a square grid. Triangles by
/// Delaunay's rule, made quadrilaterals in pairs where these are good. O(corners³) at worst. Not
/// installed.
/// @param size  panel edge [m].
void addFlatPolygon(const std::vector<int>& outline, double size, SurfaceMesh& mesh);

}  // namespace cutwater
