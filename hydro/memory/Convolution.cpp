#include "hydro/memory/Convolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/memory/RetardationFunction.h"

namespace cutwater {

namespace {

constexpr std::size_t kLanes = 8;
constexpr double kMostTicks = 1e6;

/// Σ a_i b_i of a multiple of eight terms, added in one fixed order wherever the runs lie in
/// memory, so that a restored ring gives the same bits.
double dotProduct(const double* a, const double* b, std::size_t n) noexcept {
  double lane[kLanes] = {};
  for (std::size_t i = 0; i < n; i += kLanes) {
    for (std::size_t l = 0; l < kLanes; ++l) lane[l] += a[i + l] * b[i + l];
  }
  return ((lane[0] + lane[4]) + (lane[1] + lane[5])) + ((lane[2] + lane[6]) + (lane[3] + lane[7]));
}

std::size_t ticksOf(double step, double duration) {
  if (!std::isfinite(step) || step <= 0.0) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("Convolution: step = {} s, must be > 0", step));
  }
  const double ticks = std::ceil(duration / step - 1e-9);
  if (!(duration >= 0.0) || !(ticks <= kMostTicks)) {
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("Convolution: duration = {} s is negative or more than {:.0f} ticks "
                    "of {} s",
                    duration, kMostTicks, step));
  }
  return std::max<std::size_t>(1, static_cast<std::size_t>(ticks));
}

}  // namespace

Convolution::Convolution(const RetardationMatrix& retardation, double step, double duration)
    : step_(step),
      length_(ticksOf(step, duration == 0.0 ? retardation.duration() : duration)),
      ring_((length_ + kLanes - 1) / kLanes * kLanes),
      past_(6 * 2 * ring_, 0.0) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 6; ++k) {
      if (!retardation.isZero(j, k)) pairs_.push_back({j, k, pairs_.size() * ring_});
    }
  }
  weights_.assign(pairs_.size() * ring_, 0.0);
  Mat6 before = Mat6::Zero();
  for (std::size_t i = 0; i < length_; ++i) {
    const Mat6 after = retardation.integral(static_cast<double>(i + 1) * step_);
    for (const Pair& pair : pairs_) {
      weights_[pair.offset + i] = before(pair.j, pair.k) - after(pair.j, pair.k);
    }
    before = after;
  }
  for (const Pair& pair : pairs_) balance(&weights_[pair.offset], before(pair.j, pair.k));
}

void Convolution::balance(double* run, double missing) const {
  const std::size_t width = std::max<std::size_t>(1, length_ / 4), first = length_ - width;
  std::vector<double> bump(width);
  double sum = 0.0;
  for (std::size_t i = 0; i < width; ++i) {
    bump[i] =
        1.0 - std::cos(2.0 * kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(width));
    sum += bump[i];
  }
  for (std::size_t i = 0; i < width; ++i) run[first + i] += missing * bump[i] / sum;
}

Vec6 Convolution::advance(const Vec6& etaDot) noexcept {
  next_ = (next_ == 0 ? ring_ : next_) - 1;
  for (int mode = 0; mode < 6; ++mode) {
    double* ring = ringOf(mode);
    ring[next_] = ring[next_ + ring_] = etaDot(mode);
  }
  Vec6 force = Vec6::Zero();
  for (const Pair& pair : pairs_) {
    force(pair.j) += dotProduct(&weights_[pair.offset], ringOf(pair.k) + next_, ring_);
  }
  return force;
}

void Convolution::reset() noexcept { std::fill(past_.begin(), past_.end(), 0.0); }

Convolution::Snapshot Convolution::save() const {
  Snapshot snapshot{std::vector<Vec6>(ring_), next_, step_};
  for (std::size_t i = 0; i < ring_; ++i) {
    for (std::size_t mode = 0; mode < 6; ++mode) {
      snapshot.past[i](static_cast<int>(mode)) = past_[mode * 2 * ring_ + i];
    }
  }
  return snapshot;
}

void Convolution::restore(const Snapshot& snapshot) {
  if (snapshot.past.size() != ring_ || snapshot.next >= ring_ || snapshot.step != step_) {
    throw HydroError(
        Fault::BadArgument,
        fmt::format("Convolution::restore: snapshot of {} ticks of {} s at place {}, this "
                    "memory has {} of {} s",
                    snapshot.past.size(), snapshot.step, snapshot.next, ring_, step_));
  }
  for (std::size_t i = 0; i < ring_; ++i) {
    for (int mode = 0; mode < 6; ++mode) {
      double* ring = ringOf(mode);
      ring[i] = ring[i + ring_] = snapshot.past[i](mode);
    }
  }
  next_ = snapshot.next;
}

}  // namespace cutwater
