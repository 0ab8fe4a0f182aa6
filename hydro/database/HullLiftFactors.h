#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Lift of a hull that makes way, linear in its leeway v and rate of turn r through the water, in
/// own axes:
///     Y = −e|u|(v − v_w),   N = −d|u|(r − r_w),   e = 2(m + a₂₂)/L,   d = 2 m a₂₂/e,   a = A(0)
/// With this e leeway dies within half a ship length. d is twice what keeps a straight run stable,
/// e d > m a₂₂; for a frigate of 124 m it is 1.0·10⁸ N·m·s/rad per m/s, as regression of model
/// tests has it [Clarke, Gedling & Hine 1983]. v_w and r_w are mean and slope over the hull's
/// length of the waves' orbital velocity across it at half draught: a hull that moves with the
/// water feels no lift.
struct HullLiftFactors {
  double side = 0.0;  ///< e [kg/m]
  double turn = 0.0;  ///< d [kg·m]

  /// @param length L [m] > 0.
  HullLiftFactors(const CoefficientTables& coefficients, double length);

  /// v_w [m/s] and r_w [rad/s] of a wave per metre of amplitude, crest over G at t = 0.
  struct Orbital {
    Complex side, turn;
  };
  /// @param omega ω_I [rad/s].  @param waveNumber k [1/m].  @param heading β from the bow [rad].
  Orbital orbital(double omega, double waveNumber, double heading) const;

  /// Adds the lift at a speed ahead [m/s] to a ship's linear equation: against its own velocities
  /// (ownVelocities of FreeMotion.h) on the left, of the water's on the right.
  void resist(double speed, const CMat6& velocities, CMat6& system) const;
  void push(double speed, const Orbital& water, CVec6& force) const;

 private:
  double length_;  // of the wet hull
  double middle_;  // of it, before G
  double depth_;   // half the draught
};

}  // namespace cutwater
