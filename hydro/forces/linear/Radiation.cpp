#include "hydro/forces/linear/Radiation.h"

#include <algorithm>
#include <cmath>

#include "hydro/memory/RadiationModel.h"

namespace cutwater {

Radiation::Radiation(std::shared_ptr<const RadiationModel> model, bool follows, MemoryModel memory,
                     const SpeedTermBounds& bounds)
    : model_(std::move(model)),
      memoryModel_(memory),
      follows_(follows),
      aheadOnly_(model_->form() == ForwardSpeedForm::Report),
      bounds_(bounds) {
  // Takes ticks of any length, so it is made now, not in the first tick.
  if (memory == MemoryModel::Exponential) memory_ = model_->makeMemory(1.0 / 60.0);
}

Radiation::Radiation(Radiation&&) noexcept = default;
Radiation::~Radiation() = default;

void Radiation::prepare(double step) {
  if (memory_ && !needsFixedTicks()) return;
  memory_.reset();
  const bool convolution = memoryModel_ == MemoryModel::Convolution;
  memory_ = convolution ? model_->makeConvolution(step) : model_->makeMemory(step);
}

Wrench Radiation::evaluate(const TickInput& now) noexcept {
  if (!memory_) return {};
  memory_->setStep(now.lastStep);  // the convolution has been prepared for it
  return {follows_ ? onFollowingCourse(now) : onFixedCourse(now)};
}

Vec6 Radiation::onFixedCourse(const TickInput& now) noexcept {
  const RetardationMatrix& K = model_->retardation();
  const double U = now.speed;
  const Vec6 memory = memory_->advance(now.etaDot, U);
  if (U == 0.0) return memory;
  return memory - U * (K.speedDamping() * now.etaDotNow + U * (K.speedStiffness() * now.eta));
}

Vec6 Radiation::onFollowingCourse(const TickInput& now) noexcept {
  const RetardationMatrix& K = model_->retardation();
  const double ahead = now.speed + now.etaDotNow[Surge];
  const double u = aheadOnly_ ? std::max(ahead, 0.0) : ahead;
  const RadiationMemory::Parts memory = memory_->advanceParts(now.etaDot);
  Vec6 velocity = now.etaDotNow;
  velocity[Yaw] += now.turnRate;
  const double ends = std::hypot(std::hypot(ahead, velocity[Sway], velocity[Heave]),
                                 bounds_.halfLength * velocity.tail<3>().norm());
  const double ratio = ends > bounds_.fastest ? bounds_.fastest / ends : 1.0;
  const Vec6 bySpeed = ratio * ratio *
                       (memory.linear + u * memory.squared - K.speedDamping() * now.etaDotNow -
                        u * (K.speedStiffness() * now.eta));
  Vec6 force = memory.atRest + u * bySpeed;
  if (u != 0.0) force[Surge] -= bySpeed.dot(velocity);
  return force;
}

void Radiation::reset() noexcept {
  if (memory_) memory_->reset();
}

std::size_t Radiation::stateSize() const noexcept { return memory_ ? memory_->stateSize() : 0; }

void Radiation::save(std::span<double> state) const noexcept {
  if (memory_) memory_->save(state);
}

bool Radiation::fits(std::span<const double> state) const noexcept {
  return memory_ ? memory_->fits(state) : state.empty();
}

void Radiation::restore(std::span<const double> state) noexcept {
  if (memory_) memory_->restore(state);
}

}  // namespace cutwater
