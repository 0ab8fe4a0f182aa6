#pragma once
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {

/// A(∞) as A(ω) and B(ω) give it at finite frequencies,
///     A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ                                     [Ogilvie 1964]
/// averaged over the middle of the band (memory/MiddleBand.h). At ω = ∞ itself the pressure of sway
/// behaves as z ln z at the waterline, and one value a panel leaves an error of first order in the
/// depth of the uppermost panels, about twice that at finite ω. Only with this A(∞) do A(∞) and K
/// together give back the solver's A(ω), so that time and frequency domain agree.
/// THEORY.md, chapter 7.
struct ConsistentLimit {
  Mat6 addedMassInf = Mat6::Zero();  ///< symmetric [kg, kg·m, kg·m²]
  /// Largest |value at one ω − mean| over √(A_jj A_kk), all pairs: small if A, B and the tail
  /// belong together.
  double scatter = 0.0;
  /// The same distance of the ω = ∞ solution from the mean.
  double distance = 0.0;
  /// Scatter and distance are below their bounds: the data reach far enough and are fine enough.
  bool trusted = false;

  /// For data with resonances narrower than the steps (memory/Resonances.h), whose values near them
  /// are far off: the median over all resolved frequencies, entry by entry; its distance as above.
  /// Zero if the limit is trusted.
  Mat6 median = Mat6::Zero();
  double medianDistance = 0.0;
};
inline constexpr double kLargestScatter = 0.02, kLargestDistance = 0.1;
/// Beyond this the median says nothing either.
inline constexpr double kLargestMedianDistance = 0.5;

/// @param memory  of the same coefficients.
ConsistentLimit consistentLimit(const Coefficients& coefficients, const RetardationMatrix& memory);

/// Puts a limit into place as `addedMass.atInfinity` and keeps the solver's own as
/// `addedMassInfDirect`. Above `resolvedOmega` = Ω′ A and B become the memory's continuation: B by
/// its tail, A = A(∞) − (1/ω)∫K sin ωτ dτ, and ∂A, ∂B likewise with a consistent ∂A(∞). ∂A does so
/// earlier: from 0.5 Ω′ to 0.8 Ω′ it goes over from the solver's to ∂A(∞) − (1/ω)∫∂K sin ωτ dτ of
/// ∂B, which there is the better value (decision 0045).
void continueConsistently(Coefficients& coefficients, const RetardationMatrix& memory,
                          const Mat6& addedMassInf);

}  // namespace cutwater
