#pragma once
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::test {

/// The frigate of so many panels, with what solver and time domain ask of a ship; its supplementary
/// terms are none.
inline ShipParticulars frigateAfloat(const FrigateDivision& division) {
  const PanelledHull hull{{}, wetFrigate(division.along, division.girth), true};
  return afloat(hull, {.cog = Vec3(-2.4165, 0.0, 1.29), .gyradii = Vec3(5.82, 28.8, 28.8)}).ship;
}

}  // namespace cutwater::test
