#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// Panels on a flat end of the hull, such as a transom; not installed.
namespace cutwater {

/// Adds panels inside the outline that the end row of a strand is, which runs down the port side, and
/// to starboard along the bottom or to the centreline: level rows between its vertices, closer
/// together towards calm water as these are. None if the outline encloses nothing, or only calm water.
/// @param aft  the end faces aft (the strand begins there), else forward.
/// @param size panel edge [m].
void addFlatEnd(const std::vector<int>& outline, bool aft, double size, SurfaceMesh& mesh);

}  // namespace cutwater
