#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/outer/LeakStopping.h"
#include "hydro/geometry/outer/LostParts.h"

namespace cutwater {

/// The outer surface of anything, closed, and panels on its wet part.
///     const CleanSurface clean = cleanSurface(mesh, "rig", Symmetry::Auto);
///     const TightSurface tight = withoutLeaks(clean.mesh, "rig");
///     const OuterSurface outer = outerSurface(tight, 433, Symmetry::Auto);
struct OuterSurface {
  Hull hull;            ///< both sides, closed; a bowl is filled to its lowest rim. Open at calm
                        ///< water if less than 5 % of its volume would be above that
  SurfaceMesh panels;   ///< of the port half if hull.symmetric, else of both sides
  double volume = 0.0;  ///< below calm water, of the hull [m³]
  double panelVolume = 0.0;       ///< of the panels, both sides [m³]
  double volumeOff = 0.0;         ///< part of it by which two grids differ, one twice as fine
  LostParts betweenPanels;        ///< parts that the panels do not show
  LostParts thin;                 ///< parts that the hull does not show either
  std::vector<std::string> done;  ///< one line each, for people
};

/// Finds the outer surface by letting water flow around the mesh on a grid (WaterGrid.h) and lays
/// about `count` panels a side on it, quadrilaterals where possible, with sharp edges kept.
/// Any soup of faces will do: solids that touch, overlap or lie in one another, inner skins,
/// doubled faces, any winding, slits. Plates with water on both sides are left out, and said.
/// The count may rise by half where the panels would lack volume otherwise.
/// @param knownVolume  [m³] of the closed faces below water, if they could be repaired: where it is
///   within 0.4 % of the grid's, the panels enclose it.
OuterSurface outerSurface(const TightSurface& tight, int count, Symmetry symmetry,
                          double knownVolume = 0.0);

/// What that surface encloses below calm water [m³], on the grid of the survey.
double outerVolume(const TightSurface& tight);

}  // namespace cutwater
