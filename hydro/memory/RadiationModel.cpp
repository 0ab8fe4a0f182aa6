#include "hydro/memory/RadiationModel.h"

namespace cutwater {

RadiationModel::RadiationModel(const Coefficients& coefficients, MemoryModel memory,
                               std::optional<ForwardSpeedForm> form)
    : retardation_(coefficients, form), memory_(memory) {
  if (memory == MemoryModel::Exponential)
    sum_ = std::make_unique<ExponentialSum>(retardation_, coefficients.addedMass.atInfinity);
}

std::unique_ptr<RadiationMemory> RadiationModel::makeMemory(double step) const {
  if (sum_) return std::make_unique<ExponentialMemory>(*sum_, step);
  const std::lock_guard lock(mutex_);
  if (!weights_ || weights_->step() != step) {
    weights_ = std::make_shared<ConvolutionWeights>(retardation_, step);
  }
  return std::make_unique<Convolution>(weights_);
}

}  // namespace cutwater
