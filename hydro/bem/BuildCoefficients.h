#pragma once
#include <functional>

#include "hydro/bem/settings/SolveSettings.h"
#include "hydro/database/SolverOutput.h"

namespace cutwater {

/// Called at the start with what the journal holds, then after each finished frequency, by one
/// thread at a time, not always the same one. What it throws stops the sweep and comes out of
/// buildCoefficients.
using SolveProgress = std::function<void(int done, int total)>;

/// Radiation and diffraction of a ship at rest in deep water: A, B, A(0), A(∞), F_I, F_D, ∂A, ∂B,
/// adjoint vectors and condition numbers; at forward speed what settings.influence asks for. Panel
/// method (InfluenceMatrices.h). Condition limits are copied into the result, on which applyMask
/// (IrregularFrequencies.h) acts; here they only keep irregular frequencies from being nodes
/// between which influence = Matrix or Inverse interpolates.
///
/// A hull with `symmetric` set is solved by its port half; if G lies off its centre plane the modes
/// mix, so it is solved whole and the result's wetSurface is the whole surface. Everything of
/// `ship` is copied into the result; restoring and masses are not looked at.
///
/// Time: per frequency two LU factorizations of (n + m)³ and (n + m)² wave terms, n panels a side,
/// m on the lid; frequencies are solved in parallel. Memory: 64(n + m)² bytes a thread and as much
/// again.
/// @param journal  a file in which finished frequencies are kept, and from which those of an
///        interrupted sweep of the same ship and settings are taken, to the same bits; "": none. It
///        stays; remove it when the result is safe.
/// @throws HydroError FileNotWritable (journal), FrequenciesNotIncreasing, ValueOutOfRange,
///         MeshEmpty, BadArgument,
/// MatrixSingular, HullNotClosed (no lid fits the waterline).
SolverOutput buildCoefficients(const ShipParticulars& ship, const SolveSettings& settings,
                               const SolveProgress& progress = {}, const std::string& journal = {});

}  // namespace cutwater
