#pragma once
#include "hydro/geometry/SurfaceMesh.h"

/// The part of a surface below or above a plane; by default the plane is calm water.
///     const SurfaceMesh wet = cutBelow(hull.surface);
namespace cutwater {

/// The points p with normal·p = offset; "below" is normal·p < offset.
struct Plane {
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double offset = 0.0;          ///< [m]
};

/// The part of a surface below a plane. Faces above it or in it are dropped; faces below stay as
/// they are, in their order; a face that is cut becomes the polygon that is left of it (a triangle,
/// a quadrilateral, or one of each for five corners). Neighbours share the vertices of the cut, so
/// the result is open on the plane only.
/// @param tolerance  [m] vertices this near to the plane are put on it and cut nothing, so that
///                   round-off makes no slivers. Negative: 1e-9 of the mesh's diagonal.
/// @throws HydroError BadArgument if the normal is not a unit vector.
SurfaceMesh cutBelow(const SurfaceMesh& mesh, const Plane& plane = {}, double tolerance = -1.0);

/// The part above: cutBelow with the plane turned over.
SurfaceMesh cutAbove(const SurfaceMesh& mesh, const Plane& plane = {}, double tolerance = -1.0);

/// A wet surface that makePanels can flatten. A quadrilateral with three corners on calm water,
/// whose plane would be the waterplane, becomes two triangles from its fourth corner, each with an
/// edge on calm water. A face with all corners on calm water is dropped.
SurfaceMesh withSplitWaterCorners(const SurfaceMesh& wet);

}  // namespace cutwater
