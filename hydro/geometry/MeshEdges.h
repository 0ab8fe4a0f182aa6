#pragma once
#include <cstdint>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// One face's use of an edge.
struct EdgeUse {
  std::uint64_t edge;  ///< its lower vertex in the upper 32 bits, its higher one in the lower
  int face;
  bool rising;  ///< the face runs from the lower to the higher vertex
};
/// Uses of all edges by all faces, sorted by edge, then face.
std::vector<EdgeUse> edgeUses(const SurfaceMesh& mesh);

/// Edges used by an odd number of faces, whichever way these run.
std::vector<OpenEdge> looseEdges(const SurfaceMesh& mesh);

}  // namespace cutwater
