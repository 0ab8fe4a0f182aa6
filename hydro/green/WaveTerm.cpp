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
  double p0 = 0.0, q0 = 0.0, p1 = 0.0, q1 = 0.0;
  for (std::size_t k = kHankelTerms; k > 0; k -= 2) {
    q0 = q0 * tt + a0[k - 1];
    q1 = q1 * tt + a1[k - 1];
    p0 = p0 * tt + a0[k - 2];
    p1 = p1 * tt + a1[k - 2];
  }
  q0 *= t;
  q1 *= t;
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

// F = −2 e^{−Y} J₀ ln((R+Y)/2) + S,  ∂F/∂X = 2 e^{−Y}[J₁ ln((R+Y)/2) − J₀ X/(R(R+Y))] + (X/R) T.
CUTWATER_INLINE WaveTerm near(const Tables& tables, double X, double Y, double R,
                              const Patch& patch, double a, double b) {
  const double E = std::exp(-Y), L = std::log(0.5 * (R + Y));
  const Bessel bessel = besselFromTable(tables.bessel.data(), X);
  const double J0 = E * bessel.J0, J1 = E * bessel.J1;
  const auto [S, T] = patch.at(a, b);
  const double F = S - 2.0 * J0 * L;
  const double sine = X / R;
  return {F,  2.0 * J1 * L + sine * (T - 2.0 * J0 / (R + Y)), -F - 2.0 / R, J0, J1,
          E * bessel.Y0, E * bessel.Y1};
}

// F = −2π e^{−Y} Y₀ + W. Below kSilent the waves are less than round-off; there X may be small,
// where Y₀ is not finite. Above it X > 15, for R > 36 or α < 3/4 here.
CUTWATER_INLINE WaveTerm far(const Tables& tables, double X, double Y, double R,
                             const Patch& patch, double a, double b) {
  constexpr double kSilent = 32.0;
  const double inverse = 1.0 / R;
  const auto [w, slope] = patch.at(a, b);
  WaveTerm term{-2.0 * w * inverse, 2.0 * X * slope * inverse * inverse * inverse};
  if (Y < kSilent) {
    const double E = std::exp(-Y);
    const Bessel bessel =
        X < kBesselCells ? besselFromTable(tables.bessel.data(), X) : besselByHankel(X);
    term.J0 = E * bessel.J0;
    term.J1 = E * bessel.J1;
    term.Y0 = E * bessel.Y0;
    term.Y1 = E * bessel.Y1;
    term.F -= 2.0 * kPi * term.Y0;
    term.FX += 2.0 * kPi * term.Y1;
  }
  term.FY = -term.F - 2.0 * inverse;
  return term;
}

CUTWATER_INLINE WaveTerm evaluate(const Tables& tables, double X, double Y) {
  const double R = std::sqrt(X * X + Y * Y), alpha = Y / R;
  if (R < kNear) {
    const Place ring = place(R, kRings - 1);
    const Place column = place(alpha * static_cast<double>(ring.cell + 2), ring.cell + 1);
    const Patch& patch = tables.near[ringBegin(ring.cell) + column.cell];
    return near(tables, X, Y, R, patch, ring.local, column.local);
  }
  const Place row = place(1.0 / (R * kRowWidth), kFarRows - 1);
  if (row.cell >= kSteepRow && alpha >= kSteep) {
    const Place column =
        place((alpha - kSteep) * (kSteepColumns / (1.0 - kSteep)), kSteepColumns - 1);
    const Patch& patch = tables.steep[(row.cell - kSteepRow) * kSteepColumns + column.cell];
    return near(tables, X, Y, R, patch, row.local, column.local);
  }
  const Place column = place(alpha * kFarColumns, kFarColumns - 1);
  const Patch& patch = tables.far[row.cell * kFarColumns + column.cell];
  return far(tables, X, Y, R, patch, row.local, column.local);
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
  for (std::size_t i = 0; i < count; ++i) {
    const WaveTerm one = evaluate(all, X[i], Y[i]);
    terms.F[i] = one.F;
    terms.FX[i] = one.FX;
    terms.J0[i] = one.J0;
    terms.J1[i] = one.J1;
    terms.Y0[i] = one.Y0;
    terms.Y1[i] = one.Y1;
  }
}

double waveTermRegular(double X, double Y) {
  const double R = std::sqrt(X * X + Y * Y);
  if (R < 1e-100) return -2.0 * std::numbers::egamma;
  return waveTerm(X, Y).F + 2.0 * std::log(0.5 * (R + Y));
}

}  // namespace cutwater
