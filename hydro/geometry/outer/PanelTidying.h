#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// The faces of panels, on the same vertices, without slivers and without faces that fold over: a
/// triangle of no height goes, and its middle corner becomes one of the face across its longest
/// edge; a re-entrant quadrilateral is divided by the diagonal within it. What was closed stays
/// closed.
std::vector<Face> tidied(const SurfaceMesh& panels);

/// The faces without pairs that lie back to back on the same corners.
std::vector<Face> withoutFolds(const std::vector<Face>& faces);

}  // namespace cutwater
