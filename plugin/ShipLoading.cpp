// What a ship carries beside its own mass: weights, compartments, and their inertia; and a calm
// level that moves.
#include <Eigen/Geometry>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/WettedHull.h"
#include "hydro/forces/nonlinear/CarriedLoad.h"
#include "plugin/Rig.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kMostLinear = 0.05;  // of the ship's mass, carried in linear mode

const std::vector<Weight> kNoWeights;
const std::vector<std::unique_ptr<Compartment>> kNoCompartments;

}  // namespace

CarriedLoad& Ship::carriedLoad() {
  if (carried_ != nullptr) return *carried_;
  auto load = std::make_unique<CarriedLoad>(coefficients().ship);
  CarriedLoad& made = *load;
  const std::string name(made.name());
  addPart({.name = name, .force = std::move(load)});
  carried_ = &made;
  return made;
}

// What is refused leaves no part behind: it is tried on one of its own first.
void Ship::setWeights(std::vector<Weight> weights) {
  if (carried_ == nullptr) CarriedLoad(coefficients().ship).setWeights(weights);
  carriedLoad().setWeights(std::move(weights));
}

const std::vector<Weight>& Ship::weights() const noexcept {
  return carried_ != nullptr ? carried_->weights() : kNoWeights;
}

Compartment& Ship::addCompartment(const CompartmentBox& box) {
  if (carried_ == nullptr) CarriedLoad(coefficients().ship).addCompartment(box);
  CarriedLoad& load = carriedLoad();
  Compartment& compartment = load.addCompartment(box);
  compartment.settle({position(), bodyAxes()});
  return compartment;
}

const std::vector<std::unique_ptr<Compartment>>& Ship::compartments() const noexcept {
  return carried_ != nullptr ? carried_->compartments() : kNoCompartments;
}

// The part is there and on.
bool Ship::carries() const noexcept {
  if (carried_ == nullptr) return false;
  for (const ShipPart& part : parts_) {
    if (part.force.get() == carried_) return part.active();
  }
  return false;
}

double Ship::carriedMass() const noexcept { return carries() ? carried_->mass() : 0.0; }

LoadedShip Ship::loading() const noexcept {
  const ShipParticulars& ship = coefficients().ship;
  MassMoments sum = MassMoments::of(mass(), Vec3::Zero(), ship.gyradii);
  if (carries()) sum.add(carried_->moments());
  const Vec3 arm = sum.first / sum.mass;
  LoadedShip loaded;
  loaded.mass = sum.mass;
  loaded.cog = ship.cog + arm;
  loaded.inertia = sum.second - MassMoments::of(sum.mass, arm).second;
  return loaded;
}

// About G in B, as of the last solve.
Mat6 Ship::carriedMatrix() const noexcept {
  return carries() ? carried_->carried().matrix() : Mat6(Mat6::Zero());
}

// Where the part is off it neither weighs nor resists.
void Ship::carryInertia() const noexcept {
  if (carried_ == nullptr) return;
  if (!carries()) {
    added().carry(Mat6::Zero(), Mat6::Zero());
    return;
  }
  added().carry(frame_.mass(carried_->carried().matrix()), frame_.mass(carried_->kept().matrix()));
}

// Velocity of the frame that A∞ and what is carried do not feel, in E as the world sees it.
Vec3 Ship::meanInEarth() const noexcept {
  Vec3 mean(0.0, 0.0, waterRate_);
  if (!free()) mean += rotationZ(course_.heading()) * Vec3(course_.speed(), 0.0, 0.0);
  return mean;
}

// −V × p of what is carried, V of G beyond the mean: p = m V + ω × ∫r dm, and V × V is nothing.
Vec3 Ship::turningOfCarried() const noexcept {
  if (!carries()) return Vec3::Zero();
  const Vec6 own = input_.velocityNow;
  Vec3 velocity = input_.attitude * own.head<3>();
  if (!free()) velocity -= rotationZ(course_.heading()) * Vec3(course_.speed(), 0.0, 0.0);
  const Vec3 swing = own.tail<3>().cross(carried_->carried().first);
  return -velocity.cross(input_.attitude * swing);
}

// At the start of the last tick, with the velocity there.
double Ship::carriedEnergy() const noexcept {
  if (!carries()) return 0.0;
  const MassMoments& carried = carried_->carried();
  const Mat3 toBody = input_.attitude.transpose();
  const Vec6 own = rotated(toBody, toBody, 0.5 * (velocityAfter_ + velocityBefore_));
  const double height = carried.mass * (input_.position.z() - coefficients().ship.cog.z()) +
                        (input_.attitude * carried.first).z();
  return 0.5 * own.dot(carried.matrix() * own) + coefficients().ship.gravity * height;
}

bool Ship::foundered() const noexcept {
  if (!nonlinear() || wetted_->wetVertices() < pressureHull_->triangles().vertices()) return false;
  return mass() + carriedMass() > coefficients().ship.density * wetted_->volume();
}

std::uint32_t Ship::outsideLoading() const noexcept {
  std::uint32_t faults = kStepOk;
  if (!nonlinear() && carriedMass() > kMostLinear * coefficients().ship.mass)
    faults |= kLoadedBeyondLinear;
  if (foundered()) faults |= kFoundered;
  return faults;
}

// Velocities are those against the water, which has another from now on; the ship has not.
void Ship::setWater(double seaLevel, double rate) noexcept {
  frame_.seaLevel = seaLevel;
  velocityAfter_[Heave] += waterRate_ - rate;
  velocityBefore_[Heave] += waterRate_ - rate;
  waterRate_ = rate;
}

CUTWATER_PLUGIN_END
