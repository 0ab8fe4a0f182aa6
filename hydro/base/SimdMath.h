#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "hydro/base/Simd.h"

// Elementary functions of four numbers at once, for loops in functions marked CUTWATER_VECTOR.
// Errors below 2e-16 of the result, or of 1 for sine and cosine. No special values: the ranges
// given are all there is.

namespace cutwater {

/// Bits of four numbers; what a comparison of two Double4 gives.
using Bits4 = std::int64_t __attribute__((vector_size(32)));

CUTWATER_INLINE Bits4 bitsOf(Double4 x) { return __builtin_bit_cast(Bits4, x); }
CUTWATER_INLINE Double4 fromBits(Bits4 x) { return __builtin_bit_cast(Double4, x); }
CUTWATER_INLINE bool any(Bits4 x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }
CUTWATER_INLINE Double4 load4(const double* from) {
  Double4 x;
  __builtin_memcpy(&x, from, sizeof(x));
  return x;
}
CUTWATER_INLINE double sumOf(Double4 x) { return (x[0] + x[2]) + (x[1] + x[3]); }
CUTWATER_INLINE void store4(double* to, Double4 x) { __builtin_memcpy(to, &x, sizeof(x)); }

/// `size` numbers in a row, a multiple of four, read and written four at a time.
template <std::size_t size>
struct alignas(32) Column4 : std::array<double, size> {
  CUTWATER_INLINE Double4 load(std::size_t i) const { return load4(this->data() + i); }
  CUTWATER_INLINE void store(std::size_t i, Double4 x) { store4(this->data() + i, x); }
};

CUTWATER_INLINE Double4 atLeast(Double4 x, double least) {
  const Double4 limit = x * 0.0 + least;
  return x > limit ? x : limit;
}
CUTWATER_INLINE Double4 squareRoot(Double4 x) {
  return Double4{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]),
                 __builtin_sqrt(x[3])};
}

/// 1.5·2⁵²: a number below 2⁵¹ to which it is added is rounded, and stands in the lowest bits.
inline constexpr double kRounder = 6755399441055744.0;
/// ln 2 in two parts, n times the first exact.
inline constexpr double kLnTwo = 6.93147180369123816490e-01,
                        kLnTwoRest = 1.90821492927058770002e-10;

/// c_0 xⁿ⁻¹ + … + c_{n−1}.
template <std::size_t n>
CUTWATER_INLINE Double4 polynomial(Double4 x, const double (&c)[n]) {
  Double4 sum = x * c[0] + c[1];
  for (std::size_t i = 2; i < n; ++i) sum = sum * x + c[i];
  return sum;
}

/// e^x, −700 ≤ x ≤ 700.
CUTWATER_INLINE Double4 exponential(Double4 x) {
  const Double4 shifted = x * 1.4426950408889634 + kRounder, n = shifted - kRounder;
  const Double4 r = (x - n * kLnTwo) - n * kLnTwoRest;
  const Double4 power =
      polynomial(r, {1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0,
                     1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0,
                     1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0});
  return fromBits(bitsOf(power) + (bitsOf(shifted) << 52));
}

/// The same for any x: from e^−700 to e^700, which are 0 and infinite for most purposes.
CUTWATER_INLINE Double4 boundedExponential(Double4 x) {
  return exponential(-atLeast(-atLeast(x, -700.0), -700.0));
}

/// ln x, normal x > 0. x = 2^n m with √½ < m < √2; ln m = 2 artanh s, s = (m − 1)/(m + 1).
CUTWATER_INLINE Double4 logarithm(Double4 x) {
  constexpr std::int64_t kRootHalf = 0x3fe6a09e667f3bcd, kExponent = -(std::int64_t{1} << 52);
  const Bits4 scale = (bitsOf(x) - kRootHalf) & kExponent;  // n in the highest 12 bits
  using Unsigned = std::uint64_t __attribute__((vector_size(32)));
  const auto above = (__builtin_bit_cast(Unsigned, scale) ^ (std::uint64_t{1} << 63)) >> 52;
  const Bits4 counted = __builtin_bit_cast(Bits4, above) + bitsOf(x * 0.0 + kRounder);
  const Double4 n = fromBits(counted) - (kRounder + 2048.0);
  const Double4 f = fromBits(bitsOf(x) - scale) - 1.0;
  const Double4 s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
  // (ln m − 2s)/s in powers of s², least greatest error [fdlibm, e_log.c].
  const Double4 sum =
      polynomial(z, {1.479819860511658591e-01, 1.531383769920937332e-01, 1.818357216161805012e-01,
                     2.222219843214978396e-01, 2.857142874366239149e-01, 3.999999999940941908e-01,
                     6.666666666666735130e-01});
  const Double4 tail = s * (half + z * sum) + n * kLnTwoRest;
  return n * kLnTwo - ((half - tail) - f);
}

struct SineCosine {
  Double4 sine, cosine;
};

/// |x| < 1e6, by quadrants; on ±π/4 polynomials of least greatest error [fdlibm, k_sin.c, k_cos.c].
CUTWATER_INLINE SineCosine sineCosine(Double4 x) {
  const Double4 shifted = x * 0.63661977236758134308 + kRounder, n = shifted - kRounder;
  const Double4 r = (x - n * 1.57079632673412561417) - n * 6.07710050650619224932e-11;
  const Double4 z = r * r;
  const Double4 s = polynomial(
      z, {1.58969099521155010221e-10, -2.50507602534068634195e-08, 2.75573137070700676789e-06,
          -1.98412698298579493134e-04, 8.33333333332248946124e-03, -1.66666666666666324348e-01});
  const Double4 c = polynomial(
      z, {-1.13596475577881948265e-11, 2.08757232129817482790e-09, -2.75573143513906633035e-07,
          2.48015872894767294178e-05, -1.38888888888741095749e-03, 4.16666666666666019037e-02});
  const Double4 sine = r + r * z * s, cosine = 1.0 - 0.5 * z + z * z * c;
  const Bits4 quadrant = bitsOf(shifted);
  const auto odd = (quadrant & 1) != 0;
  const Bits4 signOfSine = (quadrant & 2) << 62, signOfCosine = ((quadrant + 1) & 2) << 62;
  return {fromBits(bitsOf(odd ? cosine : sine) ^ signOfSine),
          fromBits(bitsOf(odd ? sine : cosine) ^ signOfCosine)};
}

/// Four complex numbers.
struct ComplexDouble4 {
  Double4 re, im;
};
CUTWATER_INLINE ComplexDouble4 operator+(const ComplexDouble4& a, const ComplexDouble4& b) {
  return {a.re + b.re, a.im + b.im};
}
CUTWATER_INLINE ComplexDouble4 operator*(const ComplexDouble4& a, const ComplexDouble4& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
CUTWATER_INLINE ComplexDouble4 operator*(double a, const ComplexDouble4& b) {
  return {a * b.re, a * b.im};
}
/// e^z as boundedExponential(re) and sineCosine(im) give it.
CUTWATER_INLINE ComplexDouble4 exponential(const ComplexDouble4& z) {
  const Double4 size = boundedExponential(z.re);
  const SineCosine turn = sineCosine(z.im);
  return {size * turn.cosine, size * turn.sine};
}

}  // namespace cutwater
