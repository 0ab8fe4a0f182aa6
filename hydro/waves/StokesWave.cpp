#include "hydro/waves/StokesWave.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

[[noreturn]] void refuseSteepWave(const std::string& what) {
  throw HydroError(Fault::ValueOutOfRange, "StokesWave: " + what);
}

// ω/√(gk).
double stretch(double steepness, int order) {
  const double square = steepness * steepness;
  return 1.0 + 0.5 * square + (order == 2 ? 0.0 : 0.125 * square * square);
}

// k with ω = √(gk) stretch(ka), by going half of the way each time: k falls where its stretch
// grows.
double waveNumberFor(double omega, double amplitude, double gravity, int order) {
  double k = omega * omega / gravity;
  for (int i = 0; i < 100; ++i) {
    const double s = stretch(k * amplitude, order);
    const double next = omega * omega / (gravity * s * s);
    if (std::abs(next - k) <= 1e-15 * k) return next;
    k = 0.5 * (k + next);
  }
  return k;
}

}  // namespace

StokesWave::StokesWave(double omega, double amplitude, double gravity, int order)
    : omega_(omega),
      amplitude_(amplitude),
      gravity_(gravity),
      k_(waveNumberFor(omega, amplitude, gravity, order)),
      order_(order) {
  if (order != 2 && order != 5)
    refuseSteepWave("order = " + std::to_string(order) + ": there are 2 and 5");
  if (!(steepness() <= kSteepest))
    refuseSteepWave("amplitude = " + std::to_string(amplitude) +
                    " m at omega = " + std::to_string(omega) +
                    " rad/s: the wave would be steeper, ka = " + std::to_string(steepness()) +
                    ", than any that does not break, 0.443");
}

StokesWave::Series StokesWave::series(double growth) const noexcept {
  const double e = growth * steepness(), e2 = e * e, e3 = e2 * e, e4 = e2 * e2, e5 = e4 * e;
  Series s;
  s.waveNumber = k_;
  s.gravity = gravity_;
  s.phaseSpeed = omega_ / k_;
  if (order_ == 2) {
    s.elevation = {e, 0.5 * e2};
    s.speed = {e};
  } else {
    s.elevation = {e - 0.375 * e3 - 422.0 / 384.0 * e5, 0.5 * e2 + e4 / 3.0,
                   0.375 * e3 + 297.0 / 384.0 * e5, e4 / 3.0, 125.0 / 384.0 * e5};
    s.speed = {e - 0.5 * e3 - 37.0 / 24.0 * e5, e4, 0.25 * e5};
  }
  for (double& height : s.elevation) height /= k_;
  for (double& speed : s.speed) speed *= std::sqrt(gravity_ / k_);
  return s;
}

double StokesWave::Series::elevationAt(double theta) const noexcept {
  double sum = 0.0;
  for (std::size_t n = 0; n < kHarmonics; ++n)
    sum += elevation[n] * std::cos(static_cast<double>(n + 1) * theta);
  return sum;
}

double StokesWave::Series::slopeAt(double theta) const noexcept {
  double sum = 0.0;
  for (std::size_t n = 0; n < kHarmonics; ++n) {
    const double m = static_cast<double>(n + 1);
    sum += m * waveNumber * elevation[n] * std::sin(m * theta);
  }
  return sum;
}

std::array<double, 2> StokesWave::Series::velocityAt(double theta, double z) const noexcept {
  std::array<double, 2> sum{};
  for (std::size_t n = 0; n < kFlowHarmonics; ++n) {
    const double m = static_cast<double>(n + 1);
    const double size = speed[n] * std::exp(m * waveNumber * z);
    sum[0] += size * std::cos(m * theta);
    sum[1] -= size * std::sin(m * theta);
  }
  return sum;
}

std::array<double, 2> StokesWave::Series::velocityRateAt(double theta, double z) const noexcept {
  std::array<double, 2> sum{};
  for (std::size_t n = 0; n < kFlowHarmonics; ++n) {
    const double m = static_cast<double>(n + 1);
    const double size = m * waveNumber * phaseSpeed * speed[n] * std::exp(m * waveNumber * z);
    sum[0] -= size * std::sin(m * theta);
    sum[1] -= size * std::cos(m * theta);
  }
  return sum;
}

// −∂φ/∂t is the phase speed times the velocity along the wave: the wave does not change.
double StokesWave::Series::headAt(double theta, double z) const noexcept {
  const auto [along, up] = velocityAt(theta, z);
  return (phaseSpeed * along - 0.5 * (along * along + up * up)) / gravity;
}

}  // namespace cutwater
