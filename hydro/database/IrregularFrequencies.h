#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// An upper envelope of condition numbers at ω: linear between its points (ω_i, limit_i), constant
/// outside, ∞ if it has none.                                                    [M03] 5.7
double conditionLimitAt(const std::vector<std::pair<double, double>>& envelope, double omega);

/// Frequencies whose condition number, even or odd, is above its envelope: 1, else 0. Without any
/// envelope the mask the coefficients already have (empty: none).
std::vector<int> irregularFrequencies(const Coefficients& coefficients);

/// The same coefficients with `masked` set by irregularFrequencies, and everything at those
/// frequencies and at those the panels do not resolve (resolvedCount) from the others, all of them: A, B, ∂A, ∂B and adjoint vectors as in
/// Interpolation.h, through their limits at ω = 0 and towards those at ω = ∞ (adjoint vectors
/// without such limits are held). Diffraction forces at the headings of the table follow from the
/// adjoint vectors; without any they are interpolated themselves, held at the ends. F_I and a
/// DiffractionTable stay: the one has no resonance, the other's frequencies are not those of `omega`.
/// Applying it twice is the same as once.
/// @throws HydroError DatabaseIncomplete if fewer than two frequencies remain; ValueOutOfRange,
///         FrequenciesNotIncreasing for a bad envelope.
Coefficients applyMask(Coefficients coefficients);

}  // namespace cutwater
