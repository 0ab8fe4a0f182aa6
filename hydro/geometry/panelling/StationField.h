#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// The station of each vertex of a wet hull [m], for SectionCutter: its x, but stations lean where
/// the hull ends in a flat face that leans (a transom, the ends of a barge) or in a stem that does,
/// raked or bulging out as a sunk sphere; less and less with the distance from it. The vertices of
/// such a face or stem are on one station exactly, though those of a face may be rough by 2e-4 of
/// the size.
/// @param leastArea  [m²] of a face that counts. It must face more forward or aft than up, down or
///   sideways, and no part of the hull may lie beyond it.
std::vector<double> stationField(const SurfaceMesh& wet, double leastArea);

}  // namespace cutwater
