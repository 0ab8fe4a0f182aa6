#include "hydro/forces/Compartment.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

constexpr std::size_t kOpeningsAtHand = 8;  // more of them allocate
constexpr double kLargestPlace = 1e4;       // [m]: farther is no place on a ship

[[noreturn]] void refuseCompartment(const std::string& name, const std::string& field, double value,
                                    const std::string& rule) {
  std::ostringstream line;
  line << "compartment \"" << name << "\": " << field << " = " << value << ": " << rule;
  throw HydroError(Fault::ValueOutOfRange, line.str());
}

void requireOnShip(const std::string& name, const std::string& field, const Vec3& place) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(place[i]) <= kLargestPlace) continue;
    refuseCompartment(name, field + "[" + std::to_string(i) + "]", place[i],
                      "must be a place on the ship [m]");
  }
}

const CompartmentBox& checkedBox(const CompartmentBox& box) {
  requireOnShip(box.name, "centre", box.centre);
  for (int i = 0; i < 3; ++i) {
    if (!(box.size[i] > 0.0 && box.size[i] <= kLargestPlace))
      refuseCompartment(box.name, "size[" + std::to_string(i) + "]", box.size[i],
                        "must be a positive length [m]");
  }
  if (!(box.permeability > 0.0 && box.permeability <= 1.0))
    refuseCompartment(box.name, "permeability", box.permeability, "must be in 0..1, not 0");
  if (!(box.density >= 0.0 && std::isfinite(box.density)))
    refuseCompartment(box.name, "density", box.density, "must be positive, or 0 for the sea's");
  return box;
}

}  // namespace

Compartment::Compartment(const CompartmentBox& box, const Vec3& cog, double waterDensity)
    : box_(checkedBox(box)),
      fromG_(box.centre - cog),
      capacity_(box.permeability * box.size.prod()),
      density_(box.density > 0.0 ? box.density : waterDensity),
      volume_(0.0),
      seaWater_(density_ == waterDensity) {
  openings_.reserve(kOpeningsAtHand);
  setVolume(box.volume);
  settle({});
  lost_ = 0.0;
}

void Compartment::setVolume(double volume) {
  if (!(volume >= 0.0 && volume <= capacity_)) {
    std::ostringstream rule;
    rule << "must be in 0.." << capacity_ << " m3, what it holds";
    refuseCompartment(box_.name, "volume", volume, rule.str());
  }
  // What was put in since the last tick and is taken out again has no momentum to lose.
  volume_ = volume;
  lost_ = density_ * std::max(0.0, felt_ - volume_);
}

void Compartment::setRate(double rate) {
  if (!std::isfinite(rate)) refuseCompartment(box_.name, "rate", rate, "must be finite");
  rate_ = rate;
}

void Compartment::openTo(const Opening& opening) {
  requireOnShip(box_.name, "opening.place", opening.place);
  if (!(opening.area > 0.0 && std::isfinite(opening.area)))
    refuseCompartment(box_.name, "opening.area", opening.area, "must be positive [m2]");
  if (!(opening.discharge > 0.0 && opening.discharge <= 1.0))
    refuseCompartment(box_.name, "opening.discharge", opening.discharge, "must be in 0..1, not 0");
  if (!seaWater_) {
    throw HydroError(Fault::BadArgument,
                     "compartment \"" + box_.name + "\": openTo: what is in it (density " +
                         std::to_string(density_) + " kg/m3) does not mix with the sea here; " +
                         "leave density out");
  }
  openings_.push_back(opening);
}

// The level that flows and openings see; of many small cells it is what their water has in common.
double Compartment::levelOf(const Place& ship, double volume) const noexcept {
  const Vec3 up = ship.attitude.row(2);
  const BoxFill water = fillBox(box_.size, volume / box_.permeability, up);
  return ship.position.z() + up.dot(fromG_) + water.height;
}

void Compartment::settle(const Place& ship) noexcept {
  const Vec3 level = ship.attitude.row(2), up = box_.freeSurface ? level : Vec3(Vec3::UnitZ());
  water_ = fillBox(box_.size, volume_ / box_.permeability, up);
  level_ = ship.position.z() + level.dot(fromG_ + water_.height * up);
  felt_ = volume_;
}

// Out counts as lost, in as new.
void Compartment::add(double volume) noexcept {
  const double before = volume_;
  volume_ = std::clamp(volume_ + volume, 0.0, capacity_);
  if (volume_ < before) lost_ += density_ * (before - volume_);
}

// A step of the midpoint rule, never past the height at which both sides are level.
double Compartment::through(const Opening& opening, const Place& ship, double sea, double step,
                            double gravity) const noexcept {
  const Vec3 up = ship.attitude.row(2);
  const double middle = ship.position.z() + up.dot(fromG_);
  const double sill = middle + up.dot(opening.place - box_.centre);
  const double outside = std::max(sea, sill);
  const double level = box_.permeability * fillBoxTo(box_.size, outside - middle, up).volume;
  const auto rate = [&](double volume) {
    const double head = outside - std::max(levelOf(ship, volume), sill);
    return opening.discharge * opening.area *
           std::copysign(std::sqrt(2.0 * gravity * std::abs(head)), head);
  };
  const auto held = [&](double volume) {
    return std::clamp(volume, std::min(volume_, level), std::max(volume_, level));
  };
  const double half = held(volume_ + 0.5 * step * rate(volume_));
  return (half == level ? level : held(volume_ + step * rate(half))) - volume_;
}

void Compartment::flow(const Place& ship, double time, double step, double gravity,
                       const SeaState* sea) noexcept {
  const double before = volume_;
  if (rate_ != 0.0) add(rate_ * step);
  for (const Opening& opening : openings_) {
    const Vec3 at = ship.position + ship.attitude * (opening.place - box_.centre + fromG_);
    const double height = sea != nullptr ? sea->elevation(time, at.x(), at.y()) : 0.0;
    add(through(opening, ship, height, step, gravity));
  }
  inflow_ = (volume_ - before) / step;
}

double Compartment::takeLost() noexcept {
  const double lost = lost_;
  lost_ = 0.0;
  return lost;
}

void Compartment::save(double* state) const noexcept {
  *state++ = volume_;
  *state++ = rate_;
  *state++ = lost_;
  *state++ = felt_;
  *state++ = inflow_;
  *state++ = level_;
  for (int i = 0; i < 3; ++i) *state++ = water_.centre[i];
  *state++ = static_cast<double>(openings_.size());
  for (const Opening& opening : openings_) {
    for (int i = 0; i < 3; ++i) *state++ = opening.place[i];
    *state++ = opening.area;
    *state++ = opening.discharge;
  }
}

std::size_t Compartment::fits(const double* state, std::size_t size) const noexcept {
  if (size < kOwnState) return 0;
  const double count = state[kOwnState - 1];
  const std::size_t room = (size - kOwnState) / kOpeningState;
  const bool good = state[0] >= 0.0 && state[0] <= capacity_ && count >= 0.0 &&
                    count == std::floor(count) && count <= static_cast<double>(room);
  if (!good) return 0;
  const std::size_t taken = kOwnState + kOpeningState * static_cast<std::size_t>(count);
  const bool finite = std::all_of(state, state + taken, [](double x) { return std::isfinite(x); });
  return finite ? taken : 0;
}

void Compartment::restore(const double* state) {
  volume_ = *state++;
  rate_ = *state++;
  lost_ = *state++;
  felt_ = *state++;
  inflow_ = *state++;
  level_ = *state++;
  for (int i = 0; i < 3; ++i) water_.centre[i] = *state++;
  openings_.resize(static_cast<std::size_t>(*state++));
  for (Opening& opening : openings_) {
    for (int i = 0; i < 3; ++i) opening.place[i] = *state++;
    opening.area = *state++;
    opening.discharge = *state++;
  }
}

}  // namespace cutwater
