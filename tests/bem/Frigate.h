#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater::test {

/// The frigate's port half below water, with what the solver asks of a ship.
inline ShipParticulars frigateAfloat(const FrigateDivision& division) {
  ShipParticulars ship;
  ship.wetSurface = wetFrigate(division.along, division.girth);
  ship.symmetric = true;
  ship.cog = Vec3(-2.4165, 0.0, 1.29);
  ship.volume = 4509.0;
  return ship;
}

}  // namespace cutwater::test
