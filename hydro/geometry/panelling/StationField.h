#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// For each vertex of a wet hull the station it lies on [m]: x, but where the hull ends in a flat face
/// (transom, the ends of a barge) that leans, or in a stem that does, raked or bulging out as a sunk sphere,
/// stations lean with it, less and less with the distance from it. The vertices of such a face or stem are
/// on one station exactly, though those of a face may be rough by 2e-4 of the size. Not installed.
/// @param leastArea  [m²] of a face that counts; it must face more forward or aft than up, down or
///   sideways, and no part of the hull may lie beyond it.
std::vector<double> stationField(const SurfaceMesh& wet, double leastArea);

}  // namespace cutwater
