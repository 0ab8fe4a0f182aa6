#pragma once

namespace cutwater {

/// Real part of the deep-water wave term and its gradient, in the dimensionless variables
///   X = K·(horizontal distance) ≥ 0,  Y = −K(z + ζ) ≥ 0,  K = ω²/g.
///   F(X, Y) = 2 PV ∫₀^∞ e^{−kY} J₀(kX)/(k − 1) dk
///   G = −(1/4π)[1/R + 1/R₁ + K F − 2πiK e^{−Y} J₀(X)]
/// ∂F/∂Y = −F − 2/√(X²+Y²). The imaginary part is elementary.
struct WaveTerm {
  double F = 0.0;
  double FX = 0.0;  ///< ∂F/∂X
  double FY = 0.0;  ///< ∂F/∂Y
  double J0 = 0.0;  ///< e^{−Y} J₀(X)
  double J1 = 0.0;  ///< e^{−Y} J₁(X)
};

/// @pre X ≥ 0, Y ≥ 0, X + Y > 0. Absolute error of every member below 1e-6 (stated better in the
/// .cpp).
WaveTerm waveTerm(double X, double Y);

}  // namespace cutwater
