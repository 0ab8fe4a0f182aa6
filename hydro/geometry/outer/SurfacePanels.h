#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/Hull.h"

namespace cutwater {

/// The outer surface of anything, closed, and panels on its wet part.
///     const OuterSurface outer = outerSurface(readSurface("boat.obj"), 433, "boat.obj", Symmetry::Auto);
struct OuterSurface {
  Hull hull;           ///< closed, both sides; a bowl is filled to its lowest rim
  SurfaceMesh panels;  ///< of the port half if hull.symmetric, else of both sides
  double volume = 0.0;      ///< below calm water, of the hull [m³]
  double panelVolume = 0.0; ///< of the panels, both sides [m³]
  std::vector<std::string> done;  ///< one line each, for people
};

/// Finds the outer surface by letting water flow around the mesh on a grid (WaterGrid.h) and lays
/// about `count` panels a side on it, quadrilaterals where possible, with sharp edges kept.
/// Any soup of faces will do: solids that touch, overlap or lie in one another, inner skins, doubled
/// faces, any winding, slits. Plates with water on both sides are left out, and said.
/// @param name  of the file, for messages.
/// @throws HydroError MeshEmpty, MeshNotFinite, MeshIndexOutOfRange, HullNotInWater; HullNotClosed,
///   naming the place, where water gets in and leaves little outside; ValueOutOfRange for the count.
OuterSurface outerSurface(const SurfaceMesh& raw, int count, const std::string& name,
                          Symmetry symmetry);

}  // namespace cutwater
