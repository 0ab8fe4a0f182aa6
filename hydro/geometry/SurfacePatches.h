#pragma once
#include <limits>
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Faces that hang together across edges of exactly two faces, all turned to agree.
struct SurfacePatch {
  std::vector<int> faces;
  std::vector<bool> turned;  ///< for each face: against its sense in the mesh
};

/// All patches of a surface. Where three or more faces meet, patches end. O(n log n).
/// @param firstCut  patches also end at edges between two vertices from this one on.
/// @throws HydroError HullInverted, naming the place, for a one-sided surface.
std::vector<SurfacePatch> surfacePatches(const SurfaceMesh& mesh, const std::string& name,
                                         int firstCut = std::numeric_limits<int>::max());

/// The mesh with the faces of each patch turned to agree: to the sense that more of the patch's
/// area has.
/// @throws as surfacePatches.
SurfaceMesh agreeing(SurfaceMesh mesh, const std::string& name);

}  // namespace cutwater
