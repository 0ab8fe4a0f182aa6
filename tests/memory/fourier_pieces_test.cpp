#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hydro/memory/FourierPieces.h"
#include "hydro/memory/RetardationFunction.h"

namespace cutwater {
namespace {

double legendreP(int n, double s) {
  double p = 1.0, before = 0.0;
  for (int i = 0; i < n; ++i) {
    const double next = ((2.0 * i + 1.0) * s * p - i * before) / (i + 1.0);
    before = p;
    p = next;
  }
  return p;
}

/// ∫ over [−1, 1] by 40 Gauss points: exact for what is a polynomial of degree 79; of e^{iθs},
/// θ ≤ 30, error below 1e-20.
template <class Function>
double gauss(Function f) {
  static const fourier::GaussRule<40> rule;
  double sum = 0.0;
  for (std::size_t g = 0; g < 40; ++g) sum += rule.weight[g] * f(rule.node[g]);
  return sum;
}

// ∫ P_n(s) e^{iθs} ds = 2 iⁿ j_n(θ). Bound: the header's 1e-14, through θ = 1 and 8 where the way
// of computing changes.
TEST(FourierPiecesIdentity, SphericalBesselFunctionsAreTransformsOfLegendrePolynomials) {
  for (double theta : {0.0, 1e-6, 0.3, 0.999, 1.001, 3.0, 7.999, 8.001, 15.0, 30.0}) {
    const auto j = fourier::sphericalBessel8(theta);
    for (int n = 0; n < 8; ++n) {
      const double sign = n % 4 < 2 ? 1.0 : -1.0;
      const double found =
          0.5 * gauss([&](double s) {
            return legendreP(n, s) * (n % 2 == 0 ? std::cos(theta * s) : std::sin(theta * s));
          });
      EXPECT_NEAR(j[static_cast<std::size_t>(n)], sign * found, 1e-14) << n << ' ' << theta;
    }
  }
}

// Bound: 1e-14 of the cell's width, and of the phase cτ's own round-off, 1e-16 · 200.
TEST(FourierPiecesIdentity, CosineWeightsAreTheQuadratureOfTheirCell) {
  const double a = 1.3, b = 1.8;
  for (double tau : {0.0, 0.1, 2.0, 17.0, 130.0}) {
    const auto weights = fourier::cosineWeights(a, b, tau);
    for (int n = 0; n < 8; ++n) {
      const double found = 0.25 * gauss([&](double s) {
                             return legendreP(n, s) * std::cos((1.55 + 0.25 * s) * tau);
                           });
      EXPECT_NEAR(weights[static_cast<std::size_t>(n)], found, 3e-14) << n << ' ' << tau;
    }
  }
}

double remainingError(double step) {
  std::vector<double> omega, damping;
  for (int i = 1; i <= std::lround(30.0 / step); ++i) {
    const double w = i * step;
    omega.push_back(w);
    damping.push_back(w * w * std::exp(-w));
  }
  const RetardationFunction function(omega, damping);
  double error = 0.0;
  for (double tau : {0.0, 0.01, 0.3, 1.0, 4.0, 40.0})
    error = std::max(error, std::abs(function.remaining(tau) - 2.0 / kPi / (1.0 + tau * tau)));
  return error;
}

// B = ω² e^{−ω}: I = (4/π)τ/(1 + τ²)², so E = ∫_τ^∞ I = (2/π)/(1 + τ²). The spline through B/ω,
// not-a-knot at ω = 0, is there in error by h⁴/46 of its fourth derivative, 4: with h = 0.05 by
// 5.4e-7 over the first two cells, of which ∫ dω/ω makes three times that, (2/π) · 1.6e-6.
TEST(RetardationFunctionClosedForm, WhatRemainsOfTheRunningIntegral) {
  EXPECT_LT(remainingError(0.05), 1.0e-6);
}
TEST(RetardationFunctionConvergence, WhatRemainsOfTheRunningIntegralAtFourthOrder) {
  EXPECT_NEAR(std::log2(remainingError(0.2) / remainingError(0.1)), 4.0, 0.3);
}

}  // namespace
}  // namespace cutwater
