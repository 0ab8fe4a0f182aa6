#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/Simd.h"
#include "hydro/memory/ExponentialSum.h"

namespace cutwater {

namespace {

/// z ← e z + g v of one mode, `width` poles; width a multiple of four.
CUTWATER_VECTOR void enter(double* re, double* im, const double* advance, double v,
                           std::size_t width) noexcept {
  const double *er = advance, *ei = er + width, *gr = ei + width, *gi = gr + width;
  for (std::size_t m = 0; m < width; ++m) {
    const double a = re[m], b = im[m];
    re[m] = er[m] * a - ei[m] * b + gr[m] * v;
    im[m] = er[m] * b + ei[m] * a + gi[m] * v;
  }
}

/// r = a + U (b + U c).
CUTWATER_VECTOR void combine(double* r, const double* a, const double* b, const double* c, double U,
                             std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) r[i] = a[i] + U * (b[i] + U * c[i]);
}

/// Σ a_i b_i, in one fixed order.
CUTWATER_VECTOR double weighted(const double* a, const double* b, std::size_t count) noexcept {
  double lane[4] = {};
  for (std::size_t i = 0; i < count; i += 4) {
    for (std::size_t l = 0; l < 4; ++l) lane[l] += a[i + l] * b[i + l];
  }
  return (lane[0] + lane[2]) + (lane[1] + lane[3]);
}

bool isTick(double h) { return h > 0.0 && std::isfinite(h); }

}  // namespace

ExponentialMemory::ExponentialMemory(const ExponentialSum& sum, double step)
    : sum_(sum), step_(step), width_(sum.width()) {
  if (!isTick(step)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("ExponentialMemory: step = {} s, must be > 0", step));
  }
  advance_.assign(4 * width_, 0.0);
  states_.assign(6 * 2 * width_, 0.0);
  residues_ = sum.runs(0);
  halfRuns_ = sum.momentumRuns();
  makeAdvance();
}

bool ExponentialMemory::setStep(double h) noexcept {
  if (h == step_) return true;
  if (!isTick(h)) return false;
  step_ = h;
  makeAdvance();
  return true;
}

void ExponentialMemory::makeAdvance() noexcept {
  for (std::size_t m = 0; m < sum_.size(); ++m) {
    const Complex s = sum_.poles()[m], e = std::exp(s * step_), g = (e - 1.0) / s;
    advance_[m] = e.real();
    advance_[width_ + m] = e.imag();
    advance_[2 * width_ + m] = g.real();
    advance_[3 * width_ + m] = g.imag();
  }
}

// After half a tick more of velocity v the states are e^{s h/2} z + (e^{s h/2} − 1)/s v.
void ExponentialMemory::lookAhead(double half) noexcept {
  if (half == half_) return;
  half_ = half;
  newest_.setZero();
  std::array<Complex, ExponentialSum::kMostPoles> later, gain;
  for (std::size_t m = 0; m < sum_.size(); ++m) {
    const Complex s = sum_.poles()[m];
    later[m] = std::exp(s * half);
    gain[m] = (later[m] - 1.0) / s;
  }
  const std::vector<double>& runs = sum_.momentumRuns();
  std::size_t at = 0;
  for (const ExponentialSum::Pair& pair : sum_.pairs()) {
    for (std::size_t m = 0; m < sum_.size(); ++m) {
      const Complex residue(runs[at + m], -runs[at + width_ + m]), ahead = residue * later[m];
      halfRuns_[at + m] = ahead.real();
      halfRuns_[at + width_ + m] = -ahead.imag();
      newest_(pair.j, pair.k) += (residue * gain[m]).real();
    }
    at += 2 * width_;
  }
}

void ExponentialMemory::weigh(double speed) noexcept {
  combine(residues_.data(), sum_.runs(0).data(), sum_.runs(1).data(), sum_.runs(2).data(), speed,
          residues_.size());
  weighed_ = speed;
}

void ExponentialMemory::enterAll(const Vec6& etaDot) noexcept {
  for (std::size_t k = 0; k < 6; ++k) {
    double* z = states_.data() + 2 * k * width_;
    enter(z, z + width_, advance_.data(), etaDot[static_cast<int>(k)], width_);
  }
}

Vec6 ExponentialMemory::sumOver(const std::vector<double>& runs) const noexcept {
  Vec6 sum = Vec6::Zero();
  const double* residues = runs.data();
  for (const ExponentialSum::Pair& pair : sum_.pairs()) {
    const double* z = states_.data() + static_cast<std::size_t>(2 * pair.k) * width_;
    sum[pair.j] += weighted(residues, z, 2 * width_);
    residues += 2 * width_;
  }
  return sum;
}

Vec6 ExponentialMemory::momentum(const Vec6& velocity, double next) noexcept {
  enterAll(velocity);
  lookAhead(0.5 * next);
  return sumOver(halfRuns_) + newest_ * velocity;
}

// ∫₀^∞ e^{sτ} dτ = −1/s.
void ExponentialMemory::addSteady(const Vec6& velocity) noexcept {
  for (std::size_t k = 0; k < 6; ++k) {
    double* z = states_.data() + 2 * k * width_;
    for (std::size_t m = 0; m < sum_.size(); ++m) {
      const Complex past = -velocity[static_cast<int>(k)] / sum_.poles()[m];
      z[m] += past.real();
      z[width_ + m] += past.imag();
    }
  }
}

Vec6 ExponentialMemory::advance(const Vec6& etaDot, double speed) noexcept {
  if (speed != weighed_) weigh(speed);
  enterAll(etaDot);
  return sumOver(residues_);
}

RadiationMemory::Parts ExponentialMemory::advanceParts(const Vec6& etaDot) noexcept {
  enterAll(etaDot);
  return {sumOver(sum_.runs(0)), sumOver(sum_.runs(1)), sumOver(sum_.runs(2))};
}

void ExponentialMemory::reset() noexcept { std::fill(states_.begin(), states_.end(), 0.0); }

void ExponentialMemory::save(std::span<double> state) const noexcept {
  state[0] = step_;
  std::copy(states_.begin(), states_.end(), state.begin() + 1);
}

bool ExponentialMemory::fits(std::span<const double> state) const noexcept {
  return state.size() == stateSize() && isTick(state[0]);
}

void ExponentialMemory::restore(std::span<const double> state) {
  if (!fits(state)) {
    throw HydroError(Fault::BadArgument,
                     fmt::format("ExponentialMemory::restore: not a state of this memory, which "
                                 "has {} numbers, the first of them a length of tick; got {}",
                                 stateSize(), state.size()));
  }
  setStep(state[0]);
  std::copy(state.begin() + 1, state.end(), states_.begin());
}

}  // namespace cutwater
