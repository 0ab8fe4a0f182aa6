#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A hull that has passed all checks, in hull axes (x forward, y port, z up from calm water). Made
/// by makeHull, or by repairedHull from a mesh that was not drawn for hydrodynamics.
///     const Hull hull = makeHull(readSurface("frigate.obj"), "frigate.obj", Symmetry::Auto);
///     const SurfaceMesh wet = wetSurface(hull);
struct Hull {
  SurfaceMesh surface;      ///< both sides, vertices shared, normals out of the hull
  bool symmetric = false;   ///< the part in the water is its own mirror image in y = 0
  bool closed = false;      ///< above water as well: fit for nonlinear buoyancy
  FilePlacement file = {};  ///< of a hull that was read from a file (files/MeshIO.h)
};

/// What the user says about port and starboard.
enum class Symmetry {
  Auto,  ///< find out
  None,  ///< do not use symmetry
  Half   ///< the surface is one half
};

/// Makes a hull of a surface in hull axes that may come from anywhere.
/// - Vertices closer than 1e-6 of the size are merged. Those as near to z = 0 (on a symmetric hull,
///   to y = 0 too) are put on it. Of faces on the same corners only the first is kept.
/// - Neighbours are turned to agree. Then each connected piece is turned outwards by the sign of
///   its volume; a piece open at the waterline or the centreline by the volume below water.
/// - A half hull (all on one side, open on y = 0) is mirrored; Symmetry::Auto recognises it.
/// - `symmetric`: each wet vertex has a mirror image, and the transverse moment of volume vanishes.
/// The hull may end at the waterline, or be open above it.
/// @param name  of the file, for messages.
/// @throws HydroError, one line with name, place and value: MeshEmpty, MeshNotFinite,
///   MeshIndexOutOfRange, HullNotInWater; HullNotClosed: an edge below water with one face, or an
///   odd number of them; HullPartHidden: one piece inside another; HullInverted: a one-sided
///   surface, or a piece whose outside cannot be inferred; HullNotSymmetric: Symmetry::Half and
///   vertices on both sides.
Hull makeHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry);

/// The faces below calm water as they are: the port half (y ≥ 0) of a symmetric hull, else both
/// sides. Faces that cross z = 0 or the centreline are cut there. Ready for makePanels.
SurfaceMesh wetSurface(const Hull& hull);

/// The wet surface of both sides.
SurfaceMesh wholeWetSurface(const Hull& hull);
/// The same, of a symmetric hull the port half and its image: of what is only nearly symmetric no
/// heel is left.
SurfaceMesh displacingSurface(const Hull& hull);

}  // namespace cutwater
