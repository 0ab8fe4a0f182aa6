#include "hydro/forces/linear/HullLift.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

HullLift::HullLift(const Coefficients& coefficients, double length) {
  const Mat6& A = coefficients.addedMass.atZero.isZero(0.0) ? coefficients.addedMass.atInfinity
                                                            : coefficients.addedMass.atZero;
  const double mass = coefficients.ship.mass, added = std::max(A(Sway, Sway), 0.0);
  side_ = 2.0 * (mass + added) / length;
  turn_ = side_ > 0.0 ? 2.0 * mass * added / side_ : 0.0;
}

Wrench HullLift::evaluate(const TickInput& now) noexcept {
  const double u = now.speed + now.etaDotNow[Surge], heading = now.eta[Yaw];
  const double leeway = now.etaDotNow[Sway] * std::cos(heading) - u * std::sin(heading);
  const double side = -side_ * std::abs(u) * leeway;
  Vec6 force = Vec6::Zero();
  force[Surge] = -side * std::sin(heading);
  force[Sway] = side * std::cos(heading);
  force[Yaw] = -turn_ * std::abs(u) * (now.etaDotNow[Yaw] + now.turnRate);
  return {force};
}

}  // namespace cutwater
