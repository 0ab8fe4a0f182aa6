#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// The points p with normal·p = offset; "below" is normal·p < offset.
struct Plane {
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double offset = 0.0;          ///< [m]
};

/// The part of a surface below a plane; the default plane is calm water. Faces above it or in it
/// are dropped, faces below kept as they are and first to last in their order; a face that is cut
/// keeps its polygon (triangle, quadrilateral, or for five corners one of each). Neighbours share
/// the vertices of the cut, so the result is open on the plane only.
/// @param tolerance  [m] vertices this near to the plane are put on it and cut nothing, which is
/// what
///                   keeps round-off from making slivers; negative: 1e-9 of the mesh's diagonal.
/// @throws HydroError BadArgument if the normal is not a unit vector.
SurfaceMesh cutBelow(const SurfaceMesh& mesh, const Plane& plane = {}, double tolerance = -1.0);

/// The part above: cutBelow with the plane turned over.
SurfaceMesh cutAbove(const SurfaceMesh& mesh, const Plane& plane = {}, double tolerance = -1.0);

/// Faces that makePanels can lay: a quadrilateral with three corners on calm water, whose plane would
/// be the waterplane, as two triangles from its fourth corner, each with an edge on calm water; none
/// with all corners there.
SurfaceMesh withSplitWaterCorners(const SurfaceMesh& wet);

}  // namespace cutwater
