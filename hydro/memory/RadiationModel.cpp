#include "hydro/memory/RadiationModel.h"

namespace cutwater {

RadiationModel::RadiationModel(const Coefficients& coefficients, ForwardSpeedForm form)
    : retardation_(coefficients, form),
      addedMassInf_(0.5 * (coefficients.addedMass.atInfinity +
                           coefficients.addedMass.atInfinity.transpose())) {}

CMat6 RadiationModel::waterMass(double omega) const noexcept {
  return addedMassInf_.cast<Complex>() + sum_->momentumTransform(omega);
}

const ExponentialSum& RadiationModel::sum() const {
  const std::lock_guard lock(mutex_);
  if (!sum_) sum_ = std::make_unique<ExponentialSum>(retardation_, addedMassInf_);
  return *sum_;
}

std::unique_ptr<RadiationMemory> RadiationModel::makeMemory(double step) const {
  return std::make_unique<ExponentialMemory>(sum(), step);
}

std::unique_ptr<RadiationMemory> RadiationModel::makeConvolution(double step) const {
  const std::lock_guard lock(mutex_);
  if (!weights_ || weights_->step() != step)
    weights_ = std::make_shared<ConvolutionWeights>(retardation_, step);
  return std::make_unique<Convolution>(weights_);
}

}  // namespace cutwater
