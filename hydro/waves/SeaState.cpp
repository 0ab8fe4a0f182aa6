#include "hydro/waves/SeaState.h"

#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

void check(bool good, std::size_t index, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange, "SeaState: component " + std::to_string(index) + ": " +
                                               field + " = " + std::to_string(value));
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
}

double SeaState::ramp(double t) const noexcept {
  if (t >= ramp_) return 1.0;
  return t <= 0.0 ? 0.0 : 0.5 * (1.0 - std::cos(kPi * t / ramp_));
}

double SeaState::elevation(double t, double x, double y) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    const double along = x * std::cos(c.heading) - y * std::sin(c.heading);
    sum += c.amplitude * std::cos(c.omega * t - waveNumber_[i] * along + c.phase);
  }
  return ramp(t) * sum;
}

}  // namespace cutwater
