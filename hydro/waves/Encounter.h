#pragma once
#include <cmath>

#include "hydro/waves/Wave.h"

namespace cutwater {

/// How a ship under way meets a regular wave: at which frequency the equations are solved, and what
/// the answer means where the ship overtakes the wave.
///     const Encounter met(wave, speed);
///     const CVec6 answer = solve(met.frequency(), met.conjugatedIfOvertaking(incident));
///     return met.conjugatedIfOvertaking(answer);
///
/// Amplitudes are those of e^{iω′t} with the signed encounter frequency ω′ = ω_I − kU cos β. Added
/// mass, damping and adjoint vectors are known at ω_e = |ω′|. A ship that overtakes the wave
/// (ω′ < 0, following seas with U cos β > g/ω_I) sees its mirror image in time:
/// Re{a e^{iω′t}} = Re{a* e^{iω_e t}}. So the amplitudes of the wave are conjugated, the equations
/// solved at ω_e, and the answers conjugated. At ω′ = 0 both ways agree.
class Encounter {
 public:
  /// @param omegaI ω_I [rad/s].  @param speed U [m/s].
  /// @param heading β [rad].  @param gravity [m/s²].
  Encounter(double omegaI, double speed, double heading, double gravity) noexcept
      : speed_(speed), signed_(encounterFrequency(omegaI, speed, heading, gravity)) {}
  /// The same of a ship that also makes leeway V to port: ω′ = ω_I − k(U cos β − V sin β).
  Encounter(double omegaI, double speed, double leeway, double heading, double gravity) noexcept
      : speed_(speed),
        signed_(encounterFrequency(omegaI, speed, heading, gravity) +
                omegaI * omegaI / gravity * leeway * std::sin(heading)) {}
  Encounter(const AiryWave& wave, double speed) noexcept
      : Encounter(wave.omega, speed, wave.heading, wave.gravity) {}

  /// ω′ [rad/s].
  double signedFrequency() const noexcept { return signed_; }
  /// ω_e = |ω′| [rad/s].
  double frequency() const noexcept { return std::abs(signed_); }
  bool overtaking() const noexcept { return signed_ < 0.0; }
  double speed() const noexcept { return speed_; }

  /// Amplitudes of e^{iω_e t} from those of e^{iω′t}, or the other way round: any Eigen matrix of
  /// complex numbers.
  template <class Matrix>
  Matrix conjugatedIfOvertaking(Matrix amplitudes) const {
    if (overtaking()) amplitudes = amplitudes.conjugate().eval();
    return amplitudes;
  }

  /// Diffraction force from its parts F^ω and F^U, both of the conjugated incident wave where the
  /// ship overtakes it: ω_e F^ω + U F^U, conjugated there.                        [M03] (88)-(91)
  CVec6 diffractionForce(const CVec6& omegaForce, const CVec6& speedForce) const {
    CVec6 sum = frequency() * omegaForce;
    if (speed_ != 0.0) sum += speed_ * speedForce;
    return conjugatedIfOvertaking(sum);
  }

 private:
  double speed_, signed_;
};

}  // namespace cutwater
