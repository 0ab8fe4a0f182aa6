#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "hydro/base/CsvRow.h"

namespace cutwater {
namespace {

TEST(CsvRow, NumbersHaveNineDigitsAndNoMinusZero) {
  EXPECT_EQ(csvNumber(1.0 / 3.0), "0.333333333");
  EXPECT_EQ(csvNumber(-1.5), "-1.5");
  EXPECT_EQ(csvNumber(-0.0), "0");
  EXPECT_EQ(csvNumber(1e100), "1e+100");
  EXPECT_EQ(csvNumber(-std::numeric_limits<double>::max()), "-1.79769313e+308");
  EXPECT_EQ(csvNumber(-std::numeric_limits<double>::denorm_min()), "-4.94065646e-324");
  const double infinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::string text = "a,b,c\n";
  addCsvRow(text, {infinite, -infinite, std::copysign(nan, -1.0)});
  addCsvRow(text, {-0.0});
  EXPECT_EQ(text, "a,b,c\ninf,-inf,nan\n0\n");
}

// What printf writes with %.9g, over all exponents.
TEST(CsvRowIdentity, NumbersAreThoseOfPrintf) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0), exponent(-300.0, 300.0);
  for (int i = 0; i < 10000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, std::round(exponent(random)));
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    EXPECT_EQ(csvNumber(value), digits);
  }
}

}  // namespace
}  // namespace cutwater
