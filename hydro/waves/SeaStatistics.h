#pragma once
#include "hydro/waves/SeaState.h"

namespace cutwater {

/// What the waves of a sea amount to, as they are: Σ over components instead of a spectrum's
/// integral. The ramp is left out.
struct SeaMoments {
  double m0 = 0.0;  ///< Σ a²/2 [m²]
  double m1 = 0.0;  ///< Σ ω a²/2 [m²/s]
  double m2 = 0.0;  ///< Σ ω² a²/2 [m²/s²]

  double significantHeight() const;   ///< 4 √m0 [m]
  double zeroCrossingPeriod() const;  ///< Tz = 2π √(m0/m2) [s]; 0 in calm water
  double meanPeriod() const;          ///< Tm01 = 2π m0/m1 [s]; 0 in calm water
};
/// Of all components at their full height; of a sea that goes over, of both of its seas.
SeaMoments momentsOf(const SeaState& sea);
/// As it has grown at time t [s] (SeaState::growth).
SeaMoments momentsOf(const SeaState& sea, double t);

/// When a sea comes again.
struct RepeatTime {
  double time = 0.0;      ///< [s]; infinite: not up to `searched`
  double searched = 0.0;  ///< [s]
};

/// How alike a sea must be to count as the same: of the correlation below.
inline constexpr double kRepeated = 0.95;

/// The first lag τ at which the correlation of ζ(t) and ζ(t + τ) at one place,
///     R(τ) = Σ a² cos ωτ / Σ a²,
/// has a maximum of kRepeated or more, after it was below 1/2: 2π/ω of one wave, 2π/Δω of waves of
/// equal steps. Waves at random frequencies have R of the order of √(Σ a⁴/2)/Σ a² at long lags, 0.1
/// of 200 waves of Jonswap, and come to 0.95 practically never. Searched up to `longest` seconds,
/// or as far as some seconds of computing go: an hour and a half of a sea of 100 000 waves.
/// Infinite in calm water.
RepeatTime repeatTime(const SeaState& sea, double longest = 86400.0);

}  // namespace cutwater
