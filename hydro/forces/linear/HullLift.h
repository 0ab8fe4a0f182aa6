#pragma once
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/forces/ForceGenerator.h"

namespace cutwater {

/// What keeps a hull that makes way from sliding sideways and from spinning: the lift of hull, skeg and
/// rudder amidships, which potential flow lacks. Without it Munk's moment turns every hull under way
/// broadside within a few ship lengths.
///   Y = −e|u| v,  N = −d|u| r,   e = 2(m + a₂₂)/L,  d = 2 m a₂₂/e,  a = A(0)
/// in own axes. e lets leeway die within half a ship length; d is twice what keeps a straight run stable,
/// e d > m a₂₂, and for the frigate 1.0·10⁸ N·m·s/rad per m/s, as regression of model tests has it
/// (Clarke, Gedling & Hine 1983: N_r of a hull of her proportions). Takes energy, never gives any.
class HullLift final : public ForceGenerator {
 public:
  /// @param length L [m] > 0.
  HullLift(const Coefficients& coefficients, double length) {
    const Mat6& A = coefficients.addedMassZero.isZero(0.0) ? coefficients.addedMassInf
                                                           : coefficients.addedMassZero;
    const double mass = coefficients.ship.mass, added = std::max(A(Sway, Sway), 0.0);
    side_ = 2.0 * (mass + added) / length;
    turn_ = side_ > 0.0 ? 2.0 * mass * added / side_ : 0.0;
  }
  Vec6 at(const ShipMotion& motion) noexcept override {
    const double u = motion.speed + motion.etaDotNow[Surge], heading = motion.eta[Yaw];
    const double leeway = motion.etaDotNow[Sway] * std::cos(heading) - u * std::sin(heading);
    const double side = -side_ * std::abs(u) * leeway;
    Vec6 force = Vec6::Zero();
    force[Surge] = -side * std::sin(heading);
    force[Sway] = side * std::cos(heading);
    force[Yaw] = -turn_ * std::abs(u) * (motion.etaDotNow[Yaw] + motion.turnRate);
    return force;
  }

 private:
  double side_, turn_;  // e [kg/m], d [kg·m]
};

}  // namespace cutwater
