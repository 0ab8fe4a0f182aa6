#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// Steps of makeHull; not installed.
namespace cutwater {

/// Faces on the same corners: only the first is kept.
SurfaceMesh withoutDoubles(const SurfaceMesh& mesh);

/// Edges used by an odd number of faces, whichever way these run.
std::vector<OpenEdge> looseEdges(const SurfaceMesh& mesh);

/// Every connected piece turned outwards. @throws HydroError HullInverted, HullNotClosed; see
/// makeHull.
SurfaceMesh turnedOutwards(const SurfaceMesh& mesh, const std::string& name);

/// "(1.2, 3.4, -5.6)"
std::string placeText(const Vec3& p);

}  // namespace cutwater
