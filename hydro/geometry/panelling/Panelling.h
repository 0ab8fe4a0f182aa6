#pragma once
#include <string>

#include "hydro/geometry/Hull.h"

namespace cutwater {

inline constexpr int kFewestPanels = 20, kMostPanels = 20'000;

/// Solver panels for the wet part of a hull of any triangulation, about `count` of them a side.
///     const SurfaceMesh panels = panelled(readHull("frigate.obj"), 433, "frigate.obj");
///
/// The hull is cut at stations, x = const or leaning as its ends do, closer together at the ends.
/// Each section is divided from calm water to the keel (of one hull of a catamaran: to calm water
/// again), closer together towards calm water and at bilges, the closer the sharper. Neighbouring
/// sections are joined by quadrilaterals, and by triangles where the shorter one has fewer parts.
/// Knuckles along and across the hull become panel edges; flat ends (transoms) get panels of their
/// own. Panels are longer than deep, up to 2.4 times where fewer rows would leave volume out.
/// Corners lie on the given surface, so volume and area are below the hull's by the second order of
/// the panel size; corners on the waterline stay at z = 0.
///
/// @param name  of the hull's file, for messages.
/// @return the wet panels: of the port half if hull.symmetric, else of both sides (then 2·count of
///   them); ready for makePanels. O(faces + count · faces at one section).
/// @throws HydroError ValueOutOfRange for a count below kFewestPanels or above kMostPanels;
///   SectionsNotFollowed, naming the place, where a section splits, or two parts touch.
SurfaceMesh panelled(const Hull& hull, int count, const std::string& name);

}  // namespace cutwater
