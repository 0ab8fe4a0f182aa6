#pragma once
#include <array>

#include "hydro/Conventions.h"

/// Integrals that make up the retardation functions.
namespace cutwater::fourier {

/// Transforms of one cell of a piecewise polynomial, exact for every τ ≥ 0 (Filon's idea; with
/// Legendre polynomials nothing cancels, neither for small nor for large τ):
///     ∫ P_n(s) e^{iωτ} dω = (b − a) iⁿ j_n(θ) e^{icτ},  ω = c + Hs on [a, b], θ = Hτ
/// with the spherical Bessel functions j_n [DLMF 18.17.19].
/// THEORY.md, chapter 7.
struct CellWeights {
  std::array<double, 5> cosine;  ///< ∫ P_n cos ωτ dω, n = 0..4 [rad/s]
  std::array<double, 4> sine;    ///< ∫ P_n sin ωτ dω, n = 0..3 [rad/s]
};
CellWeights cellWeights(double a, double b, double tau) noexcept;

/// ∫ P_n cos ωτ dω for n = 0..7, for what is smooth but no polynomial (B/ω²) [rad/s].
std::array<double, 8> cosineWeights(double a, double b, double tau) noexcept;

/// j_0..j_4 at θ ≥ 0, absolute error below 1e-14.
std::array<double, 5> sphericalBessel(double theta) noexcept;
/// j_0..j_7 likewise.
std::array<double, 8> sphericalBessel8(double theta) noexcept;

inline constexpr int kLeastPower = 3;      ///< slowest decay of a tail, (Ω/ω)³
inline constexpr int kGreatestPower = 12;  ///< steepest

/// E_n(−ia) = ∫₁^∞ t^{−n} e^{iat} dt for n = kLeastPower .. kGreatestPower + 4, a ≥ 0: transforms
/// of power-law tails [DLMF 8.19]. Absolute error below 1e-12.
using TailTable = std::array<Complex, kGreatestPower + 5 - kLeastPower>;
TailTable tailIntegrals(double a) noexcept;

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// Nodes and weights of Gauss-Legendre quadrature on [−1, 1].
template <int N>
struct GaussRule {
  std::array<double, N> node, weight;
  GaussRule() noexcept;
};
extern template struct GaussRule<8>;
extern template struct GaussRule<40>;

}  // namespace cutwater::fourier
