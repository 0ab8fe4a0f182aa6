#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// How stretched a panel is: ratio of its greatest to its least radius of gyration in its plane.
/// For a rectangle it is the ratio of its sides, for an equilateral triangle 1.
double aspectRatio(const SurfaceMesh& mesh, const Face& face);

/// A panel beyond this aspect ratio counts as stretched.
inline constexpr double kStretched = 3.0;

/// Share of stretched panels.
double stretchedShare(const SurfaceMesh& panels);

}  // namespace cutwater
