#pragma once
#include <array>
#include <span>
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// One retardation function K(τ): a velocity of mode k at time t − τ causes the force −K(τ) in mode
/// j at time t.
///     K(τ) = (2/π) ∫₀^∞ B(ω) cos ωτ dω                          [M03] (34), [Cummins 1962]
/// B(ω)/ω is a cubic spline through 0 at ω = 0 and the given points (between 0 and the first point
/// kept monotone, so a positive B stays positive), hence B is piecewise quartic and its transform
/// is known in closed form for every τ: no sampling in ω, no aliasing.
///
/// Beyond the last frequency Ω the data are continued with value and slope by a tail that vanishes
/// at ∞: B(Ω) uⁿ [1 + c(1 − u) + d(1 − u)²], u = Ω/ω. n ≥ 3, the law of a wall-sided hull's waves,
/// and c come from the slope of log B over [0.7 Ω, Ω]; where that is noise (B changes sign), u⁸.
/// d = 0, but for couplings that would outlast the modes they couple (RetardationMatrix.h).
///
/// Since B vanishes at both ends ∫₀^∞ K dτ = 0, and A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ for every ω
/// [Ogilvie 1964]. Immutable, any thread may read it. Each call costs O(n), about 10 µs at n = 60.
/// THEORY.md, chapter 7.
class RetardationFunction {
 public:
  /// @param omega    ω [rad/s], shape (n ≥ 2), strictly increasing, > 0; B(0) = 0 is added.
  /// @param damping  B(ω) of one (j, k) [unit of force j per unit of velocity k], shape (n).
  /// @throws HydroError BadArgument (sizes), FrequenciesNotIncreasing, ValueOutOfRange (not
  ///        finite).
  RetardationFunction(std::span<const double> omega, std::span<const double> damping);

  double operator()(double tau) const noexcept;  ///< K(τ) [unit of B / s], τ ≥ 0
  double integral(double tau) const noexcept;    ///< I(τ) = ∫₀^τ K [unit of B]; 0 at ∞
  /// E(τ) = ∫_τ^∞ I ds = (2/π)∫ B/ω² cos ωτ dω [unit of B · s]. B/ω² is taken by polynomials of
  /// degree 7 on each cell: exact in the first, to 1e-6 in the second, to round-off beyond.
  double remaining(double tau) const noexcept;
  /// ∫₀^∞ K sin ωτ dτ [unit of B] = (2/π) P∫₀^∞ B(x) ω/(ω² − x²) dx, ω > 0 [rad/s].
  double sineTransform(double omega) const noexcept;
  double damping(double omega) const noexcept;  ///< the interpolated and continued B(ω), ω ≥ 0

 private:
  friend class RetardationMatrix;
  struct Piece {
    std::array<double, 5> b;  // Legendre coefficients of B over the cell
    std::array<double, 4> q;  // and of B/ω
    std::array<double, 8> r;  // and of B/ω²
  };
  void fitTail(std::span<const double> damping);
  void fitPieces(std::span<const double> damping);
  double dampingInCell(std::size_t cell, double omega) const noexcept;
  double dampingInTail(double omega) const noexcept;
  using TailTable = std::array<Complex, 14>;  // fourier::TailTable
  /// ∫₁^∞ of the tail over t = ω/Ω, times t^{−extraPower} e^{iΩτt}.
  Complex tailTransform(const TailTable& table, int extraPower) const noexcept;

  std::vector<double> nodes_;  // 0, ω_1 … ω_n = Ω
  std::vector<Piece> pieces_;
  double tailValue_ = 0.0;  // B(Ω)
  double tailMix_ = 0.0;    // c
  double tailBend_ = 0.0;   // d
  int tailPower_ = 3;       // n
};

}  // namespace cutwater
