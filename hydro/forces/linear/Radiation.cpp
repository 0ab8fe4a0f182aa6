#include "hydro/forces/linear/Radiation.h"

#include <algorithm>

namespace cutwater {

RadiationForce::RadiationForce(std::shared_ptr<const RadiationModel> model, double step, bool free)
    : model_(std::move(model)),
      memory_(model_->makeMemory(step)),
      free_(free),
      aheadOnly_(model_->form() == ForwardSpeedForm::Report) {}

Vec6 RadiationForce::at(const ShipMotion& motion) noexcept {
  return free_ ? onFreeCourse(motion) : onFixedCourse(motion);
}

Vec6 RadiationForce::onFixedCourse(const ShipMotion& motion) noexcept {
  const RetardationMatrix& K = model_->retardation();
  const double U = motion.speed;
  const Vec6 memory = memory_->advance(motion.etaDot, U);
  if (U == 0.0) return memory;
  return memory - U * (K.speedDamping() * motion.etaDotNow + U * (K.speedStiffness() * motion.eta));
}

Vec6 RadiationForce::onFreeCourse(const ShipMotion& motion) noexcept {
  const RetardationMatrix& K = model_->retardation();
  const double ahead = motion.speed + motion.etaDotNow[Surge];
  const double u = aheadOnly_ ? std::max(ahead, 0.0) : ahead;
  const RadiationMemory::Parts memory = memory_->advanceParts(motion.etaDot);
  Vec6 bySpeed = memory.linear + u * memory.squared - K.speedDamping() * motion.etaDotNow -
                 u * (K.speedStiffness() * motion.eta);
  Vec6 velocity = motion.etaDotNow;
  velocity[Yaw] += motion.turnRate;
  Vec6 force = memory.atRest + u * bySpeed;
  if (u != 0.0) force[Surge] -= bySpeed.dot(velocity);
  return force;
}

}  // namespace cutwater
