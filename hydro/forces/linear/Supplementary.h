#pragma once
#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// What potential flow lacks, as given numbers: viscous roll damping, the stiffness of a helmsman.
///   F_j = −b_j η̇_j − s_j η_j,   roll also −q |η̇₄| η̇₄                       [M03] section 9
/// Velocities are those at t_n (ShipMotion::etaDotNow), so that the term is second order in the
/// tick; damping of yaw sees the whole rate of turn, that of surge only what differs from the mean speed.
/// On a free ship's course the stiffness of surge, sway and yaw is left out: a spring to a course that follows
/// her would drive her as well as hold her. A CourseKeeper holds a heading there.
class SupplementaryForces final : public ForceGenerator {
 public:
  /// @param free  the mean course follows the ship.
  explicit SupplementaryForces(const Supplementary& terms, bool free = false) : terms_(terms) {
    if (free) terms_.stiffness[Surge] = terms_.stiffness[Sway] = terms_.stiffness[Yaw] = 0.0;
  }
  Vec6 at(const ShipMotion& motion) noexcept override {
    Vec6 force = -(terms_.damping.cwiseProduct(motion.etaDotNow) +
                   terms_.stiffness.cwiseProduct(motion.eta));
    force[Yaw] -= terms_.damping[Yaw] * motion.turnRate;
    const double roll = motion.etaDotNow[Roll];
    force[Roll] -= terms_.rollDampingQuadratic * (roll < 0.0 ? -roll : roll) * roll;
    return force;
  }

 private:
  Supplementary terms_;
};

}  // namespace cutwater
