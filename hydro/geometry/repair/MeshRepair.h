#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/Hull.h"

namespace cutwater {

/// A hull made of a mesh that was not drawn for hydrodynamics, and what had to be done to it.
///     const RepairedHull ship = repairedHull(readSurface("yacht.glb"), "yacht", Symmetry::Auto);
///     for (const std::string& line : ship.done) std::puts(line.c_str());
struct RepairedHull {
  Hull hull;
  std::vector<std::string> done;  ///< one line each, for people; empty if nothing was wrong
};

/// Makes a hull of a surface in hull axes that may be a game's visual mesh. makeHull keeps every
/// face; this changes the surface below calm water:
/// - merges vertices closer than 1e-5 of the size, and drops faces without area and doubles;
/// - turns faces to agree with their neighbours and outwards; outside is where the water can be
///   seen (OutsideView.h);
/// - joins shells that pass through one another, such as a bulb put through a bow;
/// - drops what is inside: decks, bulkheads, tanks, inner shells; and plates that are seen from
///   both sides, such as bilge keels of no thickness;
/// - mirrors a half hull, and closes the keel line where two halves do not meet;
/// - closes holes whose width (four times area over circumference) is at most 2 % of the hull's
///   length.
/// Above water nothing is repaired.
/// `symmetric` is found from the surface, not from the vertices: the mirror image of every vertex
/// lies on the hull within 2e-4 of the size (a hundredth of them may be off).
/// @param name  of the file, for messages.
/// @throws HydroError, one line with name, place and value: as makeHull; HullNotClosed for a wider
///   hole; HullPartHidden for a shell that is partly inside another; ShellsNotJoined.
RepairedHull repairedHull(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry);

struct CleanSurface;
/// The same of a surface that has been cleaned.
RepairedHull repairedHull(const CleanSurface& clean, const std::string& name, Symmetry symmetry);

}  // namespace cutwater
