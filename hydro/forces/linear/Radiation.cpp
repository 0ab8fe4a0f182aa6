#include "hydro/forces/linear/Radiation.h"

#include "hydro/memory/RadiationModel.h"

namespace cutwater {

Radiation::Radiation(std::shared_ptr<const RadiationModel> model, MemoryModel memory)
    : model_(std::move(model)), memoryModel_(memory) {
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
  const RetardationMatrix& K = model_->retardation();
  const double U = now.speed, s = now.immersion;
  const Vec6 memory = s * memory_->advance(s * now.etaDot, U);
  if (U == 0.0) return {memory};
  return {memory - s * U * (K.speedDamping() * now.etaDotNow + U * (K.speedStiffness() * now.eta))};
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
