#pragma once
#include "hydro/Conventions.h"

namespace cutwater {

/// The frequency at which a ship of speed U meets the wave:
///     ω′ = ω_I − kU cos β,   k = ω_I²/g                                           [M03] (3)
/// Negative where the ship overtakes the wave (following seas, U cos β > g/ω_I): Encounter.h.
/// @param omegaI [rad/s].  @param speed U [m/s].  @param heading β [rad].  @param gravity [m/s²].
double encounterFrequency(double omegaI, double speed, double heading, double gravity) noexcept;

/// Airy wave of unit amplitude in deep water, crest at the origin of x, y at t = 0 [M03] (64)-(66):
///   φ_I = (i g/ω_I) e^{kz − ik(x cos β − y sin β)}
/// THEORY.md, chapter 3.
struct AiryWave {
  double omega;    ///< ω_I [rad/s] > 0
  double heading;  ///< β [rad]
  double gravity;  ///< [m/s²]

  double waveNumber() const noexcept { return omega * omega / gravity; }
  /// e^{kz − ik(x cos β − y sin β)}; x, y from the phase origin, z from calm water.
  Complex shape(const Vec3& x) const noexcept;
  /// κ [1/m] of that shape, e^{κ·x}.
  Eigen::Vector3cd exponent() const noexcept;
  /// φ_I [m²/s per m].
  Complex potential(const Vec3& x) const noexcept;
  /// ∇φ_I [m/s per m].
  Eigen::Vector3cd velocity(const Vec3& x) const noexcept;
};

}  // namespace cutwater
