#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Part of the size within which corners of the parts of split faces are one.
inline constexpr double kTogether = 1e-6;

/// A surface whose faces do not pass through one another any more.
struct SplitSurface {
  SurfaceMesh mesh;           ///< triangles; the parts of a split face have vertices of their own
  int firstCut = 0;           ///< vertices from here on were made by splitting
  std::size_t split = 0;      ///< faces that were split
  Vec3 first = Vec3::Zero();  ///< a corner of the first of them
  bool gaveUp = false;        ///< there would be thousands of parts; the mesh is of no use
};

/// Divides every face where others pass through it, along the plane of the other. Then it divides
/// what lies beside the lines of crossing until all parts there share their edges. Faces in one
/// plane are left alone. O(n log n) for few crossings.
SplitSurface splitWhereCrossing(const SurfaceMesh& mesh);

}  // namespace cutwater
