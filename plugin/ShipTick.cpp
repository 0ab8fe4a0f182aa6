// One tick of a ship: what it knows at its start, its loads, what the solver needs, its end.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "plugin/Rig.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kLargestCorrection = 0.05;  // of a locked heading in a tick [rad]

}  // namespace

// For the tick as Bullet will give it: 1/60 s is another number in single precision.
void Ship::prepare(double step) {
  const auto given = static_cast<double>(static_cast<btScalar>(step));
  preparedFor_ = 0.0;
  for (ShipPart& part : parts_) {
    if (part.force) part.force->prepare(given);
  }
  preparedFor_ = given;
}

// Bullet's tick is a float in one build: 1e-6 tells another length from another rounding. Parts
// that take ticks as they come are prepared once.
std::uint32_t Ship::matchTick(double step) noexcept {
  if (preparedFor_ > 0.0 && std::abs(preparedFor_ - step) <= 1e-6 * step) return kStepOk;
  std::uint32_t faults = kStepOk;
  try {
    if (preparedFor_ == 0.0) {
      prepare(step);
      return kStepOk;
    }
    for (ShipPart& part : parts_) {
      if (!part.force || !part.force->needsFixedTicks()) continue;
      faults |= kTickLengthChanged;
      part.force->prepare(step);
    }
    preparedFor_ = step;
  } catch (...) {
    preparedFor_ = 0.0;
    return faults | kLoadNotFinite;
  }
  return faults;
}

Wrench Ship::evaluatePart(ShipPart& part) noexcept {
  if (!measuring_) return part.force->evaluate(input_);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const Wrench wrench = part.force->evaluate(input_);
  part.nanoseconds += std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  ++part.timed;
  return wrench;
}

Vec6 Ship::inCourseAxes(const Wrench& wrench) const noexcept {
  if (wrench.axes == Axes::Course) return wrench.load;
  const Mat3 toEarth = wrench.axes == Axes::Own ? input_.attitude : Mat3(Mat3::Identity());
  Vec6 load;
  load << toCourse() * (toEarth * wrench.load.head<3>()),
      generalisedMoment(input_.ownAxes, toEarth * wrench.load.tail<3>());
  return load;
}

// A load that is not finite is left out; with what carries the ship its weight is left out as well.
std::uint32_t Ship::evaluate() noexcept {
  std::uint32_t faults = kStepOk;
  Vec6& gravity = record_.loads[gravityPart_];
  gravity.setZero();
  gravity.head<3>() = input_.weight;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    ShipPart& part = parts_[i];
    if (!part.force) continue;
    Vec6& load = record_.loads[i];
    load = part.active() ? inCourseAxes(evaluatePart(part)) : Vec6(Vec6::Zero());
    if (load.allFinite()) continue;
    load.setZero();
    if (part.force->carriesWeight()) gravity.setZero();
    if (broken_ == kNone) broken_ = i;
    faults |= kLoadNotFinite;
  }
  input_.courseBegins = false;
  return faults;
}

Vec6 Ship::sumOfLoads() const noexcept {
  Vec6 water = record_.loads[gravityPart_], added = Vec6::Zero();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (i == gravityPart_ || i == addedMassPart_) continue;
    if (parts_[i].potentialFlow) {
      water += record_.loads[i];
    } else {
      added += record_.loads[i];
    }
  }
  return water + added;
}

// −V × R A∞ν of a free ship, in E: what of the added mass is no rate of momentum. About the level y
// and the vertical; R does not roll.
Vec3 Ship::turningOfAddedMass() const noexcept {
  if (!free() || !parts_[addedMassPart_].on) return Vec3::Zero();
  const Vec6& nu = input_.ownVelocityNow;
  const Vec3 p = (addedMassNow() * nu).head<3>();
  const Mat3& own = input_.ownAxes;
  const Vec3 cross = input_.turningShare * (own * nu.head<3>().cross(p));
  return momentOf(own, Vec3(0.0, -own.col(1).dot(cross), -cross.z()));
}

Mat6 Ship::addedMassNow() const noexcept {
  if (nonlinear()) return wetted_->mass().now;
  const Mat6& A = coefficients().addedMass.atInfinity;
  return 0.5 * (A + A.transpose());
}

// Momentum that came with the change. Of the waves' it is the upright part. Of what leaves a
// pitched hull the ship keeps the level part: a bow comes in and goes out while it is up, in waves
// again and again, and what was left behind each time would push the ship along. But no more than
// the energy that leaves. On a fixed course added mass lies level, and nothing is changed.
Vec6 Ship::metMomentum() const noexcept {
  const ImmersedMass::Change& change = wetted_->mass();
  if (!free()) return change.met;
  const Vec3 up = input_.ownAxes.row(2);
  Vec6 met = change.met;
  met.head<3>() = up.dot(met.head<3>()) * up;
  const Vec6& nu = input_.ownVelocityNow;
  const Vec6 leaves = change.gone * nu;
  Vec6 level = Vec6::Zero();
  level.head<3>() = leaves.head<3>() - up.dot(leaves.head<3>()) * up;
  // Kept as a share k it adds k b + ½k²c to the energy, at most what leaves.
  const double b = nu.dot(level), c = level.head<3>().squaredNorm() / mass();
  const double energy = std::max(0.0, 0.5 * nu.dot(leaves));
  if (!(b + 0.5 * c > energy)) return met + level;
  const double k = 2.0 * energy / (b + std::sqrt(b * b + 2.0 * c * energy));
  return met + std::clamp(k, 0.0, 1.0) * level;
}

// What comes into the water is a blow, what leaves it takes its water's momentum along.
void Ship::immerseAddedMass() const noexcept {
  if (!nonlinear() || !wetted_->massChanged()) return;
  const ImmersedMass::Change& change = wetted_->mass();
  if (wetted_->beginsNow()) {
    added().setAddedMass(frame_.mass(change.now));
  } else {
    added().change(
        {frame_.mass(change.now), frame_.mass(change.left), frame_.momentum(metMomentum())});
  }
}

// Impulses, not forces: Bullet keeps forces over all ticks of one stepSimulation.
bool Ship::apply(double step) noexcept {
  const Vec6 loads = sumOfLoads();
  if (!loads.allFinite()) return false;
  const Vec3 impulse = step * (rotationZ(course_.heading()) * loads.head<3>());
  turning_ = turningOfAddedMass();
  const Vec3 twist =
      step * (momentOf(input_.ownAxes, loads.tail<3>()) + turning_ + turningOfCarried());
  body_->applyCentralImpulse(frame_.force(impulse));
  body_->applyTorqueImpulse(frame_.moment(twist));
  return true;
}

// One Newton step of the backward Euler method for I ω̇ = −ω × Iω in body axes, as Bullet's own
// implicit term, in double precision: Bullet's gives up where the product of the inertias is below
// its epsilon in its own units.
void Ship::turnByInertia(double step) noexcept {
  const Vec3 inverse = fromBullet(body_->getInvInertiaDiagLocal());
  if (!(inverse.minCoeff() > 0.0)) return;
  const Mat3 axes = fromBullet(body_->getWorldTransform().getBasis());
  const Vec3 spin = axes.transpose() * fromBullet(body_->getAngularVelocity());
  const Vec3 inertia = inverse.cwiseInverse(), momentum = inertia.cwiseProduct(spin);
  const auto cross = [](const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
  };
  const Mat3 diagonal = inertia.asDiagonal();
  const Mat3 slope = diagonal + step * (cross(spin) * diagonal - cross(momentum));
  const Vec3 change = -slope.inverse() * (step * spin.cross(momentum));
  if (!change.allFinite()) return;
  body_->setAngularVelocity(body_->getAngularVelocity() +
                            toBullet(Vec3(axes * change)) * body_->getAngularFactor());
}

// Bullet keeps the rate about a locked axis. Roll and pitch about axes that lie level turn the
// heading all the same, by the area that they sweep, some degrees a minute in waves.
void Ship::holdLockedYaw(double step) noexcept {
  const int up = frame_.up == WorldFrame::Up::Z ? 2 : 1;
  const bool locked = body_->getAngularFactor()[up] == 0;
  btVector3 spin = body_->getAngularVelocity();
  const double rate = static_cast<double>(spin[up]), heading = this->heading();
  if (locked && !lockedYaw_.on) lockedYaw_ = {true, heading, rate};
  lockedYaw_.on = locked;
  if (!locked) return;
  if (spin[up] != known_.angular[up]) lockedYaw_.rate = rate;  // somebody set another
  lockedYaw_.heading += lockedYaw_.rate * step;
  const double turn = std::remainder(lockedYaw_.heading - heading, 2.0 * kPi);
  const double most = kLargestCorrection + std::abs(lockedYaw_.rate) * step;
  spin[up] = static_cast<btScalar>(std::clamp(turn, -most, most) / step);
  body_->setAngularVelocity(spin);
}

std::uint32_t Ship::beginTick(double time, btScalar step) noexcept {
  const Now before = std::exchange(now_, Now::Paused);
  begun_ = false;
  // Bullet would look up a simulation island for a constraint whose body has none.
  rig_->enable(false);
  if (!body_->isInWorld()) return kBodyNotInWorld;
  if (!rig_->addedMass.lent) return kStepOk;  // no memory for a new one: said already
  std::uint32_t faults = mendState() | lookForChanges();
  const int activation = body_->getActivationState();
  const bool held = !(body_->getInvMass() > 0);
  if (held || activation == ISLAND_SLEEPING || activation == DISABLE_SIMULATION) {
    now_ = Now::Asleep;
    if (!held) readyToWake(step);
    return faults;
  }
  if (activation != DISABLE_DEACTIVATION) body_->forceActivationState(DISABLE_DEACTIVATION);
  if (!(step > 0)) {
    now_ = before;
    return faults | kTickNotPositive;
  }
  faults |= lookForMoves();
  if (before == Now::Asleep) forget();
  if (before == Now::Paused) startAgain();
  rig_->enable(true);
  now_ = Now::Ticks;
  begun_ = true;
  return faults | tick(time, step);
}

// A contact may wake the ship within this tick.
void Ship::readyToWake(btScalar step) noexcept {
  added().setEnabled(true);
  turnAddedMass(ownAxesNow());
  added().setMean(frame_.length(meanInEarth()));
  if (carries()) {
    const Mat6 carried = frame_.mass(carried_->moments().matrix());
    added().carry(carried, carried);
  }
  added().forgetPast();
  added().beginTick(step);
}

std::uint32_t Ship::tick(double time, btScalar step) noexcept {
  const double length = static_cast<double>(step);
  std::uint32_t faults = matchTick(length);
  if (length > longestTick_) faults |= kTickTooLong;
  record_.time = time;
  record_.position = position();
  record_.attitude = attitude();
  findInput(time, length);
  record_.velocity = input_.velocityNow;
  faults |= outsideTheory() | outsideLoading();
  faults |= evaluate();
  if (!apply(std::min(length, longestTick_))) faults |= kLoadNotFinite;
  turnByInertia(length);
  holdLockedYaw(length);
  turnAddedMass(input_.ownAxes);
  immerseAddedMass();
  carryInertia();
  AddedMassConstraint& addedMass = added();
  addedMass.setMean(frame_.length(meanInEarth()));
  addedMass.beginTick(step);
  aimRestraint(length);
  return faults;
}

// A∞ follows the ship's heading and pitch, not its heel: it belongs to the upright axes of linear
// theory, as K and C do; turned with a hull that rolls, heave would excite sway at second order. On
// a fixed course forces do not pitch: they belong to H.
void Ship::turnAddedMass(const Mat3& own) const noexcept {
  const Mat3 level = rotationZ(std::atan2(own(1, 0), own(0, 0)));
  const Mat3 world = frame_.axes();
  const auto inWorld = [&](const Mat3& axes) { return Mat3(world * axes * world.transpose()); };
  added().follow({inWorld(free() ? own : level), inWorld(own)}, world, input_.turningShare);
}

void Ship::aimRestraint(double step) noexcept {
  if (!rig_->restraint.lent) return;
  const MeanCourse::Place next = line_.ahead(step);
  const Mat3 course = rotationZ(line_.heading()), heading = rotationZ(this->heading());
  const Vec3 way =
      course.transpose() *
      (Vec3(next.x, next.y, coefficients().ship.cog.z() + waterRate_ * step) - record_.position) /
      (step * frame_.metresPerUnit);
  const double turn = std::remainder(next.heading - this->heading(), 2.0 * kPi);
  const Vec3 swing = Vec3(-input_.eta[Roll], -input_.eta[Pitch], turn) / step;
  std::array<btScalar, 6> wanted;
  for (std::size_t i = 0; i < 3; ++i) {
    wanted[i] = static_cast<btScalar>(way[static_cast<int>(i)]);
    wanted[3 + i] = static_cast<btScalar>(swing[static_cast<int>(i)]);
  }
  rig_->restraint.lent->aim(toBulletBasis(frame_.axes() * course),
                            toBulletBasis(frame_.axes() * heading), wanted);
}

std::uint32_t Ship::endTick(btScalar step) noexcept {
  if (!std::exchange(begun_, false)) return kStepOk;
  AddedMassConstraint& addedMass = added();
  addedMass.endTick();
  const std::uint32_t faults = mendState();
  if ((faults & kStateNotFinite) != 0)
    addedMass.setPast(known_.linear, known_.angular, addedMass.pastAxes());
  velocityBefore_ = velocityAfter_;
  velocityAfter_ = velocityInEarth(addedMass.linearVelocity(), addedMass.angularVelocity());
  // The solver's rows hold the inertia of what is carried as well, which is no load of the water.
  const Vec6 carried = carried_ != nullptr && step > 0
                           ? Vec6(addedMass.carriedChange() / static_cast<double>(step))
                           : Vec6(Vec6::Zero());
  Vec6 load;
  load << toCourse() * frame_.forceToEarth(toBullet(addedMass.force() + carried.head<3>())),
      generalisedMoment(
          input_.ownAxes,
          frame_.momentToEarth(toBullet(addedMass.moment() + carried.tail<3>())) + turning_);
  if (!load.allFinite()) load.setZero();
  record_.loads[addedMassPart_] = load;
  stepBefore_ = lastStep_;
  lastStep_ = static_cast<double>(step);
  course_.advance(lastStep_);
  line_.advance(lastStep_);
  remember();
  return faults;
}

CUTWATER_PLUGIN_END
