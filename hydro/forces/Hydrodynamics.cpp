#include "hydro/forces/Hydrodynamics.h"

#include <algorithm>
#include <initializer_list>

#include "hydro/Errors.h"
#include "hydro/base/Fnv1a.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/FreeResponse.h"
#include "hydro/forces/PressureHull.h"
#include "hydro/forces/SeaCache.h"
#include "hydro/memory/RadiationModel.h"
#include "hydro/memory/Resonances.h"
#include "hydro/memory/SpeedStability.h"

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

std::uint64_t keyOf(const Coefficients& c, ForwardSpeedForm form) {
  Fnv1a key;
  const auto add = [&key](std::initializer_list<double> numbers) {
    for (const double number : numbers) key.add(&number, sizeof number);
  };
  const auto matrix = [&key](const auto& m) {
    key.add(m.data(), sizeof(double) * static_cast<std::size_t>(m.size()));
  };
  const ShipParticulars& ship = c.ship;
  add({static_cast<double>(form), ship.mass, ship.volume, ship.density, ship.gravity,
       ship.supplementary.rollDampingQuadratic, ship.drag.crossFlow, ship.drag.formFactor});
  for (const Vec3& v : {ship.cog, ship.gyradii, ship.centreOfBuoyancy}) matrix(v);
  for (const Vec6& v : {ship.supplementary.damping, ship.supplementary.stiffness}) matrix(v);
  for (const double omega : c.omega) add({omega});
  for (const Mat6& m : {ship.restoring, c.addedMass.atZero, c.addedMass.atInfinity}) matrix(m);
  for (const Mat6& m : c.addedMass) matrix(m);
  for (const Mat6& m : c.damping) matrix(m);
  return key.value();
}

}  // namespace

Hydrodynamics::Hydrodynamics(std::shared_ptr<const Coefficients> coefficients,
                             std::optional<ForwardSpeedForm> form)
    : coefficients_(std::move(coefficients)),
      form_(form.value_or(usableForm(checked(coefficients_)))),
      length_(coefficients_->ship.lengthOverall()),
      keel_(std::min(0.0, boundsOf(coefficients_->ship).low.z())),
      top_(std::max(0.0, boundsOf(coefficients_->ship).high.z())),
      closedHull_(hasClosedHull(coefficients_->ship)),
      key_(keyOf(*coefficients_, form_)) {}

Hydrodynamics::~Hydrodynamics() = default;

std::shared_ptr<const RadiationModel> Hydrodynamics::radiation() const {
  const std::lock_guard lock(mutex_);
  if (!radiation_) radiation_ = std::make_shared<RadiationModel>(*coefficients_, form_);
  return radiation_;
}

const WaveExcitation& Hydrodynamics::excitation(ForwardSpeedForm form) const {
  const std::lock_guard lock(mutex_);
  auto& made = excitation_.at(form == ForwardSpeedForm::Tuck ? 1 : 0);
  if (!made) made = std::make_unique<WaveExcitation>(*coefficients_, form);
  return *made;
}

const FreeResponse& Hydrodynamics::freeResponse() const {
  const auto model = radiation();
  const std::lock_guard lock(mutex_);
  if (!freeResponse_) freeResponse_ = std::make_unique<FreeResponse>(*coefficients_, *model);
  return *freeResponse_;
}

const SpeedStability& Hydrodynamics::stability() const {
  const auto model = radiation();
  const std::lock_guard lock(mutex_);
  if (!stability_) stability_ = speedStability(*coefficients_, *model, fastest());
  return *stability_;
}

double Hydrodynamics::fastest() const {
  return std::max(coefficients_->stability.checkedTo, lastSpeedToCheck(coefficients_->ship));
}

std::shared_ptr<SeaCache> Hydrodynamics::cacheOf(const SeaState& sea) const {
  const std::lock_guard lock(mutex_);
  const auto known =
      std::find_if(seas_.begin(), seas_.end(), [&](const auto& cache) { return cache->isOf(sea); });
  auto found = known != seas_.end() ? *known : std::make_shared<SeaCache>(sea);
  if (known != seas_.end()) seas_.erase(known);
  seas_.push_back(found);
  if (seas_.size() > kSeasKept) seas_.erase(seas_.begin());
  return found;
}

std::shared_ptr<const Hydrodynamics> readHydrodynamics(const std::string& path,
                                                       std::string* warning) {
  auto ship = std::make_shared<const Hydrodynamics>(readCoefficients(path, warning));
  if (warning && warning->empty()) {
    *warning = resonanceWarning(ship->coefficients());
    if (!warning->empty()) *warning = path + ": " + *warning;
  }
  return ship;
}

}  // namespace cutwater
