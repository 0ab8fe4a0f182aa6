#pragma once
#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/outer/DualSurface.h"

/// From a dual surface to panels:
///     mergeShortEdges(surface, 0.25 * length);
///     releaseRoundEdges(surface, fine, tree, 0.02 * length, 0.15 * length);
///     smooth(surface, tree, 8);
///     fillOut(surface, tree, volume, 0.03 * length);
namespace cutwater {

/// Merges the ends of edges shorter than `shortest` [m], the shortest first. The vertex that is
/// held more stays where it is. Vertices on different sharp edges stay apart, so that plates keep
/// their thickness.
void mergeShortEdges(DualSurface& surface, double shortest);

/// Where a surface is rounder than its cells are small, the planes met in a cell look like those of
/// an edge. A vertex that stands off the surface by more than the tolerance [m], with no edge of
/// the fine surface within reach [m], becomes one of a smooth place.
void releaseRoundEdges(DualSurface& surface, const SurfaceMesh& fine, const SurfaceTree& onto,
                       double tolerance, double reach);

/// Moves vertices of smooth places towards the middle of the faces around them and back to the
/// nearest place of the surface, some rounds. Those on sharp edges and corners stay.
/// @param onto  the surface that the vertices shall lie on.
void smooth(DualSurface& surface, const SurfaceTree& onto, int rounds);

/// Moves vertices of smooth places outwards until the volume is the one wanted: panels inscribed in
/// a round body lack some. Each moves in proportion to the height of the surface over the faces
/// around it, so that flat faces stay where they are.
/// @param onto    the surface that the panels stand for.
/// @param volume  [m³] that it encloses with the planes that it is open on.
/// @param most    [m] how far a vertex may move; nor by more than a fifth of the thickness there.
void fillOut(DualSurface& surface, const SurfaceTree& onto, double volume, double most);

}  // namespace cutwater
