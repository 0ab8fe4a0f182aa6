#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Most corners of a polygon in a file, as dividing it is quadratic.
inline constexpr int kMostCorners = 10'000;

/// Adds a polygon to a mesh that holds its vertices: three corners or a convex quadrilateral as one
/// face, anything else as triangles by clipping ears in the plane of its vector area. O(corners²).
/// @param corners  counter-clockwise about its normal.
void addPolygon(SurfaceMesh& mesh, const std::vector<int>& corners);

}  // namespace cutwater
