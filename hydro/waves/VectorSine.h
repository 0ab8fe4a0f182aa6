#pragma once
#include <cstring>

#include "hydro/Vector.h"

/// Sines and cosines of four phases at once; internal to hydro.
namespace cutwater {

CUTWATER_INLINE Four loadFour(const double* at) noexcept {
  Four v;
  std::memcpy(&v, at, sizeof v);
  return v;
}

CUTWATER_INLINE double sumOf(const Four& v) noexcept { return (v[0] + v[2]) + (v[1] + v[3]); }

/// sin x and cos x, absolute error below 1e-15 (1 + |x| 1e-6) for |x| < 1e6: x − nπ/2 is taken with π/2 in
/// three parts, the first two so short that n times them is exact, then Taylor's polynomials to ±π/4.
/// Only + − × and bit operations: the same bits on every machine but for fused multiplications.
CUTWATER_INLINE void sineCosine(const Four& x, Four& sine, Four& cosine) noexcept {
  using Mask = long long __attribute__((vector_size(32)));
  constexpr double kTwoOverPi = 0.63661977236758134308;
  constexpr double kRound = 6755399441055744.0;  // 1.5 · 2^52: adding it rounds to an integer
  constexpr double kHigh = 1.57079632673412561417e+00, kMiddle = 6.07710050630396597660e-11,
                   kLow = 2.02226624879595063154e-21;
  const Four shifted = x * kTwoOverPi + kRound, n = shifted - kRound;
  Mask quadrant;
  std::memcpy(&quadrant, &shifted, sizeof quadrant);
  const Four r = ((x - n * kHigh) - n * kMiddle) - n * kLow, rr = r * r;
  Four s = rr * -7.64716373181981647590e-13 + 1.60590438368216145994e-10;
  s = rr * s - 2.50521083854417187751e-8;
  s = rr * s + 2.75573192239858906526e-6;
  s = rr * s - 1.98412698412698412698e-4;
  s = rr * s + 8.33333333333333333333e-3;
  s = rr * s - 1.66666666666666666667e-1;
  s = r + r * rr * s;
  Four c = rr * 4.77947733238738529744e-14 - 1.14707455977297247139e-11;
  c = rr * c + 2.08767569878680989792e-9;
  c = rr * c - 2.75573192239858906526e-7;
  c = rr * c + 2.48015873015873015873e-5;
  c = rr * c - 1.38888888888888888889e-3;
  c = rr * c + 4.16666666666666666667e-2;
  c = rr * rr * c - 0.5 * rr + 1.0;
  const Mask odd = (quadrant & 1) != 0;
  const Mask minusSine = (quadrant & 2) != 0, minusCosine = ((quadrant + 1) & 2) != 0;
  const Four ss = odd ? c : s, cc = odd ? s : c;
  sine = minusSine ? -ss : ss;
  cosine = minusCosine ? -cc : cc;
}

}  // namespace cutwater
