#include "hydro/forces/linear/HullLift.h"

#include <algorithm>
#include <cmath>

namespace cutwater {

Wrench HullLift::evaluate(const TickInput& now) noexcept {
  const HullLiftFactors& lift = predicted_->response().lift();
  const PredictedMotion::Sums& wave = predicted_->now();
  const double way = std::min(std::abs(now.speed), fastest_);
  Vec6 force = Vec6::Zero();
  force[Sway] = -lift.side * way * (now.ownVelocityNow[Sway] - wave.orbitalAcross);
  force[Yaw] = -lift.turn * way * (now.ownVelocityNow[Yaw] - wave.orbitalTurn);
  return {now.immersion * now.upright * force};
}

}  // namespace cutwater
