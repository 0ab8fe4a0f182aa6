#pragma once
#include <functional>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// Surfaces from functions of two parameters: what Shapes.cpp, FrigateShape.cpp and Loft.cpp build
/// with.
namespace cutwater {

/// Faces between the points P(u_i, v_j), normals along ∂P/∂u × ∂P/∂v: for a port side u runs from
/// stern to bow, v from the top down. Coincident points are merged, so quadrilaterals degenerate to
/// triangles; coordinates below 1e-12 of the largest become 0 exactly.
SurfaceMesh gridSurface(const std::vector<double>& u, const std::vector<double>& v,
                        const std::function<Vec3(double, double)>& point);

/// The same with each curve v → P(u_i, v) cut at these fractions of its length.
SurfaceMesh gridOfCurves(const std::vector<double>& u, const std::vector<double>& fractions,
                         const std::function<Vec3(double, double)>& point);

/// Port half of a vertical wall of `up` rows between calm water and the deck edge, with its deck.
SurfaceMesh wallSided(const std::vector<double>& u, int up, int acrossDeck,
                      const std::function<Vec3(double)>& deckEdge);

/// A whole hull from its port half: the wet part, its mirror image, the dry part and its mirror
/// image, with shared vertices.
SurfaceMesh closedFromHalves(const SurfaceMesh& wetHalf, const SurfaceMesh& dryHalf);

}  // namespace cutwater
