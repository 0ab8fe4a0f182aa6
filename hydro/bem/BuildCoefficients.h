#pragma once
#include <string>

#include "hydro/bem/settings/SolveSettings.h"
#include "hydro/database/SolverOutput.h"

namespace cutwater {

/// The panel solver: radiation and diffraction of a ship at rest in deep water. `solve`
/// (solve/Solve.h) calls it and finishes the result.
///
/// Gives A, B, A(0), A(∞), F_I, F_D, ∂A, ∂B, adjoint vectors and condition numbers; at forward
/// speed what settings.influence asks for. Condition limits are copied into the output, where
/// `finish` applies them; here they only keep irregular frequencies from being nodes between which
/// influence = Matrix or Inverse interpolates.
///
/// A hull with `symmetric` set is solved by its port half. If G lies off its centre plane the modes
/// mix, so it is solved whole and the output's wetSurface is the whole surface. Everything of
/// `ship` is copied into the output; restoring and masses are not used.
///
/// Time: per frequency two LU factorizations of (n + m)³ and (n + m)² wave terms, n panels a side,
/// m on the lid; frequencies are solved in parallel. Memory: 64(n + m)² bytes a thread and as much
/// again.
/// @param journal a file in which finished frequencies are kept, and from which those of an
///        interrupted sweep of the same ship and settings are taken, to the same bits; "": none.
///        The file stays; remove it when the result is safe.
/// @throws HydroError FileNotWritable (journal), FrequenciesNotIncreasing, ValueOutOfRange,
///         MeshEmpty, BadArgument, MatrixSingular, WaterlineNotClosed (no lid fits the waterline).
SolverOutput buildCoefficients(const ShipParticulars& ship, const SolveSettings& settings,
                               const SolveProgress& progress = {}, const std::string& journal = {});

}  // namespace cutwater
