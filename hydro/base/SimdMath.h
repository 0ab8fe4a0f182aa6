#pragma once
#include <cstddef>
#include <cstdint>

#include "hydro/base/Simd.h"

// Elementary functions of four numbers at once, for loops in functions marked CUTWATER_VECTOR. Errors
// below 2e-16 of the result, or of 1 for sine and cosine. No special values: the ranges given are all
// there is.

namespace cutwater {

/// Bits of four numbers; what a comparison of Fours gives.
using FourBits = std::int64_t __attribute__((vector_size(32)));

CUTWATER_INLINE FourBits bitsOf(Four x) { return __builtin_bit_cast(FourBits, x); }
CUTWATER_INLINE Four fromBits(FourBits x) { return __builtin_bit_cast(Four, x); }
CUTWATER_INLINE bool any(FourBits x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }
CUTWATER_INLINE Four loadFour(const double* from) {
  Four x;
  __builtin_memcpy(&x, from, sizeof(x));
  return x;
}
CUTWATER_INLINE double sumOf(Four x) { return (x[0] + x[2]) + (x[1] + x[3]); }
CUTWATER_INLINE void storeFour(double* to, Four x) { __builtin_memcpy(to, &x, sizeof(x)); }
CUTWATER_INLINE Four atLeast(Four x, double least) {
  const Four limit = x * 0.0 + least;
  return x > limit ? x : limit;
}
CUTWATER_INLINE Four squareRoot(Four x) {
  return Four{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]),
              __builtin_sqrt(x[3])};
}

/// 1.5·2⁵²: a number below 2⁵¹ to which it is added is rounded, and stands in the lowest bits.
inline constexpr double kRounder = 6755399441055744.0;
/// ln 2 in two parts, n times the first exact.
inline constexpr double kLnTwo = 6.93147180369123816490e-01,
                        kLnTwoRest = 1.90821492927058770002e-10;

/// c_0 xⁿ⁻¹ + … + c_{n−1}.
template <std::size_t n>
CUTWATER_INLINE Four polynomial(Four x, const double (&c)[n]) {
  Four sum = x * c[0] + c[1];
  for (std::size_t i = 2; i < n; ++i) sum = sum * x + c[i];
  return sum;
}

/// e^x, −700 ≤ x ≤ 700.
CUTWATER_INLINE Four exponential(Four x) {
  const Four shifted = x * 1.4426950408889634 + kRounder, n = shifted - kRounder;
  const Four r = (x - n * kLnTwo) - n * kLnTwoRest;
  const Four power =
      polynomial(r, {1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0,
                     1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0,
                     1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0});
  return fromBits(bitsOf(power) + (bitsOf(shifted) << 52));
}

/// The same for any x: from e^−700 to e^700, which are 0 and infinite for most purposes.
CUTWATER_INLINE Four boundedExponential(Four x) {
  return exponential(-atLeast(-atLeast(x, -700.0), -700.0));
}

/// ln x, normal x > 0. x = 2^n m with √½ < m < √2; ln m = 2 artanh s, s = (m − 1)/(m + 1).
CUTWATER_INLINE Four logarithm(Four x) {
  constexpr std::int64_t kRootHalf = 0x3fe6a09e667f3bcd, kExponent = -(std::int64_t{1} << 52);
  const FourBits scale = (bitsOf(x) - kRootHalf) & kExponent;  // n in the highest 12 bits
  using Unsigned = std::uint64_t __attribute__((vector_size(32)));
  const auto above = (__builtin_bit_cast(Unsigned, scale) ^ (std::uint64_t{1} << 63)) >> 52;
  const FourBits counted = __builtin_bit_cast(FourBits, above) + bitsOf(x * 0.0 + kRounder);
  const Four n = fromBits(counted) - (kRounder + 2048.0);
  const Four f = fromBits(bitsOf(x) - scale) - 1.0;
  const Four s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
  // (ln m − 2s)/s in powers of s², least greatest error [fdlibm, e_log.c].
  const Four sum =
      polynomial(z, {1.479819860511658591e-01, 1.531383769920937332e-01, 1.818357216161805012e-01,
                     2.222219843214978396e-01, 2.857142874366239149e-01, 3.999999999940941908e-01,
                     6.666666666666735130e-01});
  const Four tail = s * (half + z * sum) + n * kLnTwoRest;
  return n * kLnTwo - ((half - tail) - f);
}

struct SineCosine {
  Four sine, cosine;
};

/// |x| < 1e6, by quadrants; on ±π/4 polynomials of least greatest error [fdlibm, k_sin.c, k_cos.c].
CUTWATER_INLINE SineCosine sineCosine(Four x) {
  const Four shifted = x * 0.63661977236758134308 + kRounder, n = shifted - kRounder;
  const Four r = (x - n * 1.57079632673412561417) - n * 6.07710050650619224932e-11;
  const Four z = r * r;
  const Four s = polynomial(
      z, {1.58969099521155010221e-10, -2.50507602534068634195e-08, 2.75573137070700676789e-06,
          -1.98412698298579493134e-04, 8.33333333332248946124e-03, -1.66666666666666324348e-01});
  const Four c = polynomial(
      z, {-1.13596475577881948265e-11, 2.08757232129817482790e-09, -2.75573143513906633035e-07,
          2.48015872894767294178e-05, -1.38888888888741095749e-03, 4.16666666666666019037e-02});
  const Four sine = r + r * z * s, cosine = 1.0 - 0.5 * z + z * z * c;
  const FourBits quadrant = bitsOf(shifted);
  const auto odd = (quadrant & 1) != 0;
  const FourBits signOfSine = (quadrant & 2) << 62, signOfCosine = ((quadrant + 1) & 2) << 62;
  return {fromBits(bitsOf(odd ? cosine : sine) ^ signOfSine),
          fromBits(bitsOf(odd ? sine : cosine) ^ signOfCosine)};
}

/// Four complex numbers.
struct ComplexFour {
  Four re, im;
};
CUTWATER_INLINE ComplexFour operator+(const ComplexFour& a, const ComplexFour& b) {
  return {a.re + b.re, a.im + b.im};
}
CUTWATER_INLINE ComplexFour operator*(const ComplexFour& a, const ComplexFour& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
CUTWATER_INLINE ComplexFour operator*(double a, const ComplexFour& b) {
  return {a * b.re, a * b.im};
}
/// e^z as boundedExponential(re) and sineCosine(im) have it.
CUTWATER_INLINE ComplexFour exponential(const ComplexFour& z) {
  const Four size = boundedExponential(z.re);
  const SineCosine turn = sineCosine(z.im);
  return {size * turn.cosine, size * turn.sine};
}

}  // namespace cutwater
