#include "plugin/ShipModel.h"

#include <algorithm>
#include <cmath>

#include "hydro/database/ForwardSpeed.h"

CUTWATER_PLUGIN_BEGIN

namespace {

Bounds boundsOf(const ShipParticulars& ship) {
  return bounds(ship.hull.vertices.empty() ? ship.wetSurface : ship.hull);
}

}  // namespace

double ShipModel::length() const noexcept {
  const Bounds box = boundsOf(coefficients_.ship);
  const double length = box.high.x() - box.low.x();
  // A file without a hull: a ship is about five cube roots of her volume long.
  return length > 0.0 ? length : 5.0 * std::cbrt(std::max(coefficients_.ship.volume, 1e-9));
}

double ShipModel::keel() const noexcept {
  return std::min(0.0, boundsOf(coefficients_.ship).low.z());
}

std::shared_ptr<const RadiationModel> ShipModel::radiation(MemoryModel memory) {
  const std::lock_guard lock(mutex_);
  auto& model = radiation_[memory == MemoryModel::Exponential ? 0 : 1];
  if (!model)
    model = std::make_shared<RadiationModel>(coefficients_, memory, usableForm(coefficients_));
  return model;
}

std::shared_ptr<const ExcitationTable> ShipModel::excitation() {
  const std::lock_guard lock(mutex_);
  if (!excitation_)
    excitation_ = std::make_shared<ExcitationTable>(coefficients_, sea_, usableForm(coefficients_));
  return excitation_;
}

CUTWATER_PLUGIN_END
