#include "hydro/forces/floats/FloatWater.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/SimdMath.h"

namespace cutwater {

FloatWater::FloatWater(const SeaState& sea) : sea_(sea), phasors_(sea.components().size()) {
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& c = sea.components()[i];
    const double k = sea.waveNumber(i), x = std::cos(c.heading), y = -std::sin(c.heading);
    waves_.push_back({k, k * x, k * y, c.amplitude, c.omega * c.amplitude, 0.0, x, y});
  }
}

CUTWATER_VECTOR void FloatWater::sum(std::span<const Wave> waves, WaveProfile profile,
                                     Four* phasors, Block& block) noexcept {
  const Double4 x = load4(block.x), y = load4(block.y), z = load4(block.z);
  const Double4 reach = load4(block.reach), none = {};
  Double4 zeta = {};
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const Wave& w = waves[i];
    const auto [sine, cosine] = sineCosine(w.phase - w.kx * x - w.ky * y);
    zeta += w.amplitude * cosine;
    store4(phasors[i].sine, sine);
    store4(phasors[i].cosine, cosine);
  }
  const Double4 below = z < zeta ? z : zeta;
  Double4 level = below;
  if (profile == WaveProfile::Wheeler) level = below - zeta;
  if (profile == WaveProfile::Constant) level = z < none ? z : none;
  Double4 u = {}, v = {}, w3 = {}, ux = {}, uy = {}, vy = {}, uz = {}, vz = {};
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const Wave& w = waves[i];
    const Double4 speed = w.speed * boundedExponential(w.k * level);
    const Double4 cosine = speed * load4(phasors[i].cosine);
    const Double4 sine = speed * load4(phasors[i].sine);
    const Double4 k = w.k / atLeast(w.k * reach, 1.0);
    u += w.alongX * cosine;
    v += w.alongY * cosine;
    w3 -= sine;
    ux += w.alongX * w.alongX * k * sine;
    uy += w.alongX * w.alongY * k * sine;
    vy += w.alongY * w.alongY * k * sine;
    uz += w.alongX * k * cosine;
    vz += w.alongY * k * cosine;
  }
  const Double4 sums[8] = {u, v, w3, ux, uy, vy, uz, vz};
  for (std::size_t i = 0; i < 8; ++i) store4(block.sums[i], sums[i]);
}

// Phases lose their whole turns once a tick, so that long runs cost no digits.
void FloatWater::motion(double time, std::span<const Place> places,
                        std::span<Motion> water) noexcept {
  const SeaState::Growths growths = sea_.growths(time);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const WaveComponent& c = sea_.components()[i];
    waves_[i].phase = std::remainder(c.omega * time + c.phase, 2.0 * kPi);
    waves_[i].amplitude = sea_.amplitude(i, growths);
    waves_[i].speed = waves_[i].amplitude * c.omega;
  }
  if (sea_.stokes()) {
    motionOfSteep(time, places, water);
    return;
  }
  for (std::size_t first = 0; first < places.size(); first += 4) {
    Block block;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Place& place = places[std::min(first + lane, places.size() - 1)];
      block.x[lane] = place.at.x();
      block.y[lane] = place.at.y();
      block.z[lane] = place.at.z();
      block.reach[lane] = place.reach;
    }
    sum(waves_, sea_.profile(), phasors_.data(), block);
    for (std::size_t lane = 0; lane < 4 && first + lane < places.size(); ++lane) {
      const auto at = [&](std::size_t i) { return block.sums[i][lane]; };
      Motion& one = water[first + lane];
      one.velocity = Vec3(at(0), at(1), at(2));
      one.gradient << at(3), at(4), at(6), at(4), at(5), at(7), at(6), at(7), -at(3) - at(5);
      one.convective = one.gradient * one.velocity;
    }
  }
}

// That of its series, of which ∂/∂s along the wave is −∂/∂t over its speed.
void FloatWater::motionOfSteep(double time, std::span<const Place> places,
                               std::span<Motion> water) const noexcept {
  const StokesWave::Series series = sea_.stokes()->series(sea_.growth(0, time));
  const Wave& wave = waves_.front();
  const Vec3 along(wave.alongX, wave.alongY, 0.0), up = Vec3::UnitZ();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3& at = places[i].at;
    const double theta = wave.phase - wave.kx * at.x() - wave.ky * at.y();
    const double z = std::min(at.z(), series.elevationAt(theta));
    const auto velocity = series.velocityAt(theta, z), rate = series.velocityRateAt(theta, z);
    const double c = series.phaseSpeed * std::max(1.0, wave.k * places[i].reach);
    const double us = -rate[0] / c, ws = -rate[1] / c;
    water[i].velocity = velocity[0] * along + velocity[1] * up;
    water[i].gradient = us * (along * along.transpose() - up * up.transpose()) +
                        ws * (along * up.transpose() + up * along.transpose());
    water[i].convective.setZero();
  }
}

}  // namespace cutwater
