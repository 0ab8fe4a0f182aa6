#include "plugin/ShipModel.h"

#include <algorithm>

CUTWATER_PLUGIN_BEGIN

namespace {

const std::vector<Vec3>& verticesOf(const ShipParticulars& ship) {
  return ship.hull.vertices.empty() ? ship.wetSurface.vertices : ship.hull.vertices;
}

}  // namespace

double ShipModel::length() const noexcept {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& v : verticesOf(coefficients_.ship)) {
    low = std::min(low, v.x());
    high = std::max(high, v.x());
  }
  // A file without a hull: a length of the size of the displaced water, seven ship's breadths.
  return high > low ? high - low : 5.0 * std::cbrt(std::max(coefficients_.ship.volume, 1e-9));
}

double ShipModel::keel() const noexcept {
  double lowest = 0.0;
  for (const Vec3& v : verticesOf(coefficients_.ship)) lowest = std::min(lowest, v.z());
  return lowest;
}

ForwardSpeedForm ShipModel::form() const noexcept {
  const bool derivatives = !coefficients_.addedMassX.empty() && !coefficients_.dampingX.empty() &&
                           (coefficients_.adjoint.empty() || !coefficients_.adjointX.empty());
  return derivatives ? coefficients_.forwardSpeed : ForwardSpeedForm::Tuck;
}

std::shared_ptr<const RadiationModel> ShipModel::radiation(MemoryModel memory) {
  const std::lock_guard lock(mutex_);
  auto& model = radiation_[memory == MemoryModel::Exponential ? 0 : 1];
  if (!model) model = std::make_shared<RadiationModel>(coefficients_, memory, form());
  return model;
}

std::shared_ptr<const ExcitationTable> ShipModel::excitation() {
  const std::lock_guard lock(mutex_);
  if (!excitation_) excitation_ = std::make_shared<ExcitationTable>(coefficients_, sea_, form());
  return excitation_;
}

CUTWATER_PLUGIN_END
