#include "hydro/memory/Convolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/memory/RetardationMatrix.h"

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

ConvolutionWeights::ConvolutionWeights(const RetardationMatrix& retardation, double step,
                                       double duration)
    : step_(step),
      length_(ticksOf(step, duration == 0.0 ? 2.0 * retardation.duration() : duration)),
      ring_((length_ + kLanes - 1) / kLanes * kLanes) {
  std::vector<SpeedKernels> cells;
  cells.reserve(length_);
  std::array<Mat6, 3> size{Mat6::Zero(), Mat6::Zero(), Mat6::Zero()};
  for (std::size_t i = 0; i < length_; ++i) {
    const double begin = static_cast<double>(i) * step_;
    cells.push_back(retardation.integrals(begin, begin + step_));
    for (std::size_t part = 0; part < 3; ++part)
      size[part] = size[part].cwiseMax(cells.back()[part].cwiseAbs());
  }
  for (int n = 0; n < 36; ++n) {
    const int j = n / 6, k = n % 6;
    const Pair pair{
        j,
        k,
        pairs_.size() * ring_,
        {size[0](j, k) > 0.0, size[1](j, k) > 0.0, size[2](j, k) > 0.0, size[0](j, k) > 0.0}};
    if (pair.holds[0] || pair.holds[1] || pair.holds[2]) pairs_.push_back(pair);
  }
  fill(cells, retardation.linearTotal());
  fillMomentum(retardation);
}

// The newest velocity stands for the half tick that is looked ahead as well.
void ConvolutionWeights::fillMomentum(const RetardationMatrix& retardation) {
  std::vector<Mat6> cells;
  for (std::size_t i = 0; i < length_; ++i) {
    const double end = (static_cast<double>(i) + 1.5) * step_;
    cells.push_back(retardation.momentumIntegral(i == 0 ? 0.0 : end - step_, end));
  }
  const Mat6 total = retardation.momentumIntegral(0.0, HUGE_VAL);
  for (const Pair& pair : pairs_) {
    if (!pair.holds[3]) continue;
    double* run = weights_[3].data() + pair.offset;
    double sum = 0.0;
    for (std::size_t i = 0; i < length_; ++i) sum += run[i] = cells[i](pair.j, pair.k);
    balance(run, total(pair.j, pair.k) - sum);
  }
}

void ConvolutionWeights::fill(const std::vector<SpeedKernels>& cells, const Mat6& linearTotal) {
  for (auto& part : weights_) part.assign(pairs_.size() * ring_, 0.0);
  const Mat6 total[2] = {Mat6::Zero(), linearTotal};
  for (const Pair& pair : pairs_)
    for (std::size_t part = 0; part < 3; ++part) {
      double* run = weights_[part].data() + pair.offset;
      double sum = 0.0;
      for (std::size_t i = 0; i < length_; ++i) sum += run[i] = -cells[i][part](pair.j, pair.k);
      if (pair.holds[part] && part < 2) balance(run, -sum - total[part](pair.j, pair.k));
    }
}

void ConvolutionWeights::balance(double* run, double missing) const {
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

Convolution::Convolution(std::shared_ptr<const ConvolutionWeights> weights)
    : weights_(std::move(weights)), past_(6 * 2 * weights_->ring(), 0.0) {}

void Convolution::enter(const Vec6& etaDot) noexcept {
  const std::size_t size = weights_->ring();
  next_ = (next_ == 0 ? size : next_) - 1;
  for (std::size_t mode = 0; mode < 6; ++mode) {
    double* ring = ringOf(mode);
    ring[next_] = ring[next_ + size] = etaDot(static_cast<int>(mode));
  }
}

Vec6 Convolution::force(std::size_t part) noexcept {
  Vec6 force = Vec6::Zero();
  for (const auto& pair : weights_->pairs()) {
    if (!pair.holds[part]) continue;
    force(pair.j) += dotProduct(weights_->run(part, pair),
                                ringOf(static_cast<std::size_t>(pair.k)) + next_, weights_->ring());
  }
  return force;
}

Vec6 Convolution::advance(const Vec6& etaDot, double speed) noexcept {
  enter(etaDot);
  return speed == 0.0 ? force(0) : Parts{force(0), force(1), force(2)}.at(speed);
}

RadiationMemory::Parts Convolution::advanceParts(const Vec6& etaDot) noexcept {
  enter(etaDot);
  return {force(0), force(1), force(2)};
}

Vec6 Convolution::momentum(const Vec6& velocity, double /*next*/) noexcept {
  enter(velocity);
  return force(3);
}

void Convolution::addSteady(const Vec6& velocity) noexcept {
  const auto twice = static_cast<std::ptrdiff_t>(2 * weights_->ring());
  for (std::size_t mode = 0; mode < 6; ++mode) {
    double* ring = ringOf(mode);
    std::for_each(ring, ring + twice, [&](double& v) { v += velocity[static_cast<int>(mode)]; });
  }
}

void Convolution::reset() noexcept { std::fill(past_.begin(), past_.end(), 0.0); }

void Convolution::save(std::span<double> state) const noexcept {
  const std::size_t ring = weights_->ring();
  state[0] = weights_->step();
  state[1] = static_cast<double>(next_);
  for (std::size_t mode = 0; mode < 6; ++mode) {
    std::copy_n(past_.data() + mode * 2 * ring, ring, state.data() + 2 + mode * ring);
  }
}

bool Convolution::fits(std::span<const double> state) const noexcept {
  return state.size() == stateSize() && state[0] == weights_->step() && state[1] >= 0.0 &&
         state[1] < static_cast<double>(weights_->ring());
}

void Convolution::restore(std::span<const double> state) {
  const std::size_t ring = weights_->ring();
  if (!fits(state)) {
    const double step = state.empty() ? 0.0 : state[0];
    throw HydroError(Fault::BadArgument,
                     fmt::format("Convolution::restore: a state of {} numbers and ticks of {} s; "
                                 "this memory has {}, and ticks of {} s",
                                 state.size(), step, stateSize(), weights_->step()));
  }
  next_ = static_cast<std::size_t>(state[1]);
  for (std::size_t mode = 0; mode < 6; ++mode) {
    for (const std::size_t half : {std::size_t{0}, ring}) {
      std::copy_n(state.data() + 2 + mode * ring, ring, ringOf(mode) + half);
    }
  }
}

}  // namespace cutwater
