#pragma once
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater::command {

/// Complex amplitude η̂ of the harmonic at `omega` in samples η(t) = Re{η̂ e^{iωt}} + drift, by least
/// squares; the drift, a constant and a straight line, is what is left of a start in modes without
/// stiffness.
/// @param omega  rad/s, signed, not 0.  @param time, value  same size, at least four samples.
Complex harmonicFit(double omega, const std::vector<double>& time,
                    const std::vector<double>& value);

}  // namespace cutwater::command
