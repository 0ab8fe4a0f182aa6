#pragma once
#include <cstdint>
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// Steps of makeHull and repairedHull; not installed.
namespace cutwater {

/// Of the size of a hull, what vertices may be off: single precision keeps 6e-8 of a coordinate, files
/// are often written with 6 digits.
inline constexpr double kSnap = 1e-6;

/// @throws HydroError MeshEmpty, MeshNotFinite, MeshIndexOutOfRange, naming file and place.
void checkVertices(const SurfaceMesh& raw, const std::string& name);

/// @throws HydroError HullNotInWater if the box is wholly above or below z = 0.
void checkInWater(const Bounds& box, const std::string& name);

/// Coordinates of this axis within the tolerance of 0 made 0.
SurfaceMesh snapped(SurfaceMesh mesh, int axis, double tolerance);

/// The half and its mirror image in y = 0; faces in the centreplane are inside and go.
SurfaceMesh withMirrorImage(const SurfaceMesh& half);

/// One face's use of an edge, named by its lower vertex, then its higher one.
struct EdgeUse {
  std::uint64_t edge;
  int face;
  bool rising;  ///< the face runs from the lower to the higher
};
/// Of all faces, sorted by edge, then face.
std::vector<EdgeUse> edgeUses(const SurfaceMesh& mesh);

/// Faces on the same corners: only the first is kept.
SurfaceMesh withoutDoubles(const SurfaceMesh& mesh);

/// Edges used by an odd number of faces, whichever way these run.
std::vector<OpenEdge> looseEdges(const SurfaceMesh& mesh);

/// Every connected piece turned outwards. @throws HydroError HullInverted, HullNotClosed; see
/// makeHull.
SurfaceMesh turnedOutwards(const SurfaceMesh& mesh, const std::string& name);

/// "(1.2, 3.4, -5.6)"
std::string placeText(const Vec3& p);

}  // namespace cutwater
