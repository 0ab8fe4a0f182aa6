#pragma once
#include <optional>

#include "hydro/ship/Righting.h"

namespace cutwater {

/// What a curve of righting levers says, to one side.
///     Righting righting(ship, RightingTrim::Free);
///     const StabilityRange range = stabilityRange(righting, kPi);  // all of starboard
/// THEORY.md, chapter 2.
struct StabilityRange {
  double gm = 0.0;  ///< d gz / d heel at heel 0 [m]; below 0: not stable there
  /// Heel at which the ship lies at rest [rad]: 0 if it is stable upright, else the angle of loll,
  /// or of the list if it is loaded to one side. Absent: none but keel up.
  std::optional<double> rest;
  std::optional<double> vanishing;        ///< the next heel where gz is 0 [rad]
  std::optional<RightingLever> greatest;  ///< between the two
};

/// Equilibria are told apart if they are at least a degree apart, and found to round-off.
/// @param last  heel [rad] where the search for `vanishing` and `greatest` ends; its sign is the
///              side. `rest` is looked for on that side up to keel up, a list on both.
/// @throws HydroError as Righting::at.
StabilityRange stabilityRange(Righting& righting, double last);

}  // namespace cutwater
