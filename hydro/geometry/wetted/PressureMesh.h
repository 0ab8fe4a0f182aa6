#pragma once
#include <cstddef>
#include <span>

#include "hydro/geometry/SurfaceMesh.h"

/// The mesh that the pressure of the water is integrated on. It is made once, of a closed hull:
/// triangles that end at the stations of a strip theory and are short against the waves.
///     const SurfaceMesh triangles = splitAt(evenTriangles(hull), stations);
///     const RefinedMesh fine = refined(triangles, edgeFor(0.01, waveNumber), 20000);
/// Where neighbours share their vertices, they still do in every result: what was closed stays
/// closed. The same call gives the same bits.
namespace cutwater {

/// Triangles only: each quadrilateral is divided by one of its diagonals. A twisted one encloses
/// more with one than with the other, and MeshIntegrals.h takes the mean. The diagonals are chosen
/// in turn so that the sum stays as near to that mean as one face allows. Triangles stay as they
/// are, also those of no area; those that name a vertex twice go. O(faces).
SurfaceMesh evenTriangles(const SurfaceMesh& mesh);

/// Triangles divided at the planes x = stations, so that none lies on both sides of one. Same
/// surface: vertices stay where they are, new ones lie on edges. A vertex within 1e-9 of the size
/// of a station counts as on it. O(faces · stations).
/// @param stations  [m], in any order.  @throws HydroError ValueOutOfRange: one is not finite.
SurfaceMesh splitAt(const SurfaceMesh& mesh, std::span<const double> stations);

/// A surface with short edges.
struct RefinedMesh {
  SurfaceMesh mesh;
  double longestEdge = 0.0;  ///< [m] what was reached
};

/// Halves the longest edge, with the triangles on both sides of it, until no edge is longer than
/// `longest`. It ends earlier if there would be more than `most` triangles. Same surface. As always
/// the longest edge of a triangle is cut, angles stay above half of the least one of the mesh
/// [Rosenberg & Stenger 1975]. O(n log n).
/// @param longest  [m]  @throws HydroError ValueOutOfRange if it is not above 0.
RefinedMesh refined(const SurfaceMesh& mesh, double longest, std::size_t most);

/// What a pressure that is taken linear between the vertices misses in its integral, at most, as a
/// part of the wave's amplitude, for edges of this length in a wave of this number:
///     (kh)²/12
/// Along an edge of length h linear interpolation misses ½ s (h − s) p″ at s from one end. The mean
/// of ½ s (h − s) is h²/12, and |p″| ≤ k². Over a triangle the mean is Σ (kΔx)²/24, where Δx is how
/// far an edge runs along the wave, at its crest. Of the three Δx one is the sum of the others and
/// none is above h, so Σ Δx² ≤ 2h²: again (kh)²/12. An equilateral triangle has (kh)²/16.
/// Higher powers of kh are left out.
/// @param edge  h [m], waveNumber  k [1/m].
double linearPressureError(double edge, double waveNumber);
/// The edge with that error [m], its inverse: √(12 error)/k.
/// @throws HydroError ValueOutOfRange for an error or a wave number not above 0.
double edgeFor(double error, double waveNumber);

}  // namespace cutwater
