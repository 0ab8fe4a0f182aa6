#pragma once
#include <string>
#include <vector>

#include "hydro/database/Coefficients.h"

namespace cutwater {

/// What the numbers of a BEMIO file contradict, each in one line with dataset, modes and
/// frequencies: an A(∞) of 0 beside an A(ω) that is not, damping below 0.
std::vector<std::string> bemioContradictions(const Coefficients& coefficients);

}  // namespace cutwater
