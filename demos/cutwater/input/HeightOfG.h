#pragma once
#include <algorithm>

#include "hydro/geometry/Hydrostatics.h"

namespace cutwater::command {

/// Height of the centre of gravity above calm water [m] where nobody says it.
struct HeightOfG {
  double usual;    ///< 60 % of the depth, from the keel
  double highest;  ///< that leaves a GM of 5 % of the beam
  double height() const { return std::min(usual, highest); }
};
/// @param depth  from the keel to the deck, and `draught` of the keel [m].
inline HeightOfG heightOfG(double depth, double draught, const Hydrostatics& h) {
  return {0.6 * depth - draught, h.buoyancy.z() + h.bmT - 0.05 * h.beam};
}

}  // namespace cutwater::command
