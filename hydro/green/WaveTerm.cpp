#include "hydro/green/WaveTerm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hydro/Conventions.h"
#include "hydro/base/SimdMath.h"
#include "hydro/green/WaveTermTables.h"

namespace cutwater {
namespace {

using namespace wave_tables;

/// J₀, J₁, Y₀, Y₁ from the table, X < kBesselCells.
CUTWATER_INLINE Double4 besselFromTable(const BesselCell* cells, double X) {
  const auto i = static_cast<std::size_t>(X);
  const double t = 2.0 * (X - static_cast<double>(i)) - 1.0;
  const auto& c = cells[i].coefficient;
  Double4 even = c[kBesselPoints - 2], odd = c[kBesselPoints - 1];
  for (std::size_t p = kBesselPoints - 2; p > 0; p -= 2) {
    even = even * (t * t) + c[p - 2];
    odd = odd * (t * t) + c[p - 1];
  }
  return even + t * odd;
}

// Coefficients a_k of Hankel's expansion with their signs, (−1)^⌊k/2⌋ (4n²−1²)(4n²−3²)…/(k! 8^k).
constexpr std::size_t kHankelTerms = 12;
constexpr std::array<double, kHankelTerms> hankel(int order) {
  std::array<double, kHankelTerms> a{1.0};
  for (std::size_t k = 1; k < kHankelTerms; ++k) {
    const double odd = 2.0 * static_cast<double>(k) - 1.0;
    a[k] = a[k - 1] * (4.0 * order * order - odd * odd) / (8.0 * static_cast<double>(k));
  }
  for (std::size_t k = 2; k < kHankelTerms; ++k) {
    if (k / 2 % 2 == 1) a[k] = -a[k];
  }
  return a;
}

struct Bessels {
  Double4 J0, J1, Y0, Y1;
};

// J_n = √(2/πX) (P cos χ − Q sin χ), Y_n = √(2/πX) (P sin χ + Q cos χ), χ = X − nπ/2 − π/4.
// From X = 36 on the first term left out is 3e-15 of the leading one.
CUTWATER_INLINE Bessels besselsByHankel(Double4 X) {
  static constexpr auto a0 = hankel(0), a1 = hankel(1);
  const Double4 t = 1.0 / X, tt = t * t, zero = {};
  Double4 p0 = zero, q0 = zero, p1 = zero, q1 = zero;
  for (std::size_t k = kHankelTerms; k > 0; k -= 2) {
    p0 = p0 * tt + a0[k - 2];
    q0 = q0 * tt + a0[k - 1];
    p1 = p1 * tt + a1[k - 2];
    q1 = q1 * tt + a1[k - 1];
  }
  const Double4 amplitude = squareRoot(t / kPi);  // √(2/πX)/√2
  const auto [sine, cosine] = sineCosine(X);
  const Double4 c = amplitude * (cosine + sine), s = amplitude * (sine - cosine);
  q0 *= t;
  q1 *= t;
  return {p0 * c - q0 * s, p1 * s + q1 * c, p0 * s + q0 * c, q1 * s - p1 * c};
}

// Where a coordinate lies: index of its cell, place in it from −1 to 1.
struct Place {
  std::size_t cell;
  double local;
};
CUTWATER_INLINE Place place(double scaled, std::size_t last) {
  const std::size_t i = std::min(static_cast<std::size_t>(scaled), last);
  return {i, 2.0 * (scaled - static_cast<double>(i)) - 1.0};
}

// Below kSilent the waves are less than round-off; there X may be small, where Y₀ is not finite.
// Above it X > 15 where Y₀ is needed: R > 36 or α < 3/4.
constexpr double kSilent = 32.0;

/// Points that are worked out together, one step for all at a time: within a step they do not wait
/// for each other. Filled up to a multiple of four.
struct Points {
  static constexpr std::size_t kMost = 64;
  using Column = Column4<kMost>;
  std::size_t given, count;     // as many as there are, and filled up
  Column X, Y, R, perR, alpha;  // alpha = Y/R
  Column a, b;                  // place in the patch
  std::array<const Patch*, kMost> patch;
  std::array<std::int64_t, kMost> isNear;  // all bits, or none
  Column S, T;                             // what the patch holds
  Column J0, J1, Y0, Y1;                   // without e^{−Y}

  CUTWATER_INLINE void take(const double* fromX, const double* fromY, std::size_t points) {
    given = points;
    for (count = 0; count < given; count += 4) {
      const Double4 x = some(fromX, count), y = some(fromY, count);
      const Double4 r = squareRoot(x * x + y * y), inverse = 1.0 / r;
      X.store(count, x);
      Y.store(count, y);
      R.store(count, r);
      perR.store(count, inverse);
      alpha.store(count, y * inverse);
    }
  }

  CUTWATER_INLINE void find(const Tables& tables) {
    for (std::size_t i = 0; i < count; ++i) {
      if (R[i] < kNear) {
        const Place ring = place(R[i], kRings - 1);
        const Place column = place(alpha[i] * static_cast<double>(ring.cell + 2), ring.cell + 1);
        put(i, true, tables.near[ringBegin(ring.cell) + column.cell], ring, column);
        continue;
      }
      const Place row = place(perR[i] * (1.0 / kRowWidth), kFarRows - 1);
      if (row.cell >= kSteepRow && alpha[i] >= kSteep) {
        const Place column =
            place((alpha[i] - kSteep) * (kSteepColumns / (1.0 - kSteep)), kSteepColumns - 1);
        put(i, true, tables.steep[(row.cell - kSteepRow) * kSteepColumns + column.cell], row,
            column);
        continue;
      }
      const Place column = place(alpha[i] * kFarColumns, kFarColumns - 1);
      put(i, false, tables.far[row.cell * kFarColumns + column.cell], row, column);
    }
  }

  CUTWATER_INLINE void interpolate() {
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<double, 2> f = patch[i]->at(a[i], b[i]);
      S[i] = f[0];
      T[i] = f[1];
    }
  }

  CUTWATER_INLINE void bessels(const Tables& tables) {
    constexpr double kLast = kBesselCells;
    for (std::size_t i = 0; i < count; i += 4) {
      const Double4 x = X.load(i);
      const auto isFar = x >= kLast;
      if (any(isFar)) {
        const Bessels f = besselsByHankel(isFar ? x : x * 0.0 + kLast);
        J0.store(i, f.J0);
        J1.store(i, f.J1);
        Y0.store(i, f.Y0);
        Y1.store(i, f.Y1);
      }
      for (std::size_t k = i; k < i + 4; ++k) {
        if (X[k] >= kLast) continue;
        const Double4 f = besselFromTable(tables.bessel.data(), X[k]);
        J0[k] = f[0];
        J1[k] = f[1];
        Y0[k] = f[2];
        Y1[k] = f[3];
      }
    }
  }

  // near: F = −2 e^{−Y} J₀ ln((R+Y)/2) + S,
  //       ∂F/∂X = 2 e^{−Y}[J₁ ln((R+Y)/2) − J₀ X/(R(R+Y))] + (X/R) T
  // far:  F = −2π e^{−Y} Y₀ − 2S/R,  ∂F/∂X = 2π e^{−Y} Y₁ + 2XT/R³
  CUTWATER_INLINE void finish(const WaveTermArrays& terms) {
    for (std::size_t i = 0; i < count; i += 4) {
      const Double4 x = X.load(i), y = Y.load(i), r = R.load(i), inverse = perR.load(i);
      const auto silent = (y >= kSilent) & (r > 36.0);
      const Double4 E = silent ? y * 0.0 : exponential(silent ? y * 0.0 : -y);
      const Double4 j0 = E * J0.load(i), j1 = E * J1.load(i), y0 = E * Y0.load(i),
                    y1 = E * Y1.load(i), s = S.load(i), t = T.load(i);
      Double4 f = -2.0 * s * inverse - 2.0 * kPi * y0;
      Double4 fX = 2.0 * x * t * inverse * inverse * inverse + 2.0 * kPi * y1;
      Bits4 near;
      __builtin_memcpy(&near, &isNear[i], sizeof(near));
      if (any(near)) {
        const Double4 sum = r + y, L = 2.0 * logarithm(0.5 * sum);
        f = near ? s - j0 * L : f;
        fX = near ? j1 * L + x * inverse * (t - 2.0 * j0 / sum) : fX;
      }
      give(f, terms.F, i);
      give(fX, terms.FX, i);
      give(j0, terms.J0, i);
      give(j1, terms.J1, i);
      give(y0, terms.Y0, i);
      give(y1, terms.Y1, i);
    }
  }

 private:
  /// Four numbers from i on, 1 for those that are not there.
  CUTWATER_INLINE Double4 some(const double* from, std::size_t i) const {
    if (i + 4 <= given) return load4(from + i);
    Double4 x = Double4{} + 1.0;
    for (std::size_t k = i; k < given; ++k) x[k - i] = from[k];
    return x;
  }
  CUTWATER_INLINE void give(Double4 x, double* to, std::size_t i) const {
    if (i + 4 <= given) return store4(to + i, x);
    for (std::size_t k = i; k < given; ++k) to[k] = x[k - i];
  }
  CUTWATER_INLINE void put(std::size_t i, bool near, const Patch& in, const Place& row,
                           const Place& column) {
    isNear[i] = near ? -1 : 0;
    patch[i] = &in;
    a[i] = row.local;
    b[i] = column.local;
  }
};

}  // namespace

WaveTerm waveTerm(double X, double Y) {
  WaveTerm term;
  waveTerms(&X, &Y, 1, {&term.F, &term.FX, &term.J0, &term.J1, &term.Y0, &term.Y1});
  term.FY = -term.F - 2.0 / std::sqrt(X * X + Y * Y);
  return term;
}

CUTWATER_VECTOR void waveTerms(const double* X, const double* Y, std::size_t count,
                               const WaveTermArrays& terms) {
  const Tables& all = tables();
  Points p;
  for (std::size_t from = 0; from < count; from += Points::kMost) {
    const std::size_t some = std::min(Points::kMost, count - from);
    p.take(X + from, Y + from, some);
    p.find(all);
    p.interpolate();
    p.bessels(all);
    p.finish({terms.F + from, terms.FX + from, terms.J0 + from, terms.J1 + from, terms.Y0 + from,
              terms.Y1 + from});
  }
}

double waveTermRegular(double X, double Y) {
  const double R = std::sqrt(X * X + Y * Y);
  if (R < 1e-100) return -2.0 * std::numbers::egamma;
  return waveTerm(X, Y).F + 2.0 * std::log(0.5 * (R + Y));
}

}  // namespace cutwater
