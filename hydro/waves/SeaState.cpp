#include "hydro/waves/SeaState.h"

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/Fnv1a.h"
#include "hydro/base/Radians.h"
#include "hydro/base/SimdMath.h"

namespace cutwater {

namespace {

void check(bool good, std::size_t index, const char* field, double value) {
  if (good) return;
  throw HydroError(Fault::ValueOutOfRange, "SeaState: component " + std::to_string(index) + ": " +
                                               field + " = " + std::to_string(value));
}

double smoothRamp(double t, double ramp) {
  if (t >= ramp) return 1.0;
  return t <= 0.0 ? 0.0 : 0.5 * (1.0 - std::cos(kPi * t / ramp));
}

/// ω t + ε − k_x x − k_y y of four components.
template <class Block>
CUTWATER_INLINE Double4 phaseAt(const Block& block, double t, double x, double y) noexcept {
  return load4(block.omega) * t + load4(block.phase) - load4(block.kx) * x - load4(block.ky) * y;
}

template <class Block>
CUTWATER_INLINE Double4 amplitudeAt(const Block& block, const auto& growths) noexcept {
  const Double4 growth{growths[block.layer[0]], growths[block.layer[1]], growths[block.layer[2]],
                       growths[block.layer[3]]};
  return growth * load4(block.amplitude);
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
  layerOf_.resize(components_.size(), 0);
  fillBlocks();
}

void SeaState::fillBlocks() {
  blocks_.assign((components_.size() + 3) / 4, {});
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    Block& block = blocks_[i / 4];
    const std::size_t lane = i % 4;
    block.omega[lane] = c.omega;
    block.phase[lane] = c.phase;
    block.kx[lane] = waveNumber_[i] * std::cos(c.heading);
    block.ky[lane] = -waveNumber_[i] * std::sin(c.heading);
    block.amplitude[lane] = c.amplitude;
    block.k[lane] = waveNumber_[i];
    block.layer[lane] = layerOf_[i];
  }
}

SeaState SeaState::steep(const WaveComponent& wave, double gravity, int order, double ramp) {
  SeaState sea({wave}, gravity, ramp);
  if (order == 1) return sea;
  sea.stokes_.emplace(wave.omega, wave.amplitude, gravity, order);
  sea.order_ = order;
  sea.waveNumber_.front() = sea.stokes_->waveNumber();
  sea.fillBlocks();
  return sea;
}

SeaState SeaState::goingOver(const SeaState& next, double from, double seconds) const {
  const auto refuse = [](const std::string& what) {
    throw HydroError(Fault::BadArgument, "SeaState::goingOver: " + what);
  };
  if (!std::isfinite(from) || !(seconds > 0.0) || !std::isfinite(seconds)) {
    throw HydroError(Fault::ValueOutOfRange, "SeaState::goingOver: from = " + std::to_string(from) +
                                                 " s, in seconds = " + std::to_string(seconds));
  }
  const bool both = !components_.empty() && !next.components_.empty();
  if (both && gravity_ != next.gravity_) refuse("the two seas' gravities differ");
  if (both && profile_ != next.profile_)
    refuse("the two seas' profiles differ: give both the same WaveProfile");
  if (both && (stokes_ || next.stokes_))
    refuse("a steep wave goes over to calm water only, and calm water to it");
  if (!next.layers_.empty()) refuse("the next sea is one that goes over itself");
  SeaState sea = next.components_.empty() ? *this : next;  // gravity, profile, order
  sea.components_ = components_;
  sea.components_.insert(sea.components_.end(), next.components_.begin(), next.components_.end());
  sea.waveNumber_ = waveNumber_;
  sea.waveNumber_.insert(sea.waveNumber_.end(), next.waveNumber_.begin(), next.waveNumber_.end());
  sea.layers_ = layers_;
  if (sea.layers_.empty()) sea.layers_.push_back({ramp_, {}, {}});
  sea.change_ = std::make_shared<Change>(Change{from, seconds});
  for (Layer& layer : sea.layers_) {
    if (!layer.goes) layer.goes = sea.change_;
  }
  if (sea.layers_.size() == kMostLayers) refuse("too many seas at once: wait until one has gone");
  sea.layers_.push_back({next.ramp_, sea.change_, {}});
  sea.layerOf_ = layerOf_;
  sea.layerOf_.resize(sea.components_.size(), static_cast<std::uint8_t>(sea.layers_.size() - 1));
  sea.ramp_ = 0.0;
  sea.fillBlocks();
  return sea;
}

void SeaState::goesOverFrom(double from) const noexcept {
  if (change_) change_->from = from;
}

std::uint64_t SeaState::key() const noexcept {
  Fnv1a key;
  const auto add = [&](double value) { key.add(&value, sizeof value); };
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& c = components_[i];
    for (const double value : {c.omega, c.amplitude, c.phase, c.heading}) add(value);
    add(static_cast<double>(layerOf_[i]));
  }
  for (const double value :
       {gravity_, ramp_, static_cast<double>(profile_), static_cast<double>(order_)})
    add(value);
  for (const Layer& layer : layers_) {
    add(layer.ramp);
    for (const auto& change : {layer.comes, layer.goes}) {
      add(change ? change->from : -1.0);
      add(change ? change->seconds : -1.0);
    }
  }
  return key.value();
}

// ½πq.
double SeaState::Change::angle(double t) const noexcept {
  const double s = std::clamp((t - from) / seconds, 0.0, 1.0);
  return 0.5 * kPi * s * s * s * (10.0 - s * (15.0 - 6.0 * s));
}

double SeaState::Layer::growth(double t) const noexcept {
  double all = smoothRamp(t, ramp);
  if (comes) all *= std::sin(comes->angle(t));
  if (goes) all *= t >= goes->from + goes->seconds ? 0.0 : std::cos(goes->angle(t));
  return all;
}

SeaState::Growths SeaState::growths(double t) const noexcept {
  Growths all{};
  all[0] = smoothRamp(t, ramp_);
  for (std::size_t i = 0; i < layers_.size(); ++i) all.at(i) = layers_[i].growth(t);
  return all;
}

double SeaState::growth(std::size_t i, double t) const noexcept {
  return layers_.empty() ? smoothRamp(t, ramp_) : layers_[layerOf_[i]].growth(t);
}

double SeaState::ramp(double t) const noexcept {
  return layers_.empty() ? smoothRamp(t, ramp_) : 1.0;
}

CUTWATER_VECTOR double SeaState::sumOfWaves(std::span<const Block> blocks, const Growths& growths,
                                            double t, double x, double y) noexcept {
  Double4 sum = {};
  for (const Block& block : blocks)
    sum += amplitudeAt(block, growths) * sineCosine(phaseAt(block, t, x, y)).cosine;
  return sumOf(sum);
}

double SeaState::phaseOfSteep(double t, double x, double y) const noexcept {
  const Block& block = blocks_.front();
  return block.omega[0] * t + block.phase[0] - block.kx[0] * x - block.ky[0] * y;
}

double SeaState::elevation(double t, double x, double y) const noexcept {
  if (stokes_) return stokes_->series(growth(0, t)).elevationAt(phaseOfSteep(t, x, y));
  return sumOfWaves(blocks_, growths(t), t, x, y);
}

double SeaState::elevation(std::span<const Phasors4> phasors, double t) const noexcept {
  if (stokes_ && !phasors.empty())
    return stokes_->series(growth(0, t))
        .elevationAt(std::atan2(phasors.front().im[0], phasors.front().re[0]));
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(blocks_.size(), phasors.size()); ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane)
      sum += blocks_[i].amplitude[lane] * phasors[i].re[lane];
  }
  return ramp(t) * sum;
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
  if (layers_.empty()) return;
  const Growths growth = growths(t);
  for (std::size_t i = 0; i < std::min(4 * count, layerOf_.size()); ++i) {
    out[i / 4].re[i % 4] *= growth[layerOf_[i]];
    out[i / 4].im[i % 4] *= growth[layerOf_[i]];
  }
}

// A crest moves forward: u = a ω e^{kz} cos θ along the wave, w = −a ω e^{kz} sin θ. k_x/k and
// k_y/k are where it goes: ω k_x/k = k_x g/ω of linear waves, but of what has no ω.
CUTWATER_VECTOR OrbitalMotion SeaState::motionOf(std::span<const Block> blocks,
                                                 const Growths& growths, double t,
                                                 const Vec3& place) noexcept {
  const double z = place.z() < 0.0 ? place.z() : 0.0;
  Double4 sums[6] = {};
  for (const Block& block : blocks) {
    const auto [sine, cosine] = sineCosine(phaseAt(block, t, place.x(), place.y()));
    const Double4 omega = load4(block.omega), k = load4(block.k);
    const Double4 speed = amplitudeAt(block, growths) * omega * boundedExponential(k * z);
    const Double4 least = atLeast(k, 1e-300);
    const Double4 alongX = load4(block.kx) / least, alongY = load4(block.ky) / least;
    const Double4 level = speed * cosine, rise = -speed * sine;
    sums[0] += level * alongX;
    sums[1] += level * alongY;
    sums[2] += rise;
    sums[3] += omega * rise * alongX;
    sums[4] += omega * rise * alongY;
    sums[5] -= omega * level;
  }
  return {{sumOf(sums[0]), sumOf(sums[1]), sumOf(sums[2])},
          {sumOf(sums[3]), sumOf(sums[4]), sumOf(sums[5])}};
}

OrbitalMotion SeaState::motion(double t, const Vec3& place) const noexcept {
  if (!stokes_) return motionOf(blocks_, growths(t), t, place);
  const StokesWave::Series series = stokes_->series(growth(0, t));
  const double theta = phaseOfSteep(t, place.x(), place.y());
  const double z = std::min(place.z(), series.elevationAt(theta));
  const Block& block = blocks_.front();
  const Vec3 towards(block.kx[0] / block.k[0], block.ky[0] / block.k[0], 0.0);
  const auto velocity = series.velocityAt(theta, z), rate = series.velocityRateAt(theta, z);
  return {velocity[0] * towards + velocity[1] * Vec3::UnitZ(),
          rate[0] * towards + rate[1] * Vec3::UnitZ()};
}

}  // namespace cutwater
