#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Triangles that a mirror image shares, so that a symmetric hull stays symmetric: a flat
/// quadrilateral becomes two, a twisted one four about its mean corner, a vertex of its own. A
/// twisted one encloses what MeshIntegrals.h takes, the mean of both divisions by a diagonal. What
/// was closed stays closed. Triangles stay as they are. O(faces).
///     const WettedTriangles hull(symmetricTriangles(ship.hull), ship.cog);
SurfaceMesh symmetricTriangles(const SurfaceMesh& mesh);

}  // namespace cutwater
