#pragma once
#include <array>
#include <span>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater {

/// Memory of the radiated waves: a velocity of mode k at time t−τ still forces mode j at t by
/// −K(τ).
///     K(τ) = (2/π) ∫₀^∞ B(ω) cos ωτ dω                          [M03] (34), [Cummins 1962]
/// B(ω)/ω is a cubic spline through 0 at ω = 0 and the given points (between 0 and the first point
/// kept monotone, so a positive B stays positive), hence B is piecewise quartic and its transform
/// is exact in closed form for every τ: no sampling in ω, no aliasing.
///
/// Beyond the last frequency Ω the data are continued with value and slope by a tail that always
/// dies: B(Ω)[(1 + c)uⁿ − c uⁿ⁺¹], u = Ω/ω. n ≥ 3, the law of a wall-sided hull's waves, and c come
/// from the slope of log B over [0.7 Ω, Ω]; where that is noise (B changes sign), u⁸.
///
/// Since B vanishes at both ends ∫₀^∞ K dτ = 0, and A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ for every ω
/// [Ogilvie 1964]. Immutable, any thread may read it. Each call costs O(n), about 10 µs at n = 60.
class RetardationFunction {
 public:
  /// @param omega    ω [rad/s], shape (n ≥ 2), strictly increasing, > 0; B(0) = 0 is added.
  /// @param damping  B(ω) of one (j, k) [unit of force j per unit of velocity k], shape (n).
  /// @throws HydroError BadArgument (sizes), FrequenciesNotIncreasing, ValueOutOfRange (not
  /// finite).
  RetardationFunction(std::span<const double> omega, std::span<const double> damping);

  double operator()(double tau) const noexcept;  ///< K(τ) [unit of B / s], τ ≥ 0
  double integral(double tau) const noexcept;    ///< ∫₀^τ K [unit of B]; 0 at ∞
  /// ∫₀^∞ K sin ωτ dτ [unit of B] = (2/π) P∫₀^∞ B(x) ω/(ω² − x²) dx, ω > 0 [rad/s].
  double sineTransform(double omega) const noexcept;
  double damping(double omega) const noexcept;  ///< the interpolated and continued B(ω), ω ≥ 0

 private:
  friend class RetardationMatrix;
  struct Piece {
    std::array<double, 5> b;  // Legendre coefficients of B over the cell
    std::array<double, 4> q;  // and of B/ω
  };
  void fitTail(std::span<const double> damping);
  void fitPieces(std::span<const double> damping);
  double dampingInCell(std::size_t cell, double omega) const noexcept;
  double dampingInTail(double omega) const noexcept;
  using TailTable = std::array<Complex, 12>;  // fourier::TailTable
  /// ∫₁^∞ of the tail over t = ω/Ω, times t^{−extraPower} e^{iΩτt}.
  Complex tailTransform(const TailTable& table, int extraPower) const noexcept;

  std::vector<double> nodes_;  // 0, ω_1 … ω_n = Ω
  std::vector<Piece> pieces_;
  double tailValue_ = 0.0;  // B(Ω)
  double tailMix_ = 0.0;    // c
  int tailPower_ = 3;       // n
};

/// All 36 functions of a ship at U = 0. B is symmetrised first: it is symmetric but for the
/// solver's discretisation error, the mean of B_jk and B_kj is the better value, and a symmetric
/// positive B gives a memory that cannot create energy. Pairs that vanish by symmetry, |B_jk| below
/// 1e-8 of √(B_jj B_kk) at their maxima, are left out. Frequencies above
/// Coefficients::resolvedOmega are left to the tail.
class RetardationMatrix {
 public:
  /// @throws HydroError as RetardationFunction.
  explicit RetardationMatrix(const Coefficients& coefficients);

  Mat6 at(double tau) const;                 ///< K(τ) [unit of B / s]
  Mat6 integral(double tau) const;           ///< ∫₀^τ K dτ [unit of B]
  Mat6 sineTransform(double omega) const;    ///< ∫₀^∞ K sin ωτ dτ [unit of B]
  bool isZero(int j, int k) const noexcept;  ///< the pair is left out; j, k = 0..5

  /// A(∞) = A(ω) + (1/ω)∫₀^∞ K sin ωτ dτ, symmetrised: the same for every ω > 0 if A, B and the
  /// tail are right.   @param addedMass  A at that ω.
  Mat6 addedMassInf(double omega, const Mat6& addedMass) const;

  /// B(ω) as the memory has it: interpolated, and continued beyond the last frequency it uses.
  Mat6 damping(double omega) const;

  /// K at 0, Δτ, 2Δτ, … up to `duration` [s], for the database file.
  /// @throws HydroError ValueOutOfRange unless 0 < step ≤ duration ≤ 10⁶ step.
  ImpulseResponse table(double step, double duration) const;

  /// T [s] beyond which K is negligible: of every pair no more than 0.1 % of ∫|K| lies beyond it,
  /// measured by √(∫|K_jj| ∫|K_kk|). At most π/Δω, Δω the median step of the data, beyond which
  /// they say nothing about K.
  double duration() const noexcept { return duration_; }

 private:
  struct Entry {
    int j, k;  // j ≤ k
    RetardationFunction function;
  };
  double findDuration() const;

  std::vector<Entry> entries_;
  double duration_ = 0.0;
};

}  // namespace cutwater
