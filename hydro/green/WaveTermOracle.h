#pragma once

namespace cutwater::oracle {

/// Slow and exact forms from which the tables of WaveTerm.cpp are filled; a microsecond or more a
/// call. Notation of WaveTerm.h; R = √(X²+Y²), α = Y/R.

/// Bessel functions of order 0 and 1, first and second kind.
/// THEORY.md, chapter 4.
struct Bessel {
  double J0, J1, Y0, Y1;
};
/// By Bessel's and Struve's integrals, absolute error < 1e-15·(1 + 1/x); of Y1 below x = 0.01 a
/// relative 3e-14. @pre 0 < x ≤ 40.
Bessel bessel(double x);

/// A function of (X, Y) and its derivative by X.
struct Valued {
  double value, slopeX;
};

/// The wave-free part W = −2 ∫₀^∞ e^{−s} (X² + (Y−s)²)^{−1/2} ds of F = W − 2π e^{−Y} Y₀(X), and
/// ∂W/∂X. It follows from the formula of WaveTerm.h by H₀ − Y₀ = (2/π)∫₀^∞ e^{−Xt}(1+t²)^{−1/2} dt.
/// Relative error < 1e-14. @pre X > 0.
Valued waveFree(double X, double Y);

/// What is left of F without its logarithm, S = F + 2 e^{−Y} J₀(X) ln((R+Y)/2), an entire function
/// of (R, α), and the reduced derivative T = (R/X) ∂S/∂X, entire too.
struct Smooth {
  double S, T;
};
/// From the expansion in solid harmonics, with P_n Legendre's polynomials, ψ the digamma function
/// and ∂P_ν/∂ν at n = P_n ln((1+α)/2) + w_n:
///     S = 2 Σ_n (−R)^n/n! [ψ(n+1) P_n(α) − w_n(α)]
/// Terms grow as e^R before they cancel: absolute error of S < 1e-16 e^R, of T < 5e-16 e^R.
/// @pre 0 ≤ R ≤ 10.
Smooth smoothBySeries(double R, double alpha);
/// From waveFree and bessel. Absolute error < 1e-15·(1 + e^{−Y}R/X²). @pre X > 0.
Smooth smoothByIntegrals(double R, double alpha);

}  // namespace cutwater::oracle
