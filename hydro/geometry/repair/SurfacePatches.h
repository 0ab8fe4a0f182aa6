#pragma once
#include <limits>
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Faces that hang together across edges of exactly two faces, all turned to agree. Not installed.
struct SurfacePatch {
  std::vector<int> faces;
  std::vector<bool> turned;  ///< each: against its sense in the mesh
};

/// All patches of a surface; where three or more faces meet, patches end. O(n log n).
/// @param firstCut  patches also end at edges between two vertices from this one on.
/// @throws HydroError HullInverted, naming the place, for a one-sided surface.
std::vector<SurfacePatch> surfacePatches(const SurfaceMesh& mesh, const std::string& name,
                                         int firstCut = std::numeric_limits<int>::max());

/// Thin faces of arbitrary sense take that of their neighbours: of each patch the sense that more of its
/// area has. @throws as surfacePatches.
SurfaceMesh agreeing(SurfaceMesh mesh, const std::string& name);

}  // namespace cutwater
