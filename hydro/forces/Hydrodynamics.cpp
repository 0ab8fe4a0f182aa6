#include "hydro/forces/Hydrodynamics.h"

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/memory/RadiationModel.h"

namespace cutwater {

namespace {

const Coefficients& checked(const std::shared_ptr<const Coefficients>& coefficients) {
  if (!coefficients)
    throw HydroError(Fault::BadArgument, "Hydrodynamics: no coefficients (null pointer)");
  requireFinished(*coefficients, "Hydrodynamics");
  return *coefficients;
}

Bounds boundsOf(const ShipParticulars& ship) {
  return bounds(ship.hull.vertices.empty() ? ship.wetSurface : ship.hull);
}

/// A file without a hull: a ship is about five cube roots of its volume long.
double lengthOf(const ShipParticulars& ship) {
  const Bounds box = boundsOf(ship);
  const double length = box.high.x() - box.low.x();
  return length > 0.0 ? length : 5.0 * std::cbrt(std::max(ship.volume, 1e-9));
}

}  // namespace

Hydrodynamics::Hydrodynamics(std::shared_ptr<const Coefficients> coefficients,
                             std::optional<ForwardSpeedForm> form)
    : coefficients_(std::move(coefficients)),
      form_(form.value_or(usableForm(checked(coefficients_)))),
      length_(lengthOf(coefficients_->ship)),
      keel_(std::min(0.0, boundsOf(coefficients_->ship).low.z())) {}

Hydrodynamics::~Hydrodynamics() = default;

std::shared_ptr<const RadiationModel> Hydrodynamics::radiation(MemoryModel memory) const {
  const std::lock_guard lock(mutex_);
  auto& model = radiation_[static_cast<std::size_t>(memory)];
  if (!model) model = std::make_shared<RadiationModel>(*coefficients_, memory, form_);
  return model;
}

std::shared_ptr<const Hydrodynamics> readHydrodynamics(const std::string& path,
                                                       std::string* warning) {
  return std::make_shared<const Hydrodynamics>(readCoefficients(path, warning));
}

}  // namespace cutwater
