#include "hydro/green/WaveTerm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hydro/Vector.h"
#include "hydro/green/WaveTermTables.h"

namespace cutwater {
namespace {

using namespace wave_tables;
constexpr double kPi = std::numbers::pi;

struct Bessel {
  double J0, J1, Y0, Y1;
};

CUTWATER_INLINE Bessel besselFromTable(const BesselCell* cells, double X) {
  const auto i = static_cast<std::size_t>(X);
  const double t = 2.0 * (X - static_cast<double>(i)) - 1.0;
  const auto& c = cells[i].coefficient;
  Four sum = c[kBesselPoints - 1];
  for (std::size_t p = kBesselPoints - 1; p-- > 0;) sum = sum * t + c[p];
  return {sum[0], sum[1], sum[2], sum[3]};
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

// J_n = √(2/πX) (P cos χ − Q sin χ), Y_n = √(2/πX) (P sin χ + Q cos χ), χ = X − nπ/2 − π/4.
// From X = 36 on the first term left out is 3e-15 of the leading one.
CUTWATER_INLINE Bessel besselByHankel(double X) {
  static constexpr auto a0 = hankel(0), a1 = hankel(1);
  const double t = 1.0 / X, tt = t * t;
  Four sum = {};  // P₀, Q₀/t, P₁, Q₁/t
  for (std::size_t k = kHankelTerms; k > 0; k -= 2)
    sum = sum * tt + Four{a0[k - 2], a0[k - 1], a1[k - 2], a1[k - 1]};
  const double p0 = sum[0], q0 = t * sum[1], p1 = sum[2], q1 = t * sum[3];
  const double amplitude = std::sqrt(t / kPi);  // √(2/πX)/√2
  const double sine = std::sin(X), cosine = std::cos(X);
  const double c = amplitude * (cosine + sine), s = amplitude * (sine - cosine);
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

// Below kSilent the waves are less than round-off; there X may be small, where Y₀ is not finite. Above
// it X > 15 where Y₀ is needed: R > 36 or α < 3/4.
constexpr double kSilent = 32.0;

/// Points that are worked out together, one step for all at a time: within a step they do not wait
/// for each other.
struct Points {
  static constexpr std::size_t kMost = 64;
  std::array<double, kMost> R, a, b;  // place in the patch
  std::array<const Patch*, kMost> patch;
  std::array<bool, kMost> isNear;
  std::array<double, kMost> S, T;  // what the patch holds

  CUTWATER_INLINE void find(const Tables& tables, const double* X, const double* Y,
                            std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double r = std::sqrt(X[i] * X[i] + Y[i] * Y[i]), alpha = Y[i] / r;
      R[i] = r;
      if (r < kNear) {
        const Place ring = place(r, kRings - 1);
        const Place column = place(alpha * static_cast<double>(ring.cell + 2), ring.cell + 1);
        put(i, true, tables.near[ringBegin(ring.cell) + column.cell], ring, column);
        continue;
      }
      const Place row = place(1.0 / (r * kRowWidth), kFarRows - 1);
      if (row.cell >= kSteepRow && alpha >= kSteep) {
        const Place column =
            place((alpha - kSteep) * (kSteepColumns / (1.0 - kSteep)), kSteepColumns - 1);
        put(i, true, tables.steep[(row.cell - kSteepRow) * kSteepColumns + column.cell], row,
            column);
        continue;
      }
      const Place column = place(alpha * kFarColumns, kFarColumns - 1);
      put(i, false, tables.far[row.cell * kFarColumns + column.cell], row, column);
    }
  }
  CUTWATER_INLINE void interpolate(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<double, 2> f = patch[i]->at(a[i], b[i]);
      S[i] = f[0];
      T[i] = f[1];
    }
  }

 private:
  CUTWATER_INLINE void put(std::size_t i, bool near, const Patch& in, const Place& row,
                           const Place& column) {
    isNear[i] = near;
    patch[i] = &in;
    a[i] = row.local;
    b[i] = column.local;
  }
};

/// e^{−Y} times the Bessel functions, 0 where that is less than round-off.
CUTWATER_INLINE void bessels(const Tables& tables, const double* X, const double* Y,
                             std::size_t count, const WaveTermArrays& terms) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool silent = Y[i] >= kSilent && X[i] * X[i] + Y[i] * Y[i] > 36.0 * 36.0;
    const double E = silent ? 0.0 : std::exp(-Y[i]);
    const Bessel f =
        X[i] < kBesselCells ? besselFromTable(tables.bessel.data(), X[i]) : besselByHankel(X[i]);
    terms.J0[i] = E * f.J0;
    terms.J1[i] = E * f.J1;
    terms.Y0[i] = E * f.Y0;
    terms.Y1[i] = E * f.Y1;
  }
}

// near: F = −2 e^{−Y} J₀ ln((R+Y)/2) + S,
//       ∂F/∂X = 2 e^{−Y}[J₁ ln((R+Y)/2) − J₀ X/(R(R+Y))] + (X/R) T
// far:  F = −2π e^{−Y} Y₀ − 2S/R,  ∂F/∂X = 2π e^{−Y} Y₁ + 2XT/R³
CUTWATER_INLINE void finish(const Points& p, const double* X, const double* Y, std::size_t count,
                            const WaveTermArrays& terms) {
  for (std::size_t i = 0; i < count; ++i) {
    const double R = p.R[i], perR = 1.0 / R, S = p.S[i], T = p.T[i];
    if (p.isNear[i]) {
      const double L = 2.0 * std::log(0.5 * (R + Y[i]));
      terms.F[i] = S - terms.J0[i] * L;
      terms.FX[i] = terms.J1[i] * L + X[i] * perR * (T - 2.0 * terms.J0[i] / (R + Y[i]));
    } else {
      terms.F[i] = -2.0 * S * perR - 2.0 * kPi * terms.Y0[i];
      terms.FX[i] = 2.0 * X[i] * T * perR * perR * perR + 2.0 * kPi * terms.Y1[i];
    }
  }
}

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
  Points points;
  for (std::size_t from = 0; from < count; from += Points::kMost) {
    const std::size_t some = std::min(Points::kMost, count - from);
    const WaveTermArrays part{terms.F + from,  terms.FX + from, terms.J0 + from,
                              terms.J1 + from, terms.Y0 + from, terms.Y1 + from};
    points.find(all, X + from, Y + from, some);
    points.interpolate(some);
    bessels(all, X + from, Y + from, some, part);
    finish(points, X + from, Y + from, some, part);
  }
}

double waveTermRegular(double X, double Y) {
  const double R = std::sqrt(X * X + Y * Y);
  if (R < 1e-100) return -2.0 * std::numbers::egamma;
  return waveTerm(X, Y).F + 2.0 * std::log(0.5 * (R + Y));
}

}  // namespace cutwater
