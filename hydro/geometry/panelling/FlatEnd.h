#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Adds panels on a flat end of the hull, such as a transom, to a mesh that holds the vertices of
/// its outline. They lie in level rows between the outline's vertices, closer together towards calm
/// water as these are; where such rows would be stretched, they fill the outline as addFlatPolygon
/// does. No panels if the outline encloses nothing, or only calm water.
/// @param outline  the end row of a strand: down the port side, and to starboard along the bottom
///                 or to the centreline.
/// @param aft      the end faces aft (the strand begins there), else forward.
/// @param size     panel edge [m].
void addFlatEnd(const std::vector<int>& outline, bool aft, double size, SurfaceMesh& mesh);

}  // namespace cutwater
