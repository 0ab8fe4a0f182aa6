#include "hydro/forces/ExcitationForce.h"

#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {

ExcitationForce::ExcitationForce(const Coefficients& coefficients, const SeaState& sea,
                                 double meanHeading, double meanSpeed)
    : sea_(sea) {
  if (sea.components().empty()) return;
  const WaveExcitation excitation(coefficients);
  phasors_.reserve(sea.components().size());
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const WaveComponent& wave = sea.components()[i];
    // Seen from a ship whose course is turned by ψ̄ to port, a wave towards (cos β, −sin β) travels
    // at the polar angle −β − ψ̄, hence β + ψ̄ relative to her.
    WaveExcitation::Force force;
    try {
      force = excitation.at(wave.omega, wave.heading + meanHeading, meanSpeed);
    } catch (const HydroError& error) {
      throw HydroError(error.fault(), "wave component " + std::to_string(i) + ": " + error.what());
    }
    const double k = sea.waveNumber(i), a = wave.amplitude;
    phasors_.push_back({wave.omega, wave.phase, k * std::cos(wave.heading),
                        -k * std::sin(wave.heading), a * force.froudeKrylov.real(),
                        a * force.froudeKrylov.imag(), a * force.diffraction.real(),
                        a * force.diffraction.imag()});
  }
}

Vec6 ExcitationForce::at(const ShipMotion& motion) noexcept {
  froudeKrylov_.setZero();
  diffraction_.setZero();
  for (const Phasor& p : phasors_) {
    const double phase =
        p.omega * motion.time + p.phase - p.kx * motion.meanX - p.ky * motion.meanY;
    const double c = std::cos(phase), s = std::sin(phase);
    froudeKrylov_ += c * p.fkRe - s * p.fkIm;
    diffraction_ += c * p.diffRe - s * p.diffIm;
  }
  const double grown = sea_.ramp(motion.time);
  froudeKrylov_ *= grown;
  diffraction_ *= grown;
  return froudeKrylov_ + diffraction_;
}

}  // namespace cutwater
