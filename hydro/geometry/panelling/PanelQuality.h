#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// How stretched a panel is: ratio of its greatest to its least radius of gyration in its plane. Of a
/// rectangle the ratio of its sides, of an equilateral triangle 1.
double aspectRatio(const SurfaceMesh& mesh, const Face& face);

/// A panel beyond this aspect ratio is stretched; share of these among the panels.
inline constexpr double kStretched = 3.0;
double stretchedShare(const SurfaceMesh& panels);

}  // namespace cutwater
