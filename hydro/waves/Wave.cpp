#include "hydro/waves/Wave.h"

#include <cmath>

namespace cutwater {

double encounterFrequency(double omegaI, double speed, double heading, double gravity) noexcept {
  return omegaI - omegaI * omegaI / gravity * speed * std::cos(heading);
}

Complex AiryWave::shape(const Vec3& x) const noexcept {
  const double k = waveNumber();
  const double phase = -k * (x.x() * std::cos(heading) - x.y() * std::sin(heading));
  return std::polar(std::exp(k * x.z()), phase);
}

Eigen::Vector3cd AiryWave::exponent() const noexcept {
  const double k = waveNumber();
  return {Complex(0.0, -k * std::cos(heading)), Complex(0.0, k * std::sin(heading)), k};
}

Complex AiryWave::potential(const Vec3& x) const noexcept {
  return Complex(0.0, gravity / omega) * shape(x);
}

Eigen::Vector3cd AiryWave::velocity(const Vec3& x) const noexcept {
  return potential(x) * exponent();
}

}  // namespace cutwater
