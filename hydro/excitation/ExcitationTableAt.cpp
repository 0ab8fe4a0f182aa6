#include <algorithm>
#include <array>
#include <cmath>

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

/// sum += weight · row, `count` a multiple of four.
CUTWATER_VECTOR void addRow(double* sum, const double* row, double weight,
                            std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; i += 4) {
    const Double4 v = load4(sum + i) + weight * load4(row + i);
    store4(sum + i, v);
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

}  // namespace

void ExcitationTable::addHeadings(const Row& row, double beta, double share,
                                  double* sum) const noexcept {
  const auto count = static_cast<double>(row.headings);
  const double turn = beta / (2.0 * kPi), x = (turn - std::floor(turn)) * count;
  const double floor = std::floor(x);
  const auto weights = evenCubic(x - floor);
  const auto first = static_cast<std::size_t>(floor) + row.headings - 1;
  for (std::size_t n = 0; n < 4; ++n) {
    const double* at = &values_[row.offset + (first + n) % row.headings * width_];
    addRow(sum, at, share * weights[n], width_);
  }
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

CVec6 ExcitationTable::diffraction(double* q, const Encounter& met) const noexcept {
  const auto [weights, nodes] = vectorNodes(met.frequency());
  if (met.overtaking()) {  // of v*
    for (std::size_t p = 0, at = rank_[0]; p < 2; ++p, at += rank_[0] + rank_[1])
      for (std::size_t i = 0; i < rank_[p]; ++i) q[at + i] = -q[at + i];
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

ExcitationTable::Amplitude ExcitationTable::at(std::size_t component, double course,
                                               double speed) const noexcept {
  const WaveComponent& wave = sea_.components()[component];
  return atWave(wave.omega, wave.heading + course, speed);
}

ExcitationTable::Amplitude ExcitationTable::atWave(double omega, double beta,
                                                   double speed) const noexcept {
  if (!std::isfinite(beta) || !std::isfinite(speed)) {
    const CVec6 nothing = CVec6::Constant(Complex(std::nan(""), std::nan("")));
    return {nothing, nothing};
  }
  std::array<double, 12 + 4 * kMostDirections> sum;
  std::fill_n(sum.begin(), width_, 0.0);
  const LocalCubic cubic = localCubic(rowOmega_, omega);
  for (std::size_t i = 0; i < cubic.count; ++i) {
    if (cubic.weight[i] != 0.0)
      addHeadings(rows_[cubic.first + i], beta, cubic.weight[i], sum.data());
  }
  Amplitude result;
  for (int j = 0; j < 6; ++j) {
    const auto i = static_cast<std::size_t>(j);
    result.froudeKrylov[j] = Complex(sum[i], sum[6 + i]);
    result.diffraction[j] = Complex(sum[12 + i], sum[18 + i]);
  }
  if (hasVectors_) {
    result.diffraction =
        diffraction(sum.data() + 12, Encounter(omega, speed, beta, sea_.gravity()));
  }
  return result;
}

}  // namespace cutwater
