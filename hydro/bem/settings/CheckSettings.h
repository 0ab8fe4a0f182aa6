#pragma once
#include "hydro/bem/settings/SolveSettings.h"

namespace cutwater {

/// Refuses what buildCoefficients cannot solve.
/// @throws HydroError as buildCoefficients.
void check(const ShipParticulars& ship, const SolveSettings& settings);

}  // namespace cutwater
