#include "hydro/waves/SeaState.h"

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/Radians.h"
#include "hydro/base/SimdMath.h"

namespace cutwater {

namespace {

void check(bool good, std::size_t index, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange, "SeaState: component " + std::to_string(index) + ": " +
                                               field + " = " + std::to_string(value));
}

/// ω t + ε − k_x x − k_y y of four components.
template <class Block>
CUTWATER_INLINE Double4 phaseAt(const Block& block, double t, double x, double y) noexcept {
  return load4(block.omega) * t + load4(block.phase) - load4(block.kx) * x - load4(block.ky) * y;
}

}  // namespace

SeaState::SeaState(std::vector<WaveComponent> components, double gravity, double ramp,
                   WaveProfile profile)
    : components_(std::move(components)), gravity_(gravity), ramp_(ramp), profile_(profile) {
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
    requireRadians("SeaState: component " + std::to_string(i) + ": heading", c.heading, kTurn);
    waveNumber_.push_back(c.omega * c.omega / gravity);
  }
  blocks_.resize((components_.size() + 3) / 4);
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    Block& block = blocks_[i / 4];
    const std::size_t lane = i % 4;
    block.omega[lane] = c.omega;
    block.phase[lane] = c.phase;
    block.kx[lane] = waveNumber_[i] * std::cos(c.heading);
    block.ky[lane] = -waveNumber_[i] * std::sin(c.heading);
    block.amplitude[lane] = c.amplitude;
  }
}

double SeaState::ramp(double t) const noexcept {
  if (t >= ramp_) return 1.0;
  return t <= 0.0 ? 0.0 : 0.5 * (1.0 - std::cos(kPi * t / ramp_));
}

CUTWATER_VECTOR double SeaState::sumOfWaves(std::span<const Block> blocks, double t, double x,
                                            double y) noexcept {
  Double4 sum = {};
  for (const Block& block : blocks)
    sum += load4(block.amplitude) * sineCosine(phaseAt(block, t, x, y)).cosine;
  return sumOf(sum);
}

double SeaState::elevation(double t, double x, double y) const noexcept {
  return ramp(t) * sumOfWaves(blocks_, t, x, y);
}

double SeaState::elevation(std::span<const Phasors4> phasors) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(blocks_.size(), phasors.size()); ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane)
      sum += blocks_[i].amplitude[lane] * phasors[i].re[lane];
  }
  return sum;
}

CUTWATER_VECTOR void SeaState::phasorsOf(std::span<const Block> blocks, double t, double x,
                                         double y, Phasors4* out) noexcept {
  for (const Block& block : blocks) {
    const auto [sine, cosine] = sineCosine(phaseAt(block, t, x, y));
    store4(out->re, cosine);
    store4(out->im, sine);
    ++out;
  }
}

void SeaState::phasors(double t, double x, double y, std::span<Phasors4> out) const noexcept {
  const std::size_t count = std::min(out.size(), phasorBlocks());
  phasorsOf({blocks_.data(), count}, t, x, y, out.data());
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
