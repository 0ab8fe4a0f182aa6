#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hydro/base/SimdMath.h"
#include "hydro/database/Interpolation.h"
#include "hydro/excitation/ExcitationTable.h"

namespace cutwater {

namespace {

/// Weights of four evenly spaced nodes −1, 0, 1, 2 at x in [0, 1].
std::array<double, 4> evenCubic(double x) noexcept {
  const double a = x + 1.0, b = x - 1.0, c = x - 2.0;
  return {-x * b * c / 6.0, a * b * c / 2.0, -a * x * c / 2.0, a * x * b / 6.0};
}

/// Rows of a table that are mixed, and their weights.
struct Mixture {
  static constexpr std::size_t kMost = 16;  // four headings of four frequencies
  std::array<const double*, kMost> row;
  std::array<double, kMost> weight;
  std::size_t count = 0;
};

/// Σ weight · row of `count` numbers, a multiple of four.
CUTWATER_VECTOR void mix(const Mixture& rows, std::size_t count, double* sum) noexcept {
  for (std::size_t i = 0; i < count; i += 4) {
    Double4 mixed = {};
    for (std::size_t n = 0; n < rows.count; ++n) mixed += rows.weight[n] * load4(rows.row[n] + i);
    store4(sum + i, mixed);
  }
}

/// Σ b q of complex numbers given as runs of Re and Im, `count` of each, a multiple of four.
CUTWATER_VECTOR void complexDot(const double* b, const double* q, std::size_t count, double* re,
                                double* im) noexcept {
  Double4 real = {}, imaginary = {};
  for (std::size_t i = 0; i < count; i += 4) {
    const Double4 x = load4(b + i), y = load4(b + count + i);
    const Double4 u = load4(q + i), v = load4(q + count + i);
    real += x * u - y * v;
    imaginary += x * v + y * u;
  }
  *re = sumOf(real);
  *im = sumOf(imaginary);
}

/// Six complex numbers given as six real and six imaginary parts.
CVec6 forceIn(const double* numbers) noexcept {
  CVec6 force;
  for (int j = 0; j < 6; ++j) force[j] = Complex(numbers[j], numbers[6 + j]);
  return force;
}

CVec6 notANumber() noexcept {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return CVec6::Constant(Complex(kNan, kNan));
}

}  // namespace

// Cubic over the rows of ω_I and, in each of them, over the headings.
void ExcitationTable::interpolate(double omega, double beta, const Columns& columns,
                                  double* sum) const noexcept {
  Mixture mixture;
  const double turn = beta / (2.0 * kPi), within = turn - std::floor(turn);
  const LocalCubic cubic = localCubic(rowOmega_, omega);
  for (std::size_t i = 0; i < cubic.count; ++i) {
    if (cubic.weight[i] == 0.0) continue;
    const Row& row = rows_[cubic.first + i];
    const double x = within * static_cast<double>(row.headings), floor = std::floor(x);
    const auto weights = evenCubic(x - floor);
    const auto first = static_cast<std::size_t>(floor) + row.headings - 1;
    for (std::size_t n = 0; n < 4; ++n) {
      mixture.row[mixture.count] =
          &values_[row.offset + (first + n) % row.headings * width_ + columns.first];
      mixture.weight[mixture.count++] = cubic.weight[i] * weights[n];
    }
  }
  mix(mixture, columns.count, sum);
}

// Beyond the last node b(∞) + (b(Ω) − b(∞))(Ω/ω)², or what is there held.
ExcitationTable::VectorNodes ExcitationTable::vectorNodes(double omega) const noexcept {
  if (omega >= last_) {
    const double u = last_ / omega, rest = hasInfinity_ ? u * u : 1.0;
    return {{rest, 1.0 - rest, 0.0, 0.0}, {vectorCount_ - 1, vectorCount_, 0, 0}};
  }
  const double x = omega / vectorStep_;
  const double low = std::clamp(std::floor(x), 1.0, static_cast<double>(vectorCount_ - 3));
  const auto first = static_cast<std::size_t>(low) - 1;
  return {evenCubic(x - low), {first, first + 1, first + 2, first + 3}};
}

CVec6 ExcitationTable::fromDirections(double* q, const Encounter& met) const noexcept {
  const auto [weights, nodes] = vectorNodes(met.frequency());
  if (met.overtaking()) {  // of v*
    const std::size_t imaginaryPart[2] = {rank_[0], 2 * rank_[0] + rank_[1]};
    for (std::size_t p = 0; p < 2; ++p) {
      double* im = q + imaginaryPart[p];
      for (std::size_t i = 0; i < rank_[p]; ++i) im[i] = -im[i];
    }
  }
  CVec6 force = CVec6::Zero();
  for (std::size_t n = 0; n < 4; ++n) {
    if (weights[n] == 0.0) continue;
    const double* b = &vectors_[nodes[n] * vectorSize_];
    for (int part = 0; part < 2; ++part) {
      const double share = weights[n] * (part == 0 ? met.frequency() : met.speed());
      for (int mode = 0; mode < 6; ++mode) {
        const std::size_t p = parityOf(mode);
        double re = 0.0, im = 0.0;
        complexDot(b, q + (p == 0 ? 0 : 2 * rank_[0]), rank_[p], &re, &im);
        force[mode] += share * Complex(re, im);
        b += 2 * rank_[p];
      }
    }
  }
  return met.conjugatedIfOvertaking(force);
}

CVec6 ExcitationTable::froudeKrylovOf(double omega, double beta) const noexcept {
  if (!std::isfinite(beta)) return notANumber();
  std::array<double, kForceColumns> sum;
  interpolate(omega, beta, {0, kForceColumns}, sum.data());
  return forceIn(sum.data());
}

CVec6 ExcitationTable::diffractionOf(double omega, double beta, double speed,
                                     double leeway) const noexcept {
  if (!std::isfinite(beta) || !std::isfinite(speed) || !std::isfinite(leeway)) return notANumber();
  std::array<double, std::max(kForceColumns, 4 * kMostDirections)> sum;
  interpolate(omega, beta, {kForceColumns, width_ - kForceColumns}, sum.data());
  if (!hasVectors_) return forceIn(sum.data());
  return fromDirections(sum.data(), Encounter(omega, speed, leeway, beta, sea_.gravity()));
}

CVec6 ExcitationTable::froudeKrylov(std::size_t component, double course) const noexcept {
  const WaveComponent& wave = sea_.components()[component];
  if (!known(wave.omega)) return CVec6::Zero();
  return froudeKrylovOf(wave.omega, wave.heading + course);
}

CVec6 ExcitationTable::diffraction(std::size_t component, double course, double speed,
                                   double leeway) const noexcept {
  const WaveComponent& wave = sea_.components()[component];
  if (!known(wave.omega)) return CVec6::Zero();
  return diffractionOf(wave.omega, wave.heading + course, speed, leeway);
}

}  // namespace cutwater
