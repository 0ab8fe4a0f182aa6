#pragma once
#include <cstdint>

#include "hydro/database/SolverOutput.h"

namespace cutwater {

/// Makes coefficients of what the solver returned; `solve` (solve/Solve.h) does both.
///     Coefficients frigate = finish(buildCoefficients(ship, settings));
/// 1. A and B become symmetric, as they are but for discretisation error [Timman & Newman 1962];
///    what was left of A_jk − A_kj is noted in `Provenance::settings`.
/// 2. What is masked, or not resolved by the panels, is interpolated from the other frequencies,
///    because the memory must not see a resonance that the mask takes out.
/// 3. A(∞) is replaced by the one that A(ω) and B(ω) imply, so that time and frequency domain
///    agree; A, B, ∂A and ∂B above the resolved frequencies are continued by the memory's tail.
/// The result is `Finished`. Where the grid is too coarse, too short or one frequency, step 3 is
/// left out and the result is `Unfinished`, with the reason and the grid that would do. Resonances
/// narrower than the steps of a grid that is fine enough otherwise, such as those of the water
/// between two hulls, do not hinder: resonanceWarning (memory/Resonances.h) names them.
/// @throws HydroError DatabaseIncomplete: the condition limits leave fewer than two frequencies;
///         ValueOutOfRange, FrequenciesNotIncreasing: bad condition limits.
Coefficients finish(SolverOutput output);

/// Largest |X_jk − X_kj| at the first `count` frequencies, of √(X_jj X_kk) at its largest there:
/// discretisation error in A and B.
double asymmetry(const OverFrequency<Mat6>& matrices, std::size_t count = SIZE_MAX);

}  // namespace cutwater
