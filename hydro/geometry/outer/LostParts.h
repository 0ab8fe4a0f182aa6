#pragma once
#include "hydro/geometry/outer/WaterGrid.h"

namespace cutwater {

/// What a grid of panels does not see.
struct LostParts {
  double volume = 0.0;        ///< of solid parts [m³]
  Vec3 place = Vec3::Zero();  ///< where most of it is [m]
};

/// Parts below calm water that lie between the nodes of the panels' grid.
/// @param fine  the grid that is known; its nodes `step` apart up to plane `top` of z are the
///   panels'.
LostParts partsBetweenNodes(const WaterGrid& fine, int step, int top);

/// Parts thinner than the grid's own cells: solid between two crossings of one edge of the grid
/// with water at both ends. The greatest of what lines along x, y and z find.
LostParts partsBetweenCrossings(const WaterGrid& fine, const GridCrossings& crossings, int top);

}  // namespace cutwater
