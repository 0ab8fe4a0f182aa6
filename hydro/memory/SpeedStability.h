#pragma once
#include <string>
#include <vector>

#include "hydro/memory/RadiationModel.h"

namespace cutwater {

/// Looks for steady speeds at which a ship's own motions grow (OwnEquation.h), ahead up to `last`
/// and astern up to half of it.
/// - Surge, heave, roll or pitch that grow are outside the theory: it feeds the ship energy.
/// - Sway and yaw that grow slowly are Munk's moment, which every hull without a helm has. They
///   count for `course` alone, with the lift of the hull.
/// - A mode of negative stiffness (a GM below 0) grows at rest, rightly, and is not looked at.
/// - Surge that grows more slowly than 5·10⁻³√(g/L) counts for nothing: the resistance that this
///   theory lacks damps it ten times faster.
/// @param last [m/s] > 0.  @return nothing checked where the radii of gyration are not known.
SpeedStability speedStability(const CoefficientTables& coefficients, const RadiationModel& model,
                              double last);
/// The last speed to look at unless another is asked for: Fn 0.6.
double lastSpeedToCheck(const ShipParticulars& ship);

/// "unstable above 7.4 m/s in pitch", of a limit that has a speed.
std::string describe(const GrowthLimit& limit, bool astern);
/// What was found, a line each, beginning with "unstable above" or "does not keep its course".
std::vector<std::string> describe(const SpeedStability& stability);

}  // namespace cutwater
