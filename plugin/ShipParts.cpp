// The list of a ship's parts: making it, changing it, asking it.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/Fnv1a.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/appendages/Engine.h"
#include "hydro/forces/appendages/Rudder.h"
#include "hydro/forces/linear/Autopilots.h"
#include "hydro/forces/linear/FreeRadiation.h"
#include "hydro/forces/linear/FreeWaveForce.h"
#include "hydro/forces/linear/HullLift.h"
#include "hydro/forces/linear/Radiation.h"
#include "hydro/forces/linear/Restoring.h"
#include "hydro/forces/linear/SupplementaryForce.h"
#include "hydro/forces/linear/WaveForce.h"
#include "hydro/forces/manoeuvring/Resistance.h"
#include "hydro/forces/nonlinear/WettedPressure.h"
#include "plugin/Rig.h"
#include "plugin/SettingsCheck.h"
#include "plugin/Ship.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

[[noreturn]] void refuse(const std::string& what) { throw HydroError(Fault::BadArgument, what); }

bool isName(std::string_view name) {
  const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), good);
}

}  // namespace

void Ship::makeParts(const ShipSettings& settings) {
  const Coefficients& c = coefficients();
  const auto database = [this](std::unique_ptr<ForceGenerator> force) {
    const std::string name(force->name());
    addPart({.name = name, .force = std::move(force), .potentialFlow = true});
  };
  const auto added = [this](std::unique_ptr<ForceGenerator> force) {
    const std::string name(force->name());
    addPart({.name = name, .force = std::move(force)});
  };
  addPart({.name = "gravity", .potentialFlow = true});
  if (nonlinear()) database(std::make_unique<WettedPressure>(wetted_));
  database(std::make_unique<Restoring>(c.ship, free()));
  if (free()) {
    for (const WaveLoad load : {WaveLoad::FroudeKrylov, WaveLoad::Diffraction})
      database(std::make_unique<FreeWaveForce>(predicted_, load));
    auto radiation = std::make_unique<FreeRadiation>(hydrodynamics().radiation(), predicted_,
                                                     settings.model.memory);
    radiation_ = radiation.get();
    database(std::move(radiation));
  } else {
    const WaveForce::Course course{course_.heading(), course_.speed()};
    for (const WaveLoad load : {WaveLoad::FroudeKrylov, WaveLoad::Diffraction}) {
      auto waves = std::make_unique<WaveForce>(tables_, load, course);
      waves_[static_cast<std::size_t>(load)] = waves.get();
      database(std::move(waves));
    }
    database(std::make_unique<Radiation>(hydrodynamics().radiation(), settings.model.memory));
  }
  addPart({.name = "added_mass"});
  added(std::make_unique<SupplementaryForce>(c.ship.supplementary, free()));
  auto autopilots = free() ? std::make_unique<Autopilots>(c, length())
                           : std::make_unique<Autopilots>(c.ship, c.addedMass.atInfinity, length());
  autopilots_ = autopilots.get();
  added(std::move(autopilots));
  if (free() && settings.model.hullLift) added(std::make_unique<HullLift>(predicted_, fastest_));
  if (free() && settings.model.resistance) {
    auto resistance = std::make_unique<Resistance>(c.ship);
    resistance_ = resistance.get();
    added(std::move(resistance));
  }
  if (free()) makeDrive(settings.model);
  if (settings.model.keepSpeed) keepSpeed(*settings.model.keepSpeed);
  if (settings.model.keepCourse) keepCourse(*settings.model.keepCourse);
}

// Only where ship.toml, the database or the settings give one.
void Ship::makeDrive(const ShipModel& model) {
  const ShipParticulars& ship = coefficients().ship;
  const auto& engine = model.engine ? model.engine : ship.engine;
  const auto& rudder = model.rudder ? model.rudder : ship.rudder;
  if (!engine && !rudder) return;
  helm_ = std::make_shared<Helm>();
  if (engine) {
    const double resistance = -Resistance(ship).alongHull(Engine::hullSpeed(ship));
    addPart(
        {.name = "engine", .force = std::make_unique<Engine>(ship, *engine, resistance, helm_)});
  }
  if (rudder) addPart({.name = "rudder", .force = std::make_unique<Rudder>(ship, *rudder, helm_)});
  autopilots_->steerBy(helm_);
}

void Ship::addPart(ShipPart part) {
  parts_.push_back(std::move(part));
  partsChanged();
}

void Ship::partsChanged() {
  record_.loads.resize(parts_.size(), Vec6::Zero());
  Fnv1a key;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    ShipPart& part = parts_[i];
    key.add(part.name.c_str(), part.name.size() + 1);
    part.replaced = false;
    if (part.name == "gravity") gravityPart_ = i;
    if (part.name == "added_mass") addedMassPart_ = i;
  }
  partsKey_ = key.value();
  for (const ShipPart& part : parts_) {
    if (!part.on || !part.force) continue;
    for (const std::string_view name : part.force->replaces()) {
      for (ShipPart& other : parts_) other.replaced = other.replaced || other.name == name;
    }
  }
  if (!free()) return;
  const auto acts = [this](std::string_view name) {
    return std::any_of(parts_.begin(), parts_.end(),
                       [&](const ShipPart& part) { return part.name == name && part.active(); });
  };
  const bool pressed = acts("wetted_pressure");
  predicted_->setParts(
      {.froudeKrylov = pressed || acts("froude_krylov"),
       .diffraction = acts("diffraction"),
       .hullLift = acts("hull_lift"),
       .supplementary = acts("supplementary"),
       .water = (pressed || acts("restoring")) && acts("radiation") && acts("added_mass"),
       .restrained = restrained_});
}

std::size_t Ship::indexOf(std::string_view name) const {
  std::string known;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].name == name) return i;
    known += (i > 0 ? ", " : "") + parts_[i].name;
  }
  refuse("no part of the load is called \"" + std::string(name) + "\"; there are " + known);
}

std::vector<std::string_view> Ship::parts() const {
  std::vector<std::string_view> names;
  for (const ShipPart& part : parts_) names.emplace_back(part.name);
  return names;
}

std::size_t Ship::weightCarrier() const noexcept {
  const auto carries = [](const ShipPart& part) {
    return part.active() && part.force && part.force->carriesWeight();
  };
  const auto found = std::find_if(parts_.begin(), parts_.end(), carries);
  return static_cast<std::size_t>(found - parts_.begin());
}

const Vec6& Ship::load(std::string_view part) const { return record_.loads[indexOf(part)]; }

void Ship::addForce(std::unique_ptr<ForceGenerator> force) {
  if (!force) refuse("addForce: no force (null pointer)");
  const std::string name(force->name());
  if (!isName(name)) {
    refuse("addForce: \"" + name + "\" is no name of a part; letters, digits and _ only");
  }
  for (const ShipPart& part : parts_) {
    if (part.name == name) refuse("addForce: there is a part called \"" + name + "\" already");
  }
  if (preparedFor_ > 0.0) force->prepare(preparedFor_);
  force->reset();
  addPart({.name = name, .force = std::move(force), .byUser = true});
}

std::unique_ptr<ForceGenerator> Ship::removeForce(std::string_view part) {
  const std::size_t i = indexOf(part);
  if (!parts_[i].byUser) {
    refuse("removeForce: \"" + parts_[i].name +
           "\" is no part of yours; setEnabled switches it off");
  }
  std::unique_ptr<ForceGenerator> force = std::move(parts_[i].force);
  parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
  record_.loads.erase(record_.loads.begin() + static_cast<std::ptrdiff_t>(i));
  broken_ = kNone;
  partsChanged();
  return force;
}

void Ship::setEnabled(std::string_view name, bool on) {
  const std::size_t i = indexOf(name);
  if (i == gravityPart_) refuse("gravity is the world's; set it there");
  ShipPart& part = parts_[i];
  if (part.on == on) return;
  part.on = on;
  record_.loads[i].setZero();
  if (on && part.force) part.force->reset();
  if (i == addedMassPart_) added().setActive(on);
  partsChanged();
}

void Ship::switchOff(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    try {
      setEnabled(name, false);
    } catch (const HydroError& error) {
      throw HydroError(error.fault(), std::string("without: ") + error.what());
    }
  }
}

bool Ship::enabled(std::string_view part) const { return parts_[indexOf(part)].active(); }

std::string Ship::seaWarning() const { return tables_->warning(); }

std::string Ship::brokenPart() {
  const std::string name = broken_ < parts_.size() ? parts_[broken_].name : "";
  broken_ = kNone;
  return name;
}

void Ship::measureCosts(bool on) noexcept {
  measuring_ = on;
  if (!on) return;
  for (ShipPart& part : parts_) {
    part.nanoseconds = 0.0;
    part.timed = 0;
  }
}

std::vector<double> Ship::costs() const {
  std::vector<double> mean;
  for (const ShipPart& part : parts_) {
    mean.push_back(part.timed > 0 ? part.nanoseconds / static_cast<double>(part.timed) : 0.0);
  }
  return mean;
}

void Ship::keepSpeed(const SpeedKeeper& order) {
  checkOrder(order, "Ship::keepSpeed");
  autopilots_->hold(order, resistance_ != nullptr ? -resistance_->alongHull(order.speed) : 0.0);
}
void Ship::keepCourse(const CourseKeeper& order) {
  checkOrder(order, "Ship::keepCourse");
  autopilots_->hold(order);
}
Helm& Ship::helmFor(const char* order, const char* part, double value) const {
  if (!std::isfinite(value))
    throw HydroError(Fault::ValueOutOfRange,
                     std::string(order) + ": " + std::to_string(value) + " is no order");
  if (!free())
    refuse(std::string(order) + ": a ship on a fixed course has no " + part +
           "; give it ShipModel::mean = Mean::Free");
  const bool has = helm_ && (std::string_view(part) == "engine" ? helm_->engine : helm_->rudder);
  if (!has)
    refuse(std::string(order) + ": this ship has no " + part + "; give ShipModel::" + part +
           ", or [" + part + "] in its ship.toml and solve");
  return *helm_;
}

void Ship::setThrottle(double order) {
  Helm& helm = helmFor("Ship::setThrottle", "engine", order);
  autopilots_->releaseSpeed();
  helm.throttle = std::clamp(order, -1.0, 1.0);
}

void Ship::setRudder(double angle) {
  Helm& helm = helmFor("Ship::setRudder", "rudder", angle);
  autopilots_->releaseCourse();
  helm.angle = std::clamp(angle, -helm.rudderLimit, helm.rudderLimit);
}

void Ship::stopKeepingSpeed() noexcept { autopilots_->releaseSpeed(); }
void Ship::stopKeepingCourse() noexcept { autopilots_->releaseCourse(); }

CUTWATER_PLUGIN_END
