#pragma once
#include <span>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Memory of the radiated waves: a velocity of mode k at time t−τ still forces mode j at t by −K(τ).
///     K(τ) = (2/π) ∫₀^∞ B(ω) cos ωτ dω                          [M03] (34), [Cummins 1962]
class RetardationFunction {
 public:
  /// @param omega    ω [rad/s], shape (n ≥ 2), strictly increasing, > 0; B(0) = 0 is added.
  /// @param damping  B(ω) of one (j, k), shape (n).
  RetardationFunction(std::span<const double> omega, std::span<const double> damping);
  double operator()(double tau) const noexcept;      ///< K(τ), τ ≥ 0
  double integral(double tau) const noexcept;        ///< ∫₀^τ K
  double sineTransform(double omega) const noexcept; ///< ∫₀^∞ K sin ωτ dτ
};

/// All 36 functions of a ship.
class RetardationMatrix {
 public:
  explicit RetardationMatrix(const Coefficients& coefficients);
  Mat6 at(double tau) const;        ///< K(τ)
  Mat6 integral(double tau) const;  ///< ∫₀^τ K dτ
  double duration() const noexcept; ///< [s] beyond which K is negligible
};

}  // namespace cutwater
