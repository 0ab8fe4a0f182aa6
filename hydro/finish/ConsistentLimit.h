#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "hydro/memory/RetardationMatrix.h"

namespace cutwater {

/// A(∞) as A(ω) and B(ω) give it at finite frequencies,
///     A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ                                     [Ogilvie 1964]
/// averaged over ω from 0.3 Ω' to 0.6 Ω', Ω' the last frequency the memory uses. At ω = ∞ itself
/// the pressure of sway goes as z ln z at the waterline and one value a panel leaves an error of
/// first order in the depth of the uppermost panels, about twice that at finite ω (frigate: 1 % with
/// 433 panels a side, 0.4 % with 1040); and only with this A(∞) do A(∞) and K together give back the
/// solver's A(ω), so that time and frequency domain agree.
struct ConsistentLimit {
  Mat6 addedMassInf = Mat6::Zero();  ///< symmetric [kg, kg·m, kg·m²]
  /// Largest |value at one ω − mean| over √(A_jj A_kk), all pairs: small if A, B and the tail
  /// belong together.
  double scatter = 0.0;
  /// The same distance of the ω = ∞ solution from the mean.
  double distance = 0.0;
  /// Scatter below 2 % and distance below 10 %: the data reach far enough, nothing is badly wrong.
  bool trusted = false;
};

/// Mean of `value` over the frequencies of that band; nothing if it holds none.
std::optional<Mat6> meanOverBand(const Coefficients& coefficients,
                                 const std::function<Mat6(std::size_t frequency)>& value);

/// @throws HydroError as RetardationMatrix.
ConsistentLimit consistentLimit(const Coefficients& coefficients);

/// The same coefficients with the consistent A(∞) as `addedMassInf` and the solver's own kept as
/// `addedMassInfDirect`, if it is to be trusted; else unchanged. Above `resolvedOmega` = Ω', where the solver's
/// A and B ring, they become the memory's continuation: B by its tail, A = A(∞) − (1/ω)∫K sin ωτ dτ, and ∂A, ∂B
/// alike, with a consistent ∂A(∞). ∂A does so earlier: from 0.5 Ω' to 0.8 Ω' it goes over from the
/// solver's to ∂A(∞) − (1/ω)∫∂K sin ωτ dτ of ∂B, which there is the better value: of the frigate's 18 entries
/// with 433 and 1040 panels a side, set against 2000, it is the nearer in 12 and 11 from 0.5 to 0.6 Ω', in 12 and 13
/// to 0.8 Ω', in 14 and 14 from there on, where the solver misses 4.8 and 1.5 % of ∂A_33 and ∂B's 3.1 and 0.7 %,
/// of ∂A_35 18 and 6, against 11 and 2 %. Below 0.5 Ω' neither is (6 and 10). Of A the like is not true.
Coefficients withConsistentLimit(Coefficients coefficients);

/// Largest |X_jk − X_kj| of a table over √(X_jj X_kk) at its largest, which is discretisation error in A and B.
double asymmetry(const OverFrequency<Mat6>& table);

/// What a solver gave, made ready for readers and the time domain: A and B symmetrised (Timman & Newman
/// 1962; what is left of A_jk − A_kj is discretisation error, noted in Provenance::settings), applyMask (IrregularFrequencies.h),
/// then withConsistentLimit, for K must not see a resonance that the mask takes out.
/// @throws HydroError as applyMask and RetardationMatrix.
Coefficients readyForUse(Coefficients solved);

}  // namespace cutwater
