#pragma once
#include <string>
#include <vector>

#include "hydro/bem/settings/SolveSettings.h"

namespace cutwater {

/// From a ship to its database:
///     const ShipParticulars ship = afloat(panelledAsItIs(hull), loading).ship;
///     const Coefficients coefficients = solve(ship, settings);
///     for (const std::string& line : gridWarnings(coefficients)) std::puts(line.c_str());
///     writeCoefficients(coefficients, "ship.h5", impulseResponse(coefficients));
/// (ship/Afloat.h, bem/settings/SolveSettings.h, database/CoefficientsFile.h.)
///
/// Solves radiation and diffraction by panels and makes the result consistent: A and B symmetric,
/// irregular frequencies and those that the panels do not resolve replaced, A(∞) that which A(ω)
/// and B(ω) imply. Where the frequency grid is too coarse or too short for that, or is a single
/// frequency, the coefficients are `Unfinished`: good for the frequency domain at those
/// frequencies, refused by everything that needs a memory.
///
/// A ship whose G lies off the centre plane is solved whole; `ship` in the result is then without
/// symmetry. Frequencies are solved in parallel; 433 panels a side take about 0.1 s a frequency and
/// core.
/// @param journal a file in which finished frequencies are kept, and from which those of an
///        interrupted sweep of the same ship and settings are taken, to the same bits; "": none.
///        The file stays; remove it when the result is safe.
/// @throws HydroError FileNotWritable (journal); MeshEmpty; FrequenciesNotIncreasing,
///         ValueOutOfRange, BadArgument (settings); WaterlineNotClosed (no lid fits);
///         MatrixSingular; DatabaseIncomplete (the condition limits leave fewer than two
///         frequencies).
Coefficients solve(const ShipParticulars& ship, const SolveSettings& settings,
                   const SolveProgress& progress = {}, const std::string& journal = {});

/// What a user should know about the frequency grid, a line each: why the coefficients are
/// unfinished, or what the grid is too coarse for although they are finished, with the step or
/// range that would do. Empty: nothing to say.
std::vector<std::string> gridWarnings(const Coefficients& coefficients);

/// What coefficients are good for, in one line of plain words: which domains, and all that
/// gridWarnings and the panels' own warnings (finish/GridNeeds.h) say against it.
std::string verdict(const Coefficients& coefficients);

/// K⁰ at 0, Δτ, 2Δτ, …, for programs that read it from the file; empty for unfinished coefficients.
/// @param step, duration [s]. @throws HydroError ValueOutOfRange unless 0 < step ≤ duration ≤ 10⁶
///        step.
ImpulseResponse impulseResponse(const Coefficients& coefficients, double step = 0.05,
                                double duration = 30.0);

}  // namespace cutwater
