#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A surface of triangles with its cracks closed: where vertices lie on an open edge, or on any edge of the
/// faces from `firstLoose` on, within the tolerance [m], the faces at that edge are divided there, so
/// that neighbours share their edges. Thinner faces and folds of two faces on the same corners vanish.
/// Not installed. O(such edges · vertices beside them).
SurfaceMesh withoutCracks(const SurfaceMesh& mesh, double tolerance, std::size_t firstLoose);

}  // namespace cutwater
