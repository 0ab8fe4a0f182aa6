#pragma once
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater::command {

/// A harmonic and a drift in samples: value(t) = Re{η̂ e^{iθ(t)}} + constant + slope t + rest.
struct HarmonicFit {
  Complex amplitude;                   ///< η̂
  double constant = 0.0, slope = 0.0;  ///< value and slope of the drift at t = 0
  double rest = 0.0;                   ///< r.m.s. of what is left
};

/// By least squares; the drift is what is left of a start in modes without stiffness.
/// @param phase  θ of each sample [rad].  @param time, value  of the same size, at least four.
HarmonicFit harmonicFit(const std::vector<double>& phase, const std::vector<double>& time,
                        const std::vector<double>& value);

}  // namespace cutwater::command
