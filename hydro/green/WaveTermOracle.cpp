#include "hydro/green/WaveTermOracle.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "hydro/Conventions.h"

namespace cutwater::oracle {
namespace {

constexpr int kGauss = 16;

struct GaussRule {
  std::array<double, kGauss> point{}, weight{};  // on [−1, 1]
};

// Newton's iteration on the Legendre polynomial, from Tricomi's estimate of its zeros.
GaussRule makeGaussRule() {
  GaussRule rule;
  for (int i = 0; i < kGauss; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (kGauss + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double previous = 1.0, p = x;
      for (int n = 1; n < kGauss; ++n) {
        const double next = ((2 * n + 1) * x * p - n * previous) / (n + 1);
        previous = p;
        p = next;
      }
      slope = kGauss * (x * p - previous) / (x * x - 1.0);
      x -= p / slope;
    }
    const auto k = static_cast<std::size_t>(i);
    rule.point[k] = x;
    rule.weight[k] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

// Calls f(point, weight) at the Gauss points of [a, b].
template <class Function>
void gauss(double a, double b, Function f) {
  static const GaussRule rule = makeGaussRule();
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b);
  for (std::size_t i = 0; i < kGauss; ++i) {
    f(middle + half * rule.point[i], half * rule.weight[i]);
  }
}

// Pieces of the decay e^{−s}: beyond 40 it is below the round-off of what precedes.
constexpr std::array<double, 7> kDecay = {0.0, 1.0, 3.0, 7.0, 14.0, 24.0, 40.0};

}  // namespace

Bessel bessel(double x) {
  Bessel b{};
  // J_0 = (2/π)∫₀^{π/2} cos(x sin θ) dθ, J_1 = (2/π)∫₀^{π/2} sin θ sin(x sin θ) dθ: the midpoint
  // rule with N points errs by J_{4N}(x).
  constexpr int kPoints = 25;
  for (int i = 0; i < kPoints; ++i) {
    const double s = std::sin(0.5 * kPi * (i + 0.5) / kPoints);
    b.J0 += std::cos(x * s) / kPoints;
    b.J1 += s * std::sin(x * s) / kPoints;
  }
  // Struve's H₀ = (2/π)∫₀^{π/2} sin(x cos θ) dθ; Y₀ = H₀ − (2/π)∫₀^∞ e^{−x sinh u} du, Y₁ = −Y₀'.
  constexpr int kPieces = 4;
  for (int i = 0; i < kPieces; ++i) {
    gauss(0.5 * kPi * i / kPieces, 0.5 * kPi * (i + 1) / kPieces, [&](double angle, double weight) {
      const double c = std::cos(angle);
      b.Y0 += 2.0 / kPi * weight * std::sin(x * c);
      b.Y1 -= 2.0 / kPi * weight * std::cos(x * c) * c;
    });
  }
  for (std::size_t i = 0; i + 1 < kDecay.size(); ++i) {
    gauss(std::asinh(kDecay[i] / x), std::asinh(kDecay[i + 1] / x), [&](double u, double weight) {
      const double rise = std::sinh(u), decay = 2.0 / kPi * weight * std::exp(-x * rise);
      b.Y0 -= decay;
      b.Y1 -= decay * rise;
    });
  }
  return b;
}

Valued waveFree(double X, double Y) {
  Valued w{0.0, 0.0};
  const auto add = [&](double s, double weight) {  // weight carries ds
    const double d2 = X * X + (Y - s) * (Y - s);
    const double term = 2.0 * weight * std::exp(-s) / std::sqrt(d2);
    w.value -= term;
    w.slopeX += term * X / d2;
  };
  for (std::size_t i = 0; i + 1 < kDecay.size(); ++i) {
    if (X > 5.0) {  // the singularity s = Y ± iX is far from the path
      gauss(kDecay[i], kDecay[i + 1], add);
      continue;
    }
    // Y − s = X sinh u makes the integrand entire and that of the slope e^{−s}/cosh² u, with poles
    // at ±iπ/2: pieces no longer than 2 keep them at a distance.
    const double from = std::asinh((Y - kDecay[i + 1]) / X), to = std::asinh((Y - kDecay[i]) / X);
    const int pieces = 1 + static_cast<int>(0.5 * (to - from));
    const double length = (to - from) / pieces;
    for (int piece = 0; piece < pieces; ++piece) {
      gauss(from + piece * length, from + (piece + 1) * length, [&](double u, double weight) {
        const double rise = std::sinh(u);
        add(Y - X * rise, weight * X * std::sqrt(1.0 + rise * rise));
      });
    }
  }
  return w;
}

Smooth smoothBySeries(double R, double alpha) {
  // P_n, w_n and their derivatives by α, from (n+1)P_{n+1} = (2n+1)αP_n − nP_{n−1} and its
  // derivative by n: (n+1)w_{n+1} = (2n+1)αw_n − nw_{n−1} + 2αP_n − P_{n+1} − P_{n−1}, with
  // P_{−1} = 1, w_0 = 0.
  double pBefore = 1.0, p = 1.0, dpBefore = 0.0, dp = 0.0;
  double wBefore = 0.0, w = 0.0, dwBefore = 0.0, dw = 0.0;
  double digamma = -std::numbers::egamma;
  double power = 1.0;        // (−R)^n/n!
  double powerBefore = 0.0;  // (−1)^n R^{n−1}/n!
  Smooth sum{0.0, 0.0};
  for (int n = 0; n < 70; ++n) {
    const double q = digamma * p - w, dq = digamma * dp - dw;
    sum.S += 2.0 * power * q;
    sum.T += 2.0 * powerBefore * (n * q - alpha * dq);
    const double m = n + 1.0;
    const double pNext = ((n + m) * alpha * p - n * pBefore) / m;
    const double dpNext = ((n + m) * (p + alpha * dp) - n * dpBefore) / m;
    const double wNext =
        ((n + m) * alpha * w - n * wBefore + 2.0 * alpha * p - pNext - pBefore) / m;
    const double dwNext =
        ((n + m) * (w + alpha * dw) - n * dwBefore + 2.0 * (p + alpha * dp) - dpNext - dpBefore) /
        m;
    pBefore = std::exchange(p, pNext);
    dpBefore = std::exchange(dp, dpNext);
    wBefore = std::exchange(w, wNext);
    dwBefore = std::exchange(dw, dwNext);
    digamma += 1.0 / m;
    powerBefore = -power / m;
    power *= -R / m;
  }
  return sum;
}

Smooth smoothByIntegrals(double R, double alpha) {
  const double Y = R * alpha, X = R * std::sqrt((1.0 - alpha) * (1.0 + alpha));
  const double E = std::exp(-Y), L = std::log(0.5 * (R + Y));
  const Bessel b = bessel(X);
  const Valued w = waveFree(X, Y);
  const double S = w.value - 2.0 * kPi * E * b.Y0 + 2.0 * E * b.J0 * L;
  const double slope =
      w.slopeX + 2.0 * kPi * E * b.Y1 - 2.0 * E * b.J1 * L + 2.0 * E * b.J0 * X / (R * (R + Y));
  return {S, R * slope / X};
}

}  // namespace cutwater::oracle
