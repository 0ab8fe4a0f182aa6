#include "hydro/base/Simd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <thread>
#include <vector>

// Four numbers at once: the same numbers as one after the other, in every thread.
namespace cutwater {
namespace {

struct alignas(32) FourSums {
  Double4 sum;
};

CUTWATER_INLINE Double4 four(const double* from) {
  Double4 x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

/// Σ x y, in four sums side by side. @param count  a multiple of four.
CUTWATER_VECTOR void addProducts(const double* x, const double* y, std::size_t count,
                                 FourSums* to) {
  Double4 sum{};
  for (std::size_t i = 0; i < count; i += 4) sum += four(x + i) * four(y + i);
  to->sum = sum;
}

double scalarProduct(const std::vector<double>& x, const std::vector<double>& y) {
  FourSums sums{};
  addProducts(x.data(), y.data(), x.size(), &sums);
  return (sums.sum[0] + sums.sum[1]) + (sums.sum[2] + sums.sum[3]);
}

std::vector<double> powersOf(double base, std::size_t count) {
  std::vector<double> x(count, 1.0);
  for (std::size_t i = 1; i < count; ++i) x[i] = base * x[i - 1];
  return x;
}

// A geometric series, Σ qⁿ = (1 − q⁴⁰⁰)/(1 − q). All terms have one sign, so that 400 roundings of
// 1.1e-16 leave less than 1e-13 of the sum.
TEST(SimdClosedForm, SumsOfAVectorFunctionAreThoseOfTheFormula) {
  for (const double q : {0.5, 0.9, 0.99}) {
    const double exact = (1.0 - std::pow(q, 400.0)) / (1.0 - q);
    EXPECT_NEAR(scalarProduct(powersOf(q, 400), std::vector<double>(400, 1.0)), exact,
                1e-13 * exact);
  }
}

// Each member is worked out by itself. Sums and products of small whole numbers are exact.
TEST(SimdIdentity, MembersDoNotMix) {
  const Double4 a{1.0, -2.0, 3.0, -4.0}, b{5.0, 6.0, -7.0, -8.0};
  const Double4 product = a * b, scaled = 2.0 * a + 1.0;
  const auto positive = a > 0.0;
  const Double4 chosen = positive ? a : b;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(product[i], a[i] * b[i]);
    EXPECT_EQ(scaled[i], 2.0 * a[i] + 1.0);
    EXPECT_EQ(chosen[i], a[i] > 0.0 ? a[i] : b[i]);
  }
}

// The machine's variant of a vector function is chosen once, when the program starts.
TEST(SimdIdentity, EveryThreadGetsTheSameBits) {
  const std::vector<double> x = powersOf(0.97, 1000), y = powersOf(1.01, 1000);
  const double here = scalarProduct(x, y);
  std::vector<double> found(4, 0.0);
  std::vector<std::thread> threads;
  for (double& one : found) threads.emplace_back([&one, &x, &y] { one = scalarProduct(x, y); });
  for (std::thread& thread : threads) thread.join();
  for (const double one : found) EXPECT_EQ(std::memcmp(&one, &here, sizeof one), 0);
}

// What goes through memory from one function to another must lie where the widest variant reads it.
TEST(Simd, StructsOfFourSayWhereTheyLie) {
  EXPECT_EQ(sizeof(Double4), 4 * sizeof(double));
  EXPECT_EQ(alignof(FourSums), 32u);
  const std::vector<FourSums> several(3);
  for (const FourSums& one : several) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&one) % 32, 0u);
}

}  // namespace
}  // namespace cutwater
