#pragma once
#include <cstddef>
#include <cstdint>

#include "hydro/base/SimdMath.h"

// Eight or sixteen numbers in single precision at once, and as many in double precision, for loops
// that are written once, as templates over `lanes`, and compiled twice: CUTWATER_WIDE with sixteen,
// where wideRegisters() says so, and CUTWATER_VECTOR with eight, elsewhere. (Vectors wider than the
// machine's registers are slow: the compiler takes them apart in memory.)

// CUTWATER_WIDE before a function: it is compiled for AVX-512. Call it if wideRegisters().
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CUTWATER_WIDE __attribute__((target("arch=x86-64-v4")))
#define CUTWATER_HAS_WIDE __builtin_cpu_supports("x86-64-v4")
#else
#define CUTWATER_WIDE
#define CUTWATER_HAS_WIDE false
#endif

namespace cutwater {

/// Whether sixteen numbers in single precision fit into one register of this machine.
inline bool wideRegisters() noexcept { return CUTWATER_HAS_WIDE; }

using Single8 = float __attribute__((vector_size(32)));
using Single16 = float __attribute__((vector_size(64)));
using Double8 = double __attribute__((vector_size(64)));

template <class Vector>
CUTWATER_INLINE Vector loadAs(const void* from) {
  Vector x;
  __builtin_memcpy(&x, from, sizeof(x));
  return x;
}
template <class Vector>
CUTWATER_INLINE void storeAs(void* to, const Vector& x) {
  __builtin_memcpy(to, &x, sizeof(x));
}

/// Eight or sixteen numbers in double precision. (Read and written by halves: the copy of a struct
/// goes through memory in pieces that the machine then waits for.)
template <class Half>
struct Doubles {
  static constexpr std::size_t kHalf = sizeof(Half) / sizeof(double);
  static CUTWATER_INLINE Doubles load(const double* from) {
    return {loadAs<Half>(from), loadAs<Half>(from + kHalf)};
  }
  CUTWATER_INLINE void store(double* to) const {
    storeAs(to, low);
    storeAs(to + kHalf, high);
  }
  Half low, high;
};
using Doubles8 = Doubles<Double4>;
using Doubles16 = Doubles<Double8>;

/// Each rounded to the nearest in single precision.
CUTWATER_INLINE Single8 toSingle(const Doubles8& x) {
  using Single4 = float __attribute__((vector_size(16)));
  return __builtin_shufflevector(__builtin_convertvector(x.low, Single4),
                                 __builtin_convertvector(x.high, Single4), 0, 1, 2, 3, 4, 5, 6, 7);
}
CUTWATER_INLINE Single16 toSingle(const Doubles16& x) {
  return __builtin_shufflevector(__builtin_convertvector(x.low, Single8),
                                 __builtin_convertvector(x.high, Single8), 0, 1, 2, 3, 4, 5, 6, 7,
                                 8, 9, 10, 11, 12, 13, 14, 15);
}
/// The same numbers in double precision.
CUTWATER_INLINE Doubles8 toDouble(Single8 x) {
  return {__builtin_convertvector(__builtin_shufflevector(x, x, 0, 1, 2, 3), Double4),
          __builtin_convertvector(__builtin_shufflevector(x, x, 4, 5, 6, 7), Double4)};
}
CUTWATER_INLINE Doubles16 toDouble(Single16 x) {
  return {__builtin_convertvector(__builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7), Double8),
          __builtin_convertvector(__builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15),
                                  Double8)};
}

template <class Half>
CUTWATER_INLINE Doubles<Half> operator+(const Doubles<Half>& x, const Doubles<Half>& y) {
  return {x.low + y.low, x.high + y.high};
}
template <class Half>
CUTWATER_INLINE Doubles<Half> operator-(const Doubles<Half>& x, const Doubles<Half>& y) {
  return {x.low - y.low, x.high - y.high};
}
template <class Half>
CUTWATER_INLINE Doubles<Half> least(const Doubles<Half>& x, const Doubles<Half>& y) {
  return {x.low < y.low ? x.low : y.low, x.high < y.high ? x.high : y.high};
}

/// Turns without the whole ones: −½..½. |x| < 2⁵¹.
template <class Double>
CUTWATER_INLINE Double partOfTurn(Double x) {
  return x - ((x + kRounder) - kRounder);
}

/// cos 2πx, |x| ≤ ½, as sin 2π(¼ − |x|). Error below 2e-7: that of a polynomial of least greatest
/// error, 3e-8, and of roundings. (Of single numbers a unit in the last place below 1 is 6e-8.)
template <class Single>
CUTWATER_INLINE Single cosineOfTurns(Single x) {
  using Bits = decltype(x < x);
  const Single size = __builtin_bit_cast(Single, __builtin_bit_cast(Bits, x) & 0x7fffffff);
  const Single v = 0.25F - size, z = v * v;
  return v * ((((39.759827F * z - 76.581169F) * z + 81.602478F) * z - 41.341682F) * z + 6.2831855F);
}

/// 2^x, exactly 1 for 0; for x < −100 that of −100, for x > 64 that of 64, so that it is always
/// finite and above 0. Error below 2e-7 of it: polynomial 1e-8, roundings the rest.
template <class Single>
CUTWATER_INLINE Single powerOfTwo(Single x) {
  constexpr float kRounderSingle = 12582912.0F;  // 1.5·2²³: as kRounder
  using Bits = decltype(x < x);
  const Single low = x * 0.0F - 100.0F, high = x * 0.0F + 64.0F;
  x = x > low ? x : low;
  x = x < high ? x : high;
  const Single shifted = x + kRounderSingle, r = x - (shifted - kRounderSingle);
  const Single slope =
      ((((0.00015453163F * r + 0.0013390863F) * r + 0.009618083F) * r + 0.05550357F) * r +
       0.24022651F) *
          r +
      0.6931472F;
  const Single power = slope * r + 1.0F;
  return __builtin_bit_cast(
      Single, __builtin_bit_cast(Bits, power) + (__builtin_bit_cast(Bits, shifted) << 23));
}

}  // namespace cutwater
