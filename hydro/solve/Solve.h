#pragma once
#include <string>

#include "hydro/bem/BuildCoefficients.h"

namespace cutwater {

/// From a ship to its database, in one call:
///     const ShipParticulars ship = afloat(hull, loading);            // ship/Afloat.h
///     SolveSettings settings{.omega = frequencyGrid(ship), .headings = {kPi}};
///     writeCoefficients(solve(ship, settings), "ship.h5");       // database/CoefficientsFile.h
/// Solves radiation and diffraction (buildCoefficients) and finishes the result (finish/Finish.h).
/// A grid that is too coarse for a memory gives unfinished coefficients; gridWarnings says what
/// would do.
/// @param progress, journal  of buildCoefficients.
/// @throws HydroError as buildCoefficients and finish.
Coefficients solve(const ShipParticulars& ship, const SolveSettings& settings,
                   const SolveProgress& progress = {}, const std::string& journal = {});

}  // namespace cutwater
