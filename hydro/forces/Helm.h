#pragma once
#include <algorithm>

namespace cutwater {

/// What passes between those who steer a ship and the parts that push it: orders one way, what they
/// can do the other. One for each ship that has an engine or a rudder; parts share it and do not
/// know each other. Its numbers belong to the parts, which save them.
struct Helm {
  bool engine = false, rudder = false;  ///< the ship has one

  double throttle = 0.0;  ///< order to the engine, −1 full astern .. 1 full ahead
  double angle = 0.0;     ///< order to the rudder [rad], positive turns the bow to port under way

  double thrustAhead = 0.0, thrustAstern = 0.0;  ///< largest, of a ship at rest [N]
  double noThrustSpeed = 1.0;                    ///< at which full thrust has fallen to 0 [m/s]
  /// Largest thrust [N] at a speed ahead [m/s]: falls linearly with the speed that it makes;
  /// against the motion it is that at rest.
  double fullThrust(bool astern, double speed) const noexcept {
    const double advance = (astern ? -speed : speed) / noThrustSpeed;
    return (astern ? thrustAstern : thrustAhead) * std::clamp(1.0 - advance, 0.0, 1.0);
  }

  /// dN/dδ of the rudder amidships in the last tick [N·m/rad]; negative where the water meets it
  /// from astern.
  double momentPerAngle = 0.0;
  double rudderLimit = 0.0;  ///< [rad]
  /// 2T/(ρA_p) of the propeller in this tick [m²/s²]: what the square of the water's speed gains on
  /// its way through. The engine gives it, the rudder takes it.
  double jet = 0.0;
};

}  // namespace cutwater
