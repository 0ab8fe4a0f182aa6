#pragma once
#include <string>
#include <vector>

#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {

/// A peak of damping narrower than the steps of the frequency grid, as the water between the hulls
/// of a catamaran has them.
/// THEORY.md, chapter 7.
struct Resonance {
  Mode mode;
  double omega;  ///< [rad/s], of the grid
};

/// Resonances that the grid does not follow, by frequency. There B_jj has a peak of more than twice
/// what it is two steps away, and beside it the A(∞) that follows from A(ω) and the memory
///     A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ
/// is further than 20 % from `addedMassInf`. A peak of area S at ω₀ moves it by
/// (2/π)S/(ω² − ω₀²): hardly at all far from the peak.
/// @param memory  of the same coefficients.
std::vector<Resonance> resonances(const CoefficientTables& coefficients,
                                  const RetardationMatrix& memory, const Mat6& addedMassInf);

/// As text: "1.5 (sway, roll), 2 (heave)", frequencies in rad/s; "" if there are none.
std::string listed(const std::vector<Resonance>& resonances);

/// The resonances of finished coefficients in one line; "" if there are none. Motions near them are
/// not right in the time domain.
std::string resonanceWarning(const Coefficients& coefficients);

}  // namespace cutwater
