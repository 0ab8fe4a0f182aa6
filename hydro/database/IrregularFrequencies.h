#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// An upper envelope of condition numbers at ω: linear between its points (ω_i, limit_i), constant
/// outside, ∞ if it has none.                                                    [M03] 5.7
double conditionLimitAt(const std::vector<std::pair<double, double>>& envelope, double omega);

/// Frequencies whose condition number, even or odd, is above its envelope: 1, else 0. Without any
/// envelope the mask the coefficients already have (empty: none).
/// @throws HydroError ValueOutOfRange, FrequenciesNotIncreasing for a bad envelope.
std::vector<int> irregularFrequencies(const CoefficientTables& coefficients);

}  // namespace cutwater
