#pragma once
#include <functional>
#include <vector>

#include "hydro/database/Coefficients.h"

namespace cutwater {

/// `value` at the frequencies from 0.3 Ω′ to 0.6 Ω′, Ω′ the last frequency that the memory
/// uses (resolvedCount): there A(ω) and B(ω) tell most about A(∞).
std::vector<Mat6> overMiddleBand(const CoefficientTables& coefficients,
                                 const std::function<Mat6(std::size_t frequency)>& value);

}  // namespace cutwater
