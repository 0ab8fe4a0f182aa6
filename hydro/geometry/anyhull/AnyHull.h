#pragma once
#include <array>
#include <string>
#include <vector>

#include "hydro/geometry/Hull.h"

namespace cutwater {

/// How panels are laid on a hull, in files and commands by the names below.
enum class PanelsBy {
  Auto,      ///< by sections where they follow the hull, else by the surface
  Sections,  ///< rows between cuts across the hull (panelling/Panelling.h): for ships
  Surface    ///< quadrilaterals over any outer surface (outer/SurfacePanels.h)
};

inline constexpr std::array kPanelsByNames{"auto", "sections", "surface"};

/// A hull with panels, made of whatever mesh there is, and what had to be done to it.
///     const AnyHull ship = anyHull(readSurface("frigate.obj"), 433, "frigate.obj");
///     for (const std::string& line : ship.done) std::puts(line.c_str());
struct AnyHull {
  Hull hull;
  SurfaceMesh panels;  ///< of the port half if hull.symmetric, else of both sides
  /// The way that was taken. Panels by surface are to be solved as flat ones (PanelShape::Flat):
  /// their corners stand off so far that they enclose the volume.
  PanelsBy by = PanelsBy::Sections;
  double volume = 0.0;            ///< [m³] of the outer surface below calm water
  double panelVolume = 0.0;       ///< [m³] that the panels enclose, both sides
  std::vector<std::string> done;  ///< one line each, for people
};

/// Repairs the mesh (repair/MeshRepair.h) and lays about `count` panels a side between sections.
/// Where the mesh cannot be repaired, or sections cannot follow it, or what they enclose is not the
/// volume from which a grid of water is kept out, the outer surface is found on that grid and the
/// panels are laid on it. A repaired hull that is closed and has the right volume stays the hull;
/// one that is open above water is closed there as a bowl that is filled, with a line that says so.
/// @param name  of the file, for messages.
/// @throws HydroError as cleanSurface and outerSurface; with PanelsBy::Sections as repairedHull and
///   panelled; ValueOutOfRange for a count below kFewestPanels or above kMostPanels
///   (panelling/Panelling.h: 20 and 20 000).
AnyHull anyHull(const SurfaceMesh& raw, int count, const std::string& name,
                Symmetry symmetry = Symmetry::Auto, PanelsBy by = PanelsBy::Auto);

}  // namespace cutwater
