#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "hydro/base/SimdSingle.h"

// Eight and sixteen numbers at once, against the same functions in double precision.
namespace cutwater {
namespace {

constexpr std::size_t kCount = 16;  // numbers a call

template <class Double>
CUTWATER_INLINE void cosinesOf(const double* x, double* result) {
  constexpr std::size_t kLanes = sizeof(Double) / sizeof(double);
  for (std::size_t i = 0; i < kCount; i += kLanes) {
    const Double turns = Double::load(x + i);
    toDouble(cosineOfTurns(toSingle(Double{partOfTurn(turns.low), partOfTurn(turns.high)})))
        .store(result + i);
  }
}
template <class Double>
CUTWATER_INLINE void powersOf(const double* x, double* result) {
  constexpr std::size_t kLanes = sizeof(Double) / sizeof(double);
  for (std::size_t i = 0; i < kCount; i += kLanes)
    toDouble(powerOfTwo(toSingle(Double::load(x + i)))).store(result + i);
}
CUTWATER_VECTOR void cosines(const double* x, double* result) { cosinesOf<Doubles8>(x, result); }
CUTWATER_WIDE void cosinesWide(const double* x, double* result) { cosinesOf<Doubles16>(x, result); }
CUTWATER_VECTOR void powers(const double* x, double* result) { powersOf<Doubles8>(x, result); }
CUTWATER_WIDE void powersWide(const double* x, double* result) { powersOf<Doubles16>(x, result); }

constexpr double kTwoPi = 6.283185307179586;

using Function = void (*)(const double*, double*);
std::vector<Function> those(Function narrow, Function wide) {
  return wideRegisters() ? std::vector{narrow, wide} : std::vector{narrow};
}

/// Calls check(x, f(x)) for numbers evenly between, so many a call.
void forNumbers(Function f, double from, double to, const auto& check) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(from, to);
  for (int i = 0; i < 5000; ++i) {
    double x[kCount], y[kCount];
    for (double& value : x) value = between(random);
    f(x, y);
    for (std::size_t lane = 0; lane < kCount; ++lane) check(x[lane], y[lane]);
  }
}

// 2⁻²⁴ = 6e-8 is half a unit in the last place of single numbers about 1. The greatest error is
// where the turns round, 2⁻²⁶ of them below ½, times 2π.
TEST(SimdSingleClosedForm, Cosine) {
  for (const Function f : those(cosines, cosinesWide)) {
    for (const double range : {0.5, 20.0, 1e6})
      forNumbers(f, -range, range, [](double x, double y) {
        EXPECT_NEAR(y, std::cos(kTwoPi * std::remainder(x, 1.0)), 2e-7) << x;
      });
  }
}

// x itself has an error of 6e-8 of it before the function sees it.
TEST(SimdSingleClosedForm, PowerOfTwo) {
  for (const Function f : those(powers, powersWide)) {
    for (const double range : {0.5, 5.0, 60.0})
      forNumbers(f, -range, range, [](double x, double y) {
        EXPECT_NEAR(y / std::exp2(static_cast<double>(static_cast<float>(x))), 1.0, 2e-7) << x;
      });
    double ends[kCount] = {0.0, 1.0, -1.0, 64.0, 1e30, -100.0, -1e30}, y[kCount];
    f(ends, y);
    EXPECT_EQ(y[0], 1.0);
    EXPECT_EQ(y[1], 2.0);
    EXPECT_EQ(y[2], 0.5);
    EXPECT_EQ(y[3], std::exp2(64.0));
    EXPECT_EQ(y[4], y[3]);
    EXPECT_EQ(y[5], std::exp2(-100.0));
    EXPECT_EQ(y[6], y[5]);
  }
}

}  // namespace
}  // namespace cutwater
