#pragma once
#include <vector>

#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// Panels on the interior waterplane z = 0: the lid that removes irregular frequencies ([Lee &
/// Sclavounos 1989]). The waterline is the set of open edges of the wet surface on z = 0. Inside is
/// decided by the even-odd rule, so catamarans, moonpools and dry transoms need no special care.
///
/// The waterplane is cut into trapezoids between stations x = const through the waterline's
/// vertices. Stations closer together than about half a panel are left out; blunt ends are cut
/// along y instead. Each trapezoid is divided so that panels are about `targetLength` long and
/// wide. Corners run so that the normals are (0, 0, 1). The lid's area is the waterplane area of
/// the panelled hull: to round-off if no station was left out, else to a fraction of one panel.
///
/// @param wet          hull below calm water (port half if symmetric), vertices shared.
/// @param symmetric    only the half y ≥ 0, bounded by the centreline.
/// @param targetLength [m]; 0: the mean length of the waterline's edges.
/// @return empty if the surface has no waterline. O(edges · stations).
/// @throws HydroError WaterlineNotClosed if the waterline has a loose end other than on the
///   centreline.
std::vector<Panel> makeLid(const SurfaceMesh& wet, bool symmetric, double targetLength = 0.0);

}  // namespace cutwater
