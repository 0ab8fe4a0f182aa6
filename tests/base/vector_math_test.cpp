#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/base/SimdMath.h"

// Against the same functions in extended precision. 2⁻⁵³ = 1.1e-16 is half a unit in the last
// place.
namespace cutwater {
namespace {

constexpr double kError = 2e-16;

CUTWATER_VECTOR void exponentials(double* x, double* result) {
  store4(result, exponential(load4(x)));
}
CUTWATER_VECTOR void logarithms(double* x, double* result) { store4(result, logarithm(load4(x))); }
CUTWATER_VECTOR void sineCosines(double* x, double* sine, double* cosine) {
  const auto [s, c] = sineCosine(load4(x));
  store4(sine, s);
  store4(cosine, c);
}

/// Calls check(x, place) for numbers four at a time, evenly between.
void forNumbers(double from, double to, const auto& check) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(from, to);
  for (int i = 0; i < 20000; ++i) {
    double x[4] = {between(random), between(random), between(random), between(random)};
    check(x);
  }
}

TEST(VectorMathClosedForm, Exponential) {
  for (const double range : {1.0, 30.0, 700.0})
    forNumbers(-range, range, [](double* x) {
      double y[4];
      exponentials(x, y);
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(static_cast<double>(y[i] / std::exp(static_cast<long double>(x[i])) - 1.0L),
                    0.0, kError)
            << x[i];
    });
}

TEST(VectorMathClosedForm, Logarithm) {
  for (const double range : {1.0, 30.0, 700.0})
    forNumbers(-range, range, [](double* x) {
      for (int i = 0; i < 4; ++i) x[i] = std::exp(x[i]);
      double y[4];
      logarithms(x, y);
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(static_cast<double>(y[i] / std::log(static_cast<long double>(x[i])) - 1.0L),
                    0.0, kError)
            << x[i];
    });
  double one[4] = {1.0, 1.0, 0.5, 2.0}, y[4];
  logarithms(one, y);
  EXPECT_EQ(y[0], 0.0);
  EXPECT_EQ(y[2], -y[3]);
}

TEST(VectorMathClosedForm, SineAndCosine) {
  for (const double range : {1.0, 100.0, 1e6})
    forNumbers(-range, range, [](double* x) {
      double s[4], c[4];
      sineCosines(x, s, c);
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(static_cast<double>(s[i] - std::sin(static_cast<long double>(x[i]))), 0.0,
                    kError)
            << x[i];
        EXPECT_NEAR(static_cast<double>(c[i] - std::cos(static_cast<long double>(x[i]))), 0.0,
                    kError)
            << x[i];
      }
    });
}

}  // namespace
}  // namespace cutwater
