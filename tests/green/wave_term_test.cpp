#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "hydro/green/WaveTerm.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

constexpr double kPi = std::numbers::pi;

// What the header promises, absolute.
constexpr double kPromise = 1e-11;

struct Point {
  double X, Y;
};

// R from 1e-3 to 1e3, evenly in its logarithm; every third point close to the vertical axis.
std::vector<Point> randomPoints(int count, double from = 1e-3, double to = 1e3) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double R = from * std::pow(to / from, uniform(random));
    const double alpha = i % 3 == 0 ? 1.0 - 1e-3 * uniform(random) : uniform(random);
    points.push_back({R * std::sqrt(1.0 - alpha * alpha), R * alpha});
  }
  return points;
}

// Double-exponential rule on eight equal pieces of [a, b], in extended precision.
template <class Function>
long double integrate(long double a, long double b, Function f) {
  constexpr long double pi = std::numbers::pi_v<long double>, step = 1.0L / 12.0L;
  const long double length = (b - a) / 8;
  long double sum = 0.0L;
  for (int piece = 0; piece < 8; ++piece) {
    for (int k = -42; k <= 42; ++k) {
      const long double t = static_cast<long double>(k) * step;
      const long double q = std::exp(pi * std::sinh(t));
      const long double weight = pi * std::cosh(t) * q / ((1.0L + q) * (1.0L + q));
      sum += step * length * weight * f(a + length * (piece + q / (1.0L + q)));
    }
  }
  return sum;
}

// F and ∂F/∂X straight from the second formula of WaveTerm.h, with t = X sinh u and Struve's
// integral. Shares neither formula nor code with the library's own oracle.
struct Slow {
  double F, FX;
};
Slow byDefinition(double x, double y) {
  const long double X = x, Y = y, pi = std::numbers::pi_v<long double>;
  long double F = 0.0L, FX = 0.0L;
  const auto decay = [&](long double u) { return std::exp(X * std::sinh(u) - Y); };
  const long double top = std::asinh(Y / X);
  F -= 2.0L * integrate(0.0L, top, decay);
  FX += 2.0L / X * integrate(0.0L, top, [&](long double u) {
          return decay(u) / (std::cosh(u) * std::cosh(u));
        });
  const long double H0 =
      2.0L / pi * integrate(0.0L, pi / 2, [&](long double v) { return std::sin(X * std::cos(v)); });
  const long double dH0 = 2.0L / pi * integrate(0.0L, pi / 2, [&](long double v) {
                            return std::cos(X * std::cos(v)) * std::cos(v);
                          });
  F -= pi * std::exp(-Y) * (H0 + std::cyl_neumann(0.0L, X));
  FX -= pi * std::exp(-Y) * (dH0 - std::cyl_neumann(1.0L, X));
  return {static_cast<double>(F), static_cast<double>(FX)};
}

double distance(const Point& p) { return std::hypot(p.X, p.Y); }

// Values computed with 30 digits by another program. The acceptance is 1e-6 absolute, also where
// ∂F/∂X is 2000; what is promised is tested: absolute 1e-11, besides 1e-15 of the value for one
// rounding.
TEST(WaveTermVerification, ReferenceTableIsMetAtEveryPoint) {
  const test::CsvTable table("green/green_infinite_depth.csv");
  ASSERT_EQ(table.rows(), 367u);
  const char* const columns[] = {"F", "FX", "FY", "FHF", "IM", "IMX"};
  double worst[6] = {};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Point p{table.number(row, "X"), table.number(row, "Y")};
    const WaveTerm w = waveTerm(p.X, p.Y);
    const double reached[] = {
        w.F, w.FX, w.FY, w.F + 2.0 / distance(p), 2.0 * kPi * w.J0, -2.0 * kPi * w.J1};
    for (std::size_t i = 0; i < 6; ++i) {
      const double expected = table.number(row, columns[i]);
      worst[i] = std::max(worst[i], std::abs(reached[i] - expected));
      EXPECT_NEAR(reached[i], expected, kPromise + 2e-15 * std::abs(expected))
          << columns[i] << " at X " << p.X << ", Y " << p.Y;
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    test::recordResult("green",
                       std::string("wave term, 367 points, absolute error of ") + columns[i],
                       "green_infinite_depth.csv", worst[i], "1e-6");
  }
}

TEST(WaveTermVerification, DefinitionHoldsInEveryRegion) {
  double worst = 0.0;
  for (const Point& p : randomPoints(test::fullSize() ? 6000 : 400, 1e-3, 200.0)) {
    const Slow slow = byDefinition(p.X, p.Y);
    const WaveTerm w = waveTerm(p.X, p.Y);
    worst = std::max(worst, std::abs(w.F - slow.F));
    // cyl_neumann in extended precision and the integrals err by less than 1e-14 here.
    EXPECT_NEAR(w.F, slow.F, kPromise) << p.X << ' ' << p.Y;
    EXPECT_NEAR(w.FX, slow.FX, kPromise + 2e-15 * std::abs(slow.FX)) << p.X << ' ' << p.Y;
  }
  test::recordResult("green", "wave term, random points in every region, absolute error of F",
                     "quadrature of the definition", worst, "1e-11");
}

// On the free surface −∂G/∂z + K G = 0: with K = 1 that is F_Y + F + 2/R = 0, and F_Y must be the
// derivative of F. The imaginary part obeys it by its factor e^{−Y}.
TEST(WaveTermIdentity, FreeSurfaceConditionHolds) {
  for (const Point& p : randomPoints(2000, 0.5)) {
    if (p.Y < 0.1) continue;
    const WaveTerm w = waveTerm(p.X, p.Y);
    EXPECT_NEAR(w.FY + w.F + 2.0 / distance(p), 0.0, 4e-15 * (1.0 + std::abs(w.F)));
    const double h = 0.01 * std::min(1.0, distance(p));
    const auto F = [&](double step) { return waveTerm(p.X, p.Y + step * h).F; };
    const double slope = (8.0 * (F(1) - F(-1)) - (F(2) - F(-2))) / (12.0 * h);
    // Truncation h⁴/30 ∂⁵F, ∂⁵F ~ 2·4!/R⁵ + 2π; error of F 2·1e-12/h.
    EXPECT_NEAR(w.FY, slope, 1e-8 * (2.0 / distance(p) + 1.0)) << p.X << ' ' << p.Y;
  }
}

TEST(WaveTermIdentity, WaveTermIsHarmonic) {
  for (const Point& p : randomPoints(2000, 0.5)) {
    const double h = 0.01 * std::min(1.0, distance(p));
    if (p.X < 5.0 * h || p.Y < 5.0 * h) continue;
    const auto along = [&](double dX, double dY) { return waveTerm(p.X + dX * h, p.Y + dY * h); };
    const double FXX =
        (8.0 * (along(1, 0).FX - along(-1, 0).FX) - (along(2, 0).FX - along(-2, 0).FX)) / (12 * h);
    const double FYY =
        (8.0 * (along(0, 1).FY - along(0, -1).FY) - (along(0, 2).FY - along(0, -2).FY)) / (12 * h);
    const double R = distance(p);
    // Truncation h⁴/30 of fifth derivatives of the gradient, 2·5!/R⁶ + 2π, with h ≤ 0.01 R.
    EXPECT_NEAR(FXX + waveTerm(p.X, p.Y).FX / p.X + FYY, 0.0, 2e-8 * (1.0 + 10.0 / (R * R)))
        << p.X << ' ' << p.Y;
  }
}

// Either side of every kind of border between tables.
TEST(WaveTermIdentity, BordersOfTheRegionsDoNotShow) {
  std::vector<std::pair<Point, Point>> pairs;
  const double below = 1.0 - 1e-14, above = 1.0 + 1e-14;
  const auto addPolar = [&](double R, double alpha, double dR, double dAlpha) {
    const auto at = [](double r, double a) { return Point{r * std::sqrt(1 - a * a), r * a}; };
    pairs.push_back({at(R * below, alpha * (1.0 - dAlpha)), at(R * (1.0 + dR), alpha * above)});
  };
  for (int i = 1; i < 100; ++i) {
    const double t = 0.01 * i;
    for (const double R : {1.0, 4.0, 7.0, 8.0, 9.0, 12.0, 24.0, 36.0, 72.0}) {
      addPolar(R, t, 1e-14, 0.0);
    }
    for (const double alpha : {0.125, 0.5, 0.75, 0.875}) addPolar(50.0 * t, alpha, 0.0, 1e-14);
    pairs.push_back({{36.0 * below, 40.0 * t}, {36.0 * above, 40.0 * t}});
    pairs.push_back({{100.0 * t, 32.0 * below}, {100.0 * t, 32.0 * above}});
  }
  for (const auto& [p, q] : pairs) {
    const WaveTerm a = waveTerm(p.X, p.Y), b = waveTerm(q.X, q.Y);
    // The step, 3e-14 R, times the slopes: 1 of the waves, 2/R and 4/R² of the image.
    const double R = distance(p), step = 3e-14 * R;
    EXPECT_NEAR(a.F, b.F, kPromise + step * (6.0 + 2.0 / R)) << p.X << ' ' << p.Y;
    EXPECT_NEAR(a.FX, b.FX, kPromise + step * (6.0 + 4.0 / (R * R))) << p.X << ' ' << p.Y;
    // The waves left out at Y = 32 are e^{−32} = 1.3e-14.
    EXPECT_NEAR(a.J0, b.J0, 2e-14 + step) << p.X << ' ' << p.Y;
    EXPECT_NEAR(a.J1, b.J1, 2e-14 + step) << p.X << ' ' << p.Y;
  }
}

TEST(WaveTermVerification, BesselFunctionsAgreeWithTheStandardLibrary) {
  for (double X = 0.0; X < 1000.0; X += X < 50.0 ? 0.0371 : 3.77) {
    const WaveTerm w = waveTerm(X, X == 0.0 ? 1e-300 : 0.0);
    const auto exact = static_cast<long double>(X);
    // 1e-14: truncation of table and expansion; the rest is the rounding of X in its sine.
    EXPECT_NEAR(w.J0, static_cast<double>(std::cyl_bessel_j(0.0L, exact)), 1e-14) << X;
    EXPECT_NEAR(w.J1, static_cast<double>(std::cyl_bessel_j(1.0L, exact)), 1e-14) << X;
  }
}

// Straight below the source F = −2 e^{−Y} Ei(Y), and by symmetry F_X = 0.
TEST(WaveTermClosedForm, ExponentialIntegralOnTheVerticalAxis) {
  for (double Y = 1e-6; Y < 500.0; Y *= 1.07) {
    const WaveTerm w = waveTerm(0.0, Y);
    EXPECT_NEAR(w.F, -2.0 * std::exp(-Y) * std::expint(Y), kPromise) << Y;
    EXPECT_NEAR(w.FX, 0.0, kPromise) << Y;
    EXPECT_NEAR(w.J0, std::exp(-Y), 2e-14) << Y;
  }
}

// Both points on the free surface, far apart: −π[H₀ + Y₀] = −2π Y₀ − 2[1/X − 1/X³ + 9/X⁵ − …].
TEST(WaveTermClosedForm, CylindricalWavesOnTheFreeSurface) {
  for (double X = 150.0; X < 1e4; X *= 1.31) {
    const double steady = -2.0 / X * (1.0 - 1.0 / (X * X) + 9.0 / std::pow(X, 4));
    const double waves = -2.0 * kPi * static_cast<double>(std::cyl_neumann(0.0L, (long double)X));
    const double slope = 2.0 * kPi * static_cast<double>(std::cyl_neumann(1.0L, (long double)X));
    const WaveTerm w = waveTerm(X, 0.0);
    EXPECT_NEAR(w.F, waves + steady, kPromise) << X;  // next term 450/X⁷ < 3e-13
    EXPECT_NEAR(w.FX, slope + 2.0 / (X * X) * (1.0 - 3.0 / (X * X)), 5e-9 * 90.0 / X) << X;
  }
}

// Deep below, or at high frequency, G becomes 1/R − 1/R₁: F → −(2/R) Σ n! P_n(α)/Rⁿ.
TEST(WaveTermClosedForm, ImageSourceFarBelowTheSurface) {
  for (const double R : {1e3, 1e4, 1e6}) {
    for (double alpha = 0.05; alpha < 1.0; alpha += 0.05) {
      const double P2 = 1.5 * alpha * alpha - 0.5;
      const double expected = -2.0 / R * (1.0 + alpha / R + 2.0 * P2 / (R * R));
      const WaveTerm w = waveTerm(R * std::sqrt(1.0 - alpha * alpha), R * alpha);
      EXPECT_NEAR(w.F, expected, kPromise + 12.0 / (R * R * R * R)) << R << ' ' << alpha;
    }
  }
}

TEST(WaveTermClosedForm, LogarithmNearTheSource) {
  for (const double alpha : {0.0, 0.1, 0.7, 0.99, 1.0}) {
    for (const double R : {1e-4, 1e-7, 1e-12}) {
      const double Y = R * alpha, X = R * std::sqrt(1.0 - alpha * alpha);
      const double logarithm = std::log(0.5 * (R + Y)) + std::numbers::egamma;
      const double next = 4.0 * R * std::abs(std::log(R));  // the order of what is left out
      const WaveTerm w = waveTerm(X, Y);
      EXPECT_NEAR(w.F, -2.0 * logarithm, next);
      EXPECT_NEAR(w.FX, -2.0 * X / (R * (R + Y)), 4.0 * std::abs(std::log(R)));
      EXPECT_NEAR(w.FY, -2.0 / R + 2.0 * logarithm, next + 1e-15 / R);
      EXPECT_NEAR(waveTermRegular(X, Y), -2.0 * std::numbers::egamma, next + kPromise);
    }
  }
  EXPECT_EQ(waveTermRegular(0.0, 0.0), -2.0 * std::numbers::egamma);
}

// With e^{+iωt} waves leave as e^{i(ωt − X)}: F − 2πi e^{−Y} J₀ → −2πi e^{−Y} H₀⁽²⁾(X).
TEST(WaveTermIdentity, WavesTravelOutwards) {
  const auto complexWave = [](double X, double Y) {
    const WaveTerm w = waveTerm(X, Y);
    return std::complex<double>(w.F + 2.0 / std::hypot(X, Y), -2.0 * kPi * w.J0);
  };
  for (const double Y : {0.0, 0.5, 2.0}) {
    const double X = 400.0, step = 1.0;
    const auto ratio = complexWave(X + step, Y) / complexWave(X, Y);
    // The amplitude falls as √X, 1/800; the image's next term, Y/R² against e^{−Y}√(8π/X), is 4e-4.
    EXPECT_NEAR(std::abs(ratio * std::polar(1.0, step) - 1.0), 0.0, 2e-3) << Y;
  }
}

}  // namespace
}  // namespace cutwater
