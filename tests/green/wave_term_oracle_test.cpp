#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/green/WaveTermOracle.h"

// The slow forms behind the tables, against the standard library, closed forms and each other.
namespace cutwater::oracle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGamma = std::numbers::egamma;

// 1e-15·(1 + 1/x) is promised, of Y₁ below 0.01 a relative 3e-14; besides one rounding of the
// argument, which moves a wave by x·1.1e-16.
TEST(WaveTermOracleVerification, BesselFunctionsOfTheStandardLibrary) {
  for (double x = 1e-3; x <= 40.0; x *= 1.09) {
    const auto exact = static_cast<long double>(x);
    const Bessel b = bessel(x);
    const double promise = 1e-15 * (1.0 + 1.0 / x) + 2e-16 * x;
    EXPECT_NEAR(b.J0, static_cast<double>(std::cyl_bessel_j(0.0L, exact)), promise) << x;
    EXPECT_NEAR(b.J1, static_cast<double>(std::cyl_bessel_j(1.0L, exact)), promise) << x;
    EXPECT_NEAR(b.Y0, static_cast<double>(std::cyl_neumann(0.0L, exact)), promise) << x;
    EXPECT_NEAR(b.Y1, static_cast<double>(std::cyl_neumann(1.0L, exact)),
                promise + (x < 0.01 ? 3e-14 / x : 0.0))
        << x;
  }
}

// J₁Y₀ − J₀Y₁ = 2/(πx), Wronski's determinant: all four together.
TEST(WaveTermOracleIdentity, WronskianOfTheBesselFunctions) {
  for (double x = 0.01; x <= 40.0; x *= 1.3) {
    const Bessel b = bessel(x);
    const double exact = 2.0 / (kPi * x);
    // Errors of 1e-15·(1 + 1/x) of each function times the size of the other, up to 1/x.
    EXPECT_NEAR(b.J1 * b.Y0 - b.J0 * b.Y1, exact, 4e-15 * (1.0 + 1.0 / x)) << x;
  }
}

/// Struve's H₀ and its derivative by the series (2/π) Σ (−1)^n x^{2n+1} / (1·3·…·(2n+1))².
std::pair<double, double> struve(double x) {
  double term = 2.0 / kPi * x, value = 0.0, slope = 0.0;
  for (int n = 0; n < 40; ++n) {
    value += term;
    slope += (2.0 * n + 1.0) * term / x;
    term *= -x * x / ((2.0 * n + 3.0) * (2.0 * n + 3.0));
  }
  return {value, slope};
}

// Both points on the surface: W = −π[H₀(X) − Y₀(X)]. The series' terms grow to e^X/X: 1e-15 of 20
// at X = 5.
TEST(WaveTermOracleClosedForm, StruveAndNeumannFunctionsOnTheSurface) {
  for (double X = 0.02; X < 5.0; X *= 1.2) {
    const auto [H0, slopeH0] = struve(X);
    const Bessel b = bessel(X);
    const Valued w = waveFree(X, 0.0);
    const double round = 4e-14 * (1.0 + 1.0 / X);
    EXPECT_NEAR(w.value, -kPi * (H0 - b.Y0), round) << X;
    EXPECT_NEAR(w.slopeX, -kPi * (slopeH0 + b.Y1), round) << X;
  }
}

// W obeys the free surface's condition as F does: ∂W/∂Y = −W − 2/R; and slopeX is its derivative.
// Differences of fourth order: with h 0.02 of X and of Y at most, h⁴/30 of fifth derivatives,
// 5!·2/R⁶, is 1e-6 of the image's 2/R².
TEST(WaveTermOracleIdentity, WaveFreePartObeysTheSurfaceCondition) {
  for (const double X : {0.4, 1.0, 4.9, 5.1, 20.0})
    for (const double Y : {0.3, 1.0, 6.0, 30.0}) {
      const double R = std::hypot(X, Y), h = 0.02 * std::min({X, Y, 1.0});
      const auto slope = [h](auto f) {
        return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
      };
      const double byX = slope([&](double d) { return waveFree(X + d, Y).value; });
      const double byY = slope([&](double d) { return waveFree(X, Y + d).value; });
      const Valued w = waveFree(X, Y);
      // W holds 2π e^{−Y} Y₀, whose derivatives at X are those of ln X.
      const double left = 1e-6 * (2.0 / (R * R) + std::exp(-Y) / X) + 1e-12;
      EXPECT_NEAR(w.slopeX, byX, left) << X << ' ' << Y;
      EXPECT_NEAR(byY, -w.value - 2.0 / R, left) << X << ' ' << Y;
    }
}

// Far away W is the image and what follows it: −(2/R) Σ n! P_n(α)/Rⁿ, whose next term is 24 P₄/R⁴
// of it.
TEST(WaveTermOracleClosedForm, ImageFarAway) {
  for (const double R : {60.0, 200.0, 1000.0})
    for (const double a : {0.0, 0.3, 0.6}) {
      const double sum =
          1.0 + a / R + (3.0 * a * a - 1.0) / (R * R) + (15.0 * a * a * a - 9.0 * a) / (R * R * R);
      const Valued w = waveFree(R * std::sqrt(1.0 - a * a), R * a);
      EXPECT_NEAR(-0.5 * R * w.value, sum, 24.0 / std::pow(R, 4) + 1e-14) << R << ' ' << a;
    }
}

// Straight below the source R = Y and F = −2 e^{−Y} Ei(Y): S = 2 e^{−Y}(ln Y − Ei(Y)). Absolute
// error 1e-16 e^R is promised; 1e-15 for the subtraction here.
TEST(WaveTermOracleClosedForm, ExponentialIntegralBelowTheSource) {
  for (double Y = 1e-3; Y <= 10.0; Y *= 1.3) {
    const double exact = 2.0 * std::exp(-Y) * (std::log(Y) - std::expint(Y));
    EXPECT_NEAR(smoothBySeries(Y, 1.0).S, exact, 1e-16 * std::exp(Y) + 1e-15) << Y;
  }
}

TEST(WaveTermOracleClosedForm, EulersConstantAtTheImageItself) {
  for (const double alpha : {0.0, 0.4, 1.0}) {
    const Smooth s = smoothBySeries(0.0, alpha);
    EXPECT_DOUBLE_EQ(s.S, -2.0 * kGamma) << alpha;
    EXPECT_TRUE(std::isfinite(s.T)) << alpha;
  }
}

// Two ways that share no formula. The series promise 1e-16 e^R of S and five times that of T, the
// integrals 1e-15·(1 + e^{−Y}R/X²), R/X times that of T; both in the units of a few roundings of
// their summands.
TEST(WaveTermOracleIdentity, SeriesAndIntegralsMeet) {
  for (double R = 0.5; R <= 9.0; R += 0.37)
    for (double alpha = 0.0; alpha < 0.99; alpha += 0.07) {
      const Smooth a = smoothBySeries(R, alpha), b = smoothByIntegrals(R, alpha);
      const double X = R * std::sqrt(1.0 - alpha * alpha), Y = R * alpha;
      const double series = 1e-16 * std::exp(R);
      const double integrals = 4e-15 * (1.0 + std::exp(-Y) * R / (X * X));
      EXPECT_NEAR(a.S, b.S, series + integrals) << R << ' ' << alpha;
      EXPECT_NEAR(a.T, b.T, 5.0 * series + R / X * integrals) << R << ' ' << alpha;
    }
}

// T = (R/X) ∂S/∂X at constant Y, by differences of fourth order: they leave h⁴/30 of a fifth
// derivative, which of R, a part of S, is of order 1/R⁴.
TEST(WaveTermOracleIdentity, ReducedDerivativeIsThatOfTheSmoothPart) {
  constexpr double h = 0.01;
  for (const double X : {0.5, 1.5, 4.0})
    for (const double Y : {0.2, 1.0, 3.0}) {
      const auto S = [Y](double x) {
        const double R = std::hypot(x, Y);
        return smoothBySeries(R, Y / R).S;
      };
      const double R = std::hypot(X, Y);
      const double slope =
          (8.0 * (S(X + h) - S(X - h)) - (S(X + 2 * h) - S(X - 2 * h))) / (12.0 * h);
      EXPECT_NEAR(smoothBySeries(R, Y / R).T, R / X * slope, 1e-8 * R / X * (1.0 + std::pow(R, -4)))
          << X << ' ' << Y;
    }
}

}  // namespace
}  // namespace cutwater::oracle
