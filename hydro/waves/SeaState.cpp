#include "hydro/waves/SeaState.h"

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/waves/PhaseBlocks.h"

namespace cutwater {

namespace {

void check(bool good, std::size_t index, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange, "SeaState: component " + std::to_string(index) + ": " +
                                               field + " = " + std::to_string(value));
}

using namespace phase_blocks;
constexpr std::size_t kBlock = kPhase + kLanes;

/// Σ a cos(ω t − k_x x − k_y y + ε) over blocks of four.
CUTWATER_VECTOR double sumOfWaves(const double* block, std::size_t count, double t, double x,
                                  double y) noexcept {
  Double4 sum = {};
  for (std::size_t i = 0; i < count; ++i, block += kBlock) {
    sum += load4(block + kPhase) * sineCosine(phaseAt(block, t, x, y)).cosine;
  }
  return sumOf(sum);
}

/// e^{i(ω t − k_x x − k_y y + ε)} of blocks of four.
CUTWATER_VECTOR void phasorsOf(const double* block, std::size_t count, double t, double x, double y,
                               Phasors4* out) noexcept {
  for (std::size_t i = 0; i < count; ++i, block += kBlock) {
    const auto [sine, cosine] = sineCosine(phaseAt(block, t, x, y));
    store4(out[i].re, cosine);
    store4(out[i].im, sine);
  }
}

}  // namespace

SeaState::SeaState(std::vector<WaveComponent> components, double gravity, double ramp)
    : components_(std::move(components)), gravity_(gravity), ramp_(ramp) {
  if (!(gravity > 0.0) || !std::isfinite(gravity)) {
    throw HydroError(Fault::ValueOutOfRange, "SeaState: gravity = " + std::to_string(gravity));
  }
  if (!(ramp >= 0.0) || !std::isfinite(ramp)) {
    throw HydroError(Fault::ValueOutOfRange, "SeaState: ramp = " + std::to_string(ramp));
  }
  waveNumber_.reserve(components_.size());
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    check(c.omega > 0.0 && std::isfinite(c.omega), i, "omega", c.omega);
    check(c.amplitude >= 0.0 && std::isfinite(c.amplitude), i, "amplitude", c.amplitude);
    check(std::isfinite(c.phase), i, "phase", c.phase);
    check(std::isfinite(c.heading), i, "heading", c.heading);
    waveNumber_.push_back(c.omega * c.omega / gravity);
  }
  blocks_ = phaseBlocks(*this, kBlock);
  for (std::size_t i = 0; i < components_.size(); ++i)
    placeOf(blocks_, kBlock, i)[kPhase] = components_[i].amplitude;
}

double SeaState::ramp(double t) const noexcept {
  if (t >= ramp_) return 1.0;
  return t <= 0.0 ? 0.0 : 0.5 * (1.0 - std::cos(kPi * t / ramp_));
}

double SeaState::elevation(double t, double x, double y) const noexcept {
  return ramp(t) * sumOfWaves(blocks_.data(), blocks_.size() / kBlock, t, x, y);
}

std::size_t SeaState::phasorBlocks() const noexcept { return blocks_.size() / kBlock; }

void SeaState::phasors(double t, double x, double y, std::span<Phasors4> out) const noexcept {
  phasorsOf(blocks_.data(), std::min(out.size(), phasorBlocks()), t, x, y, out.data());
}

// A crest moves forward: u = a ω e^{kz} cos θ along the wave, w = −a ω e^{kz} sin θ.
Vec3 SeaState::velocity(double t, const Vec3& place) const noexcept {
  Vec3 sum = Vec3::Zero();
  const double z = std::min(place.z(), 0.0);
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    const double along = place.x() * std::cos(c.heading) - place.y() * std::sin(c.heading);
    const double phase = c.omega * t - waveNumber_[i] * along + c.phase;
    const double speed = c.amplitude * c.omega * std::exp(waveNumber_[i] * z);
    sum += speed * Vec3(std::cos(phase) * std::cos(c.heading),
                        -std::cos(phase) * std::sin(c.heading), -std::sin(phase));
  }
  return ramp(t) * sum;
}

}  // namespace cutwater
