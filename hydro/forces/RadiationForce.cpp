#include "hydro/forces/RadiationForce.h"

namespace cutwater {

RadiationForce::RadiationForce(std::shared_ptr<const RadiationModel> model, double step, bool free)
    : model_(std::move(model)), memory_(model_->makeMemory(step)), free_(free) {}

Vec6 RadiationForce::at(const ShipMotion& motion) noexcept {
  const Vec6 memory = memory_->advance(motion.etaDot, motion.speed);
  const double U = motion.speed;
  if (U == 0.0) {
    speedTerms_.setZero();
    return memory;
  }
  const Vec6 byDamping = model_->retardation().speedDamping() * motion.etaDotNow;
  const Vec6 byStiffness = model_->retardation().speedStiffness() * motion.eta;
  speedTerms_ = -U * (byDamping + U * byStiffness);
  if (free_) {
    Vec6 turning = motion.etaDotNow;
    turning[Yaw] += motion.turnRate;
    speedTerms_[Surge] += U * byStiffness.dot(turning) + byDamping[Yaw] * motion.turnRate;
  }
  return memory + speedTerms_;
}

}  // namespace cutwater
