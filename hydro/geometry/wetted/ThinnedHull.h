#pragma once
#include <cstddef>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A closed hull with fewer triangles, and what was lost.
///     const ThinnedHull hull = thinned(ship.hull, 2000);
///     std::printf("%zu triangles, %.3f m off\n", hull.mesh.faces.size(), hull.distance);
struct ThinnedHull {
  SurfaceMesh mesh;       ///< triangles
  double distance = 0.0;  ///< [m] of that vertex of either surface which is farthest off the other
  double volumeError = 0.0;  ///< of the whole volume, as a part of it: round-off
  /// Of the volume below calm water, as a part of it; 0 if there is none.
  double submergedError = 0.0;
  /// The largest of those of the waterplane's area, ∫x² dA and ∫y² dA, as a part of each.
  double waterplaneError = 0.0;
};

/// The hull with at most `most` triangles, by merging the two ends of edges. A hull that has no
/// more comes back as evenTriangles makes it. 100 000 triangles take about a second.
///
/// The edge that costs least is merged first. Its one vertex is placed where the tetrahedra between
/// it and the old triangles have the least sum of squared volumes, under the condition that their
/// sum is 0: the enclosed volume is kept to round-off [Lindstrom & Turk 1998]. Edges that are sharp
/// stay so, since leaving them costs volume.
///
/// What floats upright must not change, so the hull is first divided along calm water. Vertices
/// there stay there, and merge only with their neighbours along the waterline, where the area of
/// the waterplane counts too. Nothing passes from one side to the other (decision 0103).
/// A hull that is its own mirror image to kSnap stays so, to the bit.
///
/// Each shell stays closed and keeps its topology: holes and handles stay. So some edges cannot go,
/// and a bound that is too low is not met. Edges that are open or have more than two triangles stay
/// as they are. Two shells that nearly touch may come to cross if `distance` is larger than their
/// gap.
/// @throws HydroError MeshEmpty for a mesh without faces.
ThinnedHull thinned(const SurfaceMesh& closed, std::size_t most);

}  // namespace cutwater
