#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/waves/VectorSine.h"

namespace cutwater {
namespace {

/// Largest absolute errors of both at four phases.
double sineError(const double* x) {
  Four s, c;
  sineCosine(loadFour(x), s, c);
  double error = 0.0;
  for (int i = 0; i < 4; ++i)
    error = std::max({error, std::abs(s[i] - std::sin(x[i])), std::abs(c[i] - std::cos(x[i]))});
  return error;
}

// Bound: the header's.
TEST(VectorSineIdentity, IsTheLibrarysSineAndCosineToTheLastDigits) {
  std::mt19937_64 random(5);
  double x[4];
  for (const double range : {1e-8, 1.0, 10.0, 1e3, 1e6}) {
    std::uniform_real_distribution<double> phase(-range, range);
    double error = 0.0;
    for (int n = 0; n < 100000; ++n) {
      for (double& one : x) one = phase(random);
      error = std::max(error, sineError(x));
    }
    EXPECT_LT(error, 1e-15 * (1.0 + range * 1e-6)) << range;
  }
}

TEST(VectorSineIdentity, HoldsWhereQuadrantsMeet) {
  for (int n = -2000; n < 2000; ++n) {
    const double middle = n * 0.25 * kPi;
    const double x[4] = {middle, std::nextafter(middle, 1e9), std::nextafter(middle, -1e9),
                         -middle};
    EXPECT_LT(sineError(x), 1e-15 * (1.0 + 1e-3)) << n;
  }
}

TEST(VectorSine, WhatIsNotFiniteGivesWhatIsNotANumber) {
  const double x[4] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 0.0};
  Four s, c;
  sineCosine(loadFour(x), s, c);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(s[i]) && std::isnan(c[i])) << i;
  EXPECT_EQ(s[3], 0.0);
  EXPECT_EQ(c[3], 1.0);
}

}  // namespace
}  // namespace cutwater
