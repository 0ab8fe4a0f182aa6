#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// No file may hold a polygon of more corners, as dividing it is quadratic.
inline constexpr int kMostCorners = 10'000;

/// Adds a polygon, counter-clockwise about its normal, to a mesh that holds its vertices: three
/// corners or a convex quadrilateral as one face, anything else as triangles by clipping ears in
/// the plane of its vector area. O(corners²). Not installed; used by the readers of files.
void addPolygon(SurfaceMesh& mesh, const std::vector<int>& corners);

}  // namespace cutwater
