#include "hydro/forces/nonlinear/CarriedLoad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

constexpr double kLargestPlace = 1e4;       // [m]: farther is no place on a ship
constexpr std::size_t kWeightsAtHand = 64;  // more of them allocate when a snapshot is restored

void requireWeight(const Weight& weight) {
  const auto refuse = [&](const std::string& field, double value, const char* rule) {
    std::ostringstream line;
    line << "Ship::setWeights: weight \"" << weight.name << "\": " << field << " = " << value
         << ": " << rule;
    throw HydroError(Fault::ValueOutOfRange, line.str());
  };
  if (!(weight.mass >= 0.0 && std::isfinite(weight.mass)))
    refuse("mass", weight.mass,
           "must be 0 kg or more; a ship that gets lighter than its database is given a database "
           "without what it will lose");
  for (int i = 0; i < 3; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    if (!(std::abs(weight.place[i]) <= kLargestPlace))
      refuse("place" + index, weight.place[i], "must be a place on the ship [m]");
    if (!(weight.gyradii[i] >= 0.0 && weight.gyradii[i] <= kLargestPlace))
      refuse("gyradii" + index, weight.gyradii[i], "must be 0 m or more");
  }
}

void requireNamesApart(const std::vector<Weight>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (weights[i].name != weights[k].name) continue;
      throw HydroError(Fault::BadArgument,
                       "Ship::setWeights: two weights are called \"" + weights[i].name + "\"");
    }
  }
}

double* saveMoments(const MassMoments& moments, double* to) {
  *to++ = moments.mass;
  for (int i = 0; i < 3; ++i) *to++ = moments.first[i];
  for (int i = 0; i < 9; ++i) *to++ = moments.second.data()[i];
  return to;
}

const double* readMoments(const double* from, MassMoments& moments) {
  moments.mass = *from++;
  for (int i = 0; i < 3; ++i) moments.first[i] = *from++;
  for (int i = 0; i < 9; ++i) moments.second.data()[i] = *from++;
  return from;
}

}  // namespace

MassMoments MassMoments::of(double mass, const Vec3& r, const Vec3& gyradii) {
  MassMoments moments;
  moments.mass = mass;
  moments.first = mass * r;
  moments.second = mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  moments.second.diagonal() += mass * gyradii.cwiseProduct(gyradii);
  return moments;
}

MassMoments& MassMoments::add(const MassMoments& other, double factor) {
  mass += factor * other.mass;
  first += factor * other.first;
  second += factor * other.second;
  return *this;
}

// Momentum m v + ω × s, moment of momentum s × v + I ω, with s = ∫r dm.
Mat6 MassMoments::matrix() const {
  Mat3 cross;
  cross << 0.0, -first.z(), first.y(), first.z(), 0.0, -first.x(), -first.y(), first.x(), 0.0;
  Mat6 matrix;
  matrix << mass * Mat3::Identity(), -cross, cross, second;
  return matrix;
}

CarriedLoad::CarriedLoad(const ShipParticulars& ship) : cog_(ship.cog), density_(ship.density) {
  weights_.reserve(kWeightsAtHand);
  nameOf_.reserve(kWeightsAtHand);
}

MassMoments CarriedLoad::of(const Weight& weight) const {
  return MassMoments::of(weight.mass, weight.place - cog_, weight.gyradii);
}

std::size_t CarriedLoad::nameIndex(const std::string& name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
  names_.push_back(name);
  return names_.size() - 1;
}

// Of a weight that stays, what it is heavier came with the ship's velocity, and what it is lighter
// took it along, each where it is.
void CarriedLoad::setWeights(std::vector<Weight> weights) {
  for (const Weight& weight : weights) requireWeight(weight);
  requireNamesApart(weights);
  std::vector<std::size_t> nameOf;
  nameOf.reserve(std::max(kWeightsAtHand, weights.size()));
  for (const Weight& weight : weights) nameOf.push_back(nameIndex(weight.name));
  weights.reserve(kWeightsAtHand);
  const auto sameIn = [](const std::vector<Weight>& list, const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const Weight& w) { return w.name == name; });
  };
  for (const Weight& weight : weights) {
    const auto before = sameIn(weights_, weight.name);
    const double had = before != weights_.end() ? before->mass : 0.0;
    if (weight.mass > had) pending_.add(of(weight), 1.0 - had / weight.mass);
  }
  for (const Weight& weight : weights_) {
    const auto after = sameIn(weights, weight.name);
    const double has = after != weights.end() ? after->mass : 0.0;
    if (weight.mass > has) pending_.add(of(weight), has / weight.mass - 1.0);
  }
  weights_ = std::move(weights);
  nameOf_ = std::move(nameOf);
}

// Water that is in it already comes with the ship.
Compartment& CarriedLoad::addCompartment(const CompartmentBox& box) {
  auto compartment = std::make_unique<Compartment>(box, cog_, density_);
  heldBefore_.reserve(compartments_.size() + 1);
  armBefore_.reserve(compartments_.size() + 1);
  compartments_.push_back(std::move(compartment));
  Compartment& added = *compartments_.back();
  heldBefore_.push_back(added.mass());
  armBefore_.push_back(added.arm());
  pending_.add(MassMoments::of(added.mass(), added.arm()));
  return added;
}

MassMoments CarriedLoad::moments() const noexcept {
  MassMoments sum;
  for (const Weight& weight : weights_) sum.add(of(weight));
  for (const auto& compartment : compartments_)
    sum.add(MassMoments::of(compartment->mass(), compartment->arm()));
  return sum;
}

Wrench CarriedLoad::evaluate(const TickInput& now) noexcept {
  const Compartment::Place place{now.position, now.attitude};
  kept_ = carried_;
  kept_.add(pending_);
  for (std::size_t i = 0; i < compartments_.size(); ++i) {
    Compartment& compartment = *compartments_[i];
    const double lost = std::min(compartment.takeLost(), heldBefore_[i]);
    if (lost > 0.0) kept_.add(MassMoments::of(lost, armBefore_[i]), -1.0);
    compartment.settle(place);
    heldBefore_[i] = compartment.mass();
    armBefore_[i] = compartment.arm();
  }
  carried_ = moments();
  if (begins_) kept_ = carried_;
  pending_ = {};
  begins_ = false;
  const double c = std::cos(now.meanHeading), s = std::sin(now.meanHeading);
  const Vec3& g = now.gravity;
  const Vec3 down(c * g.x() - s * g.y(), s * g.x() + c * g.y(), g.z());
  Wrench weight;
  weight.axes = Axes::Earth;
  weight.load << carried_.mass * down, (now.attitude * carried_.first).cross(down);
  const SeaState* sea = now.sea != nullptr && !now.sea->components().empty() ? now.sea : nullptr;
  for (const auto& compartment : compartments_)
    compartment->flow(place, now.time, now.step, g.norm(), sea);
  return weight;
}

void CarriedLoad::reset() noexcept {
  for (const auto& compartment : compartments_) compartment->takeLost();
  pending_ = {};
  begins_ = true;
}

std::size_t CarriedLoad::stateSize() const noexcept {
  std::size_t size = kOwnState + kWeightState * weights_.size();
  for (const auto& compartment : compartments_) size += 4 + compartment->stateSize();
  return size;
}

void CarriedLoad::save(std::span<double> state) const noexcept {
  double* to = state.data();
  *to++ = begins_ ? 1.0 : 0.0;
  *to++ = static_cast<double>(weights_.size());
  to = saveMoments(pending_, saveMoments(carried_, to));
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& weight = weights_[i];
    *to++ = static_cast<double>(nameOf_[i]);
    *to++ = weight.mass;
    for (int k = 0; k < 3; ++k) *to++ = weight.place[k];
    for (int k = 0; k < 3; ++k) *to++ = weight.gyradii[k];
  }
  for (std::size_t i = 0; i < compartments_.size(); ++i) {
    *to++ = heldBefore_[i];
    for (int k = 0; k < 3; ++k) *to++ = armBefore_[i][k];
    compartments_[i]->save(to);
    to += compartments_[i]->stateSize();
  }
}

bool CarriedLoad::fits(std::span<const double> state) const noexcept {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (state.size() < kOwnState || !std::all_of(state.begin(), state.end(), finite)) return false;
  const double count = state[1];
  std::size_t left = state.size() - kOwnState;
  const std::size_t room = left / kWeightState;
  if (!(count >= 0.0 && count == std::floor(count) && count <= static_cast<double>(room)))
    return false;
  left -= kWeightState * static_cast<std::size_t>(count);
  for (const auto& compartment : compartments_) {
    if (left < 4) return false;
    left -= 4;
    const std::size_t taken = compartment->fits(state.data() + (state.size() - left), left);
    if (taken == 0) return false;
    left -= taken;
  }
  return left == 0;
}

// A weight whose name nobody here has heard, of another process, has none.
void CarriedLoad::restore(std::span<const double> state) noexcept {
  const double* from = state.data();
  begins_ = *from++ != 0.0;
  const auto count = static_cast<std::size_t>(*from++);
  from = readMoments(readMoments(from, carried_), pending_);
  weights_.resize(count);
  nameOf_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    Weight& weight = weights_[i];
    const double index = *from++;
    const bool known = index >= 0.0 && index < static_cast<double>(names_.size());
    nameOf_[i] = known ? static_cast<std::size_t>(index) : names_.size();
    if (known) {
      weight.name = names_[nameOf_[i]];
    } else {
      weight.name.clear();
    }
    weight.mass = *from++;
    for (int k = 0; k < 3; ++k) weight.place[k] = *from++;
    for (int k = 0; k < 3; ++k) weight.gyradii[k] = *from++;
  }
  for (std::size_t i = 0; i < compartments_.size(); ++i) {
    heldBefore_[i] = *from++;
    for (int k = 0; k < 3; ++k) armBefore_[i][k] = *from++;
    compartments_[i]->restore(from);
    from += compartments_[i]->stateSize();
  }
}

}  // namespace cutwater
