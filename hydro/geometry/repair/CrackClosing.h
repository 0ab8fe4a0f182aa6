#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A surface of triangles without its cracks. Where vertices lie on an open edge within the
/// tolerance [m], or on any edge of the faces from `firstLoose` on, the faces at that edge are
/// divided there, so that neighbours share their edges. Faces thinner than the tolerance vanish,
/// and so do folds of two faces on the same corners. O(such edges · vertices beside them).
SurfaceMesh withoutCracks(const SurfaceMesh& mesh, double tolerance, std::size_t firstLoose);

}  // namespace cutwater
