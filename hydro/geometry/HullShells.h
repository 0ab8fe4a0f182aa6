#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// Steps on the way from any surface to a hull, shared by makeHull, repairedHull and panelled:
/// checks, snapping, mirroring, and which way is out.
namespace cutwater {

/// Part of the size of a hull by which vertices may be off: single precision keeps 6e-8 of a
/// coordinate, files are often written with 6 digits.
inline constexpr double kSnap = 1e-6;

/// @throws HydroError MeshEmpty, MeshNotFinite, MeshIndexOutOfRange, naming file and place.
void checkVertices(const SurfaceMesh& raw, const std::string& name);

/// @throws HydroError HullNotInWater if the box is wholly above or below z = 0.
void checkInWater(const Bounds& box, const std::string& name);

/// The mesh with coordinates of this axis set to 0 that are within the tolerance of it.
SurfaceMesh snapped(SurfaceMesh mesh, int axis, double tolerance);

/// The half and its mirror image in y = 0. Faces in the centreplane are inside and are dropped.
SurfaceMesh withMirrorImage(const SurfaceMesh& half);

/// The mesh with only the first of faces on the same corners.
SurfaceMesh withoutDoubles(const SurfaceMesh& mesh);

/// The mesh with every connected piece turned outwards.
/// @throws HydroError HullInverted, HullPartHidden; see makeHull.
SurfaceMesh turnedOutwards(const SurfaceMesh& mesh, const std::string& name);

}  // namespace cutwater
