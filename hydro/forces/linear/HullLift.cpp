#include "hydro/forces/linear/HullLift.h"

#include <cmath>

namespace cutwater {

HullLift::HullLift(const Coefficients& coefficients, double length) : lift_(coefficients, length) {}

Wrench HullLift::evaluate(const TickInput& now) noexcept {
  const double u = now.speed + now.etaDotNow[Surge], heading = now.eta[Yaw];
  const double leeway = now.etaDotNow[Sway] * std::cos(heading) - u * std::sin(heading);
  const double side = -lift_.side * std::abs(u) * leeway;
  Vec6 force = Vec6::Zero();
  force[Surge] = -side * std::sin(heading);
  force[Sway] = side * std::cos(heading);
  force[Yaw] = -lift_.turn * std::abs(u) * (now.etaDotNow[Yaw] + now.turnRate);
  return {force};
}

}  // namespace cutwater
