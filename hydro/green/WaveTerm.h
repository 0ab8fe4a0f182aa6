#pragma once
#include <cstddef>

namespace cutwater {

/// Real part of the deep-water wave term and its gradient, in the dimensionless variables
///   X = K·(horizontal distance) ≥ 0,  Y = −K(z + ζ) ≥ 0,  K = ω²/g.
///   F(X, Y) = 2 PV ∫₀^∞ e^{−kY} J₀(kX)/(k − 1) dk
///           = −2 e^{−Y} ∫₀^Y e^t (X²+t²)^{−1/2} dt − π e^{−Y}[H₀(X) + Y₀(X)]       [Newman85]
///   G = −(1/4π)[1/R + 1/R₁ + K F − 2πiK e^{−Y} J₀(X)],  outgoing waves for e^{+iωt}
/// In space ∂G/∂x = K (x−ξ)/R_h times the derivative by X, ∂G/∂z = −K times the derivative by Y.
/// ∂F/∂Y = −F − 2/√(X²+Y²), so K ∂F/∂Y carries a second image source, −2/R₁: integrate that part by
/// RankineIntegrals. The imaginary part is elementary; its ∂/∂X is −e^{−Y}J₁, its ∂/∂Y −e^{−Y}J₀.
///
/// Near R = √(X²+Y²) = 0:
///   F  = −2[ln((R+Y)/2) + γ] + O(R ln R)
///   F_X = −2 X/(R(R+Y)) + O(ln R),  F_Y = −2/R + 2[ln((R+Y)/2) + γ] + O(R ln R)
/// The logarithm over a panel is RankinePanel::logarithmInPlane, the rest waveTermRegular.
/// THEORY.md, chapter 4.
struct WaveTerm {
  double F = 0.0;
  double FX = 0.0;  ///< ∂F/∂X
  double FY = 0.0;  ///< ∂F/∂Y
  double J0 = 0.0;  ///< e^{−Y} J₀(X)
  double J1 = 0.0;  ///< e^{−Y} J₁(X)
  double Y0 = 0.0;  ///< e^{−Y} Y₀(X), from X = 2 on; without meaning below
  double Y1 = 0.0;  ///< e^{−Y} Y₁(X), from X = 2 on
};

/// @pre X ≥ 0, Y ≥ 0, X + Y > 0, both below 1e6. Absolute error of every member below 1e-11, plus a
/// relative 1e-15 of FX and FY where these are large. Below Y = 32 far from the origin J0 and J1,
/// then less than 1e-14, are returned as 0. About 0.1 µs; the first call builds tables for 30 ms.
/// Any thread.
WaveTerm waveTerm(double X, double Y);

/// The same at `count` points, member by member; half the time on a processor with AVX2.
/// @param terms  F, FX, J0, J1, Y0, Y1: `count` places each. FY = −F − 2/√(X² + Y²) is left out.
struct WaveTermArrays {
  double *F, *FX, *J0, *J1, *Y0, *Y1;
};
void waveTerms(const double* X, const double* Y, std::size_t count, const WaveTermArrays& terms);

/// F + 2 ln((R+Y)/2), R = √(X²+Y²): F without its singular part. Finite everywhere, −2γ at R = 0.
/// Same error as F. @pre X ≥ 0, Y ≥ 0.
double waveTermRegular(double X, double Y);

}  // namespace cutwater
