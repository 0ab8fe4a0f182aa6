#pragma once
#include "hydro/Conventions.h"

namespace cutwater {

/// Motion of a ship about its mean course at one tick. Frame H (Conventions.h); angular velocities, and
/// the moments that answer them, in upright axes with the ship's own heading, to first order H.
struct ShipMotion {
  double time = 0.0;                ///< t_n [s]
  Vec6 eta = Vec6::Zero();          ///< surge, sway, heave [m] of G; roll, pitch, yaw [rad], at t_n
  Vec6 etaDot = Vec6::Zero();       ///< η̇ [m/s, rad/s], mean over the tick that ended at t_n
  Vec6 etaDotNow = Vec6::Zero();    ///< η̇ extrapolated to t_n
  double meanX = 0.0, meanY = 0.0;  ///< mean position of G in E [m]
  double meanHeading = 0.0;         ///< ψ̄ [rad]: x axis of H against E's, about +z
  double speed = 0.0;               ///< U [m/s], mean speed along that axis
  double turnRate = 0.0;            ///< dψ̄/dt [rad/s]; η̇₆ is what she turns beyond it
};

/// One part of the load on the ship. Adding a part is adding one class; parts do not know each
/// other. Acceleration is not an input: added mass cannot be a ForceGenerator
/// (plugin/AddedMassConstraint.h).
class ForceGenerator {
 public:
  virtual ~ForceGenerator() = default;
  /// Force [N] and moment about G [N·m] in H. Called once per tick, in order of time. No
  /// allocation.
  virtual Vec6 at(const ShipMotion& motion) noexcept = 0;
};

}  // namespace cutwater
