#include "plugin/Ship.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/Rig.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kLargestCorrection = 0.05;  // of a locked heading in a tick [rad]

}  // namespace

Ship::Ship(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
           std::shared_ptr<const SeaTables> tables, const ShipSettings& settings, btRigidBody* own)
    : world_(world),
      frame_(frame),
      tables_(std::move(tables)),
      rig_(std::make_unique<Rig>(*this)),
      ownBody_(own == nullptr),
      restrained_(settings.model.restrained),
      course_(settings.model.mean == Mean::Filtered ? settings.model.followTime : 0.0),
      phasors_(tables_->sea().phasorBlocks()) {
  const ShipStart& start = settings.start;
  if (ownBody_) {
    course_.reset(start.x, start.y, start.heading, start.speed);
    createBody(settings.collision);
  } else {
    adoptBody(*own);
    const Vec3 at = position();
    course_.reset(at.x(), at.y(), attitude()[2], start.speed);
  }
  makeParts(settings);
  rig_->addedMass.lent.make(*body_, frame_.mass(coefficients().addedMass.atInfinity));
  switchOff(settings.model.without);
  findLimits();
  if (std::find(restrained_.begin(), restrained_.end(), true) != restrained_.end())
    rig_->restraint.lent.make(*body_, restrained_);
  takeOver();
  if (ownBody_) {
    place(start);
    world_.addRigidBody(body_);
  } else {
    startAgain();
    remember();
  }
  world_.addConstraint(rig_->addedMass.lent.get());
  if (rig_->restraint.lent) world_.addConstraint(rig_->restraint.lent.get());
}

Ship::~Ship() { leaveWorld(); }

void Ship::createBody(const CollisionShape& collision) {
  const ShipParticulars& ship = coefficients().ship;
  btCollisionShape* given = collision.shape;
  if (given == nullptr) hullShape_ = convexHull(ship, frame_, collision.deck);
  if (given != nullptr && collision.inHullAxes) compound_ = aboutG(*given, ship, frame_);
  rig_->motionState.make(poseAt(Vec6::Zero()));
  rig_->body.make(bodyInfo(ship, frame_,
                           compound_          ? *compound_
                           : given != nullptr ? *given
                                              : *hullShape_));
  body_ = rig_->body.get();
  body_->setMotionState(rig_->motionState.get());
}

void Ship::adoptBody(btRigidBody& own) {
  requireBodyOf(coefficients().ship, frame_, own);
  body_ = &own;
}

// What Bullet would do to the body and the ship does itself; it is given back in giveBack().
void Ship::takeOver() {
  flagsFound_ = body_->getFlags() & kFlagsTaken;
  gravityFound_ = body_->getGravity();
  activationFound_ = body_->getActivationState();
  body_->setFlags((body_->getFlags() & ~kFlagsTaken) | BT_DISABLE_WORLD_GRAVITY);
  body_->setGravity(btVector3(0, 0, 0));
  body_->forceActivationState(DISABLE_DEACTIVATION);
  inverseMass_ = body_->getInvMass();
  inverseInertia_ = body_->getInvInertiaDiagLocal();
  worldGravity_ = world_.getGravity();
}

// Speeds at which free motions grow, and the tick that the fastest of them can bear.
void Ship::findLimits() {
  const auto grows = [&](const GrowthLimit& limit) {
    const bool held = restrained_.at(static_cast<std::size_t>(limit.mode));
    return std::min(held ? kNever : limit.speed.value_or(kNever), hydrodynamics().fastest());
  };
  growsAhead_ = grows(hydrodynamics().stability().ahead);
  growsAstern_ = grows(hydrodynamics().stability().astern);
  const Mat6& stiffness = coefficients().ship.restoring;
  const Mat6& added = coefficients().addedMass.atInfinity;
  const Mat6 inertia = coefficients().ship.massMatrix() + 0.5 * (added + added.transpose());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> modes(
      0.5 * (stiffness + stiffness.transpose()), inertia, Eigen::EigenvaluesOnly);
  const double fastest = modes.eigenvalues()[5];
  longestTick_ = fastest > 0.0 ? 1.0 / std::sqrt(fastest) : kNever;
}

// As a new ship with this start. The body is ours, or one that has come to its place.
void Ship::place(const ShipStart& start) noexcept {
  course_.reset(start.x, start.y, start.heading, start.speed);
  const btTransform pose = poseAt(start.offset);
  body_->setCenterOfMassTransform(pose);
  const Vec6 velocity = rotated(bodyAxes(), bodyAxes(), start.velocity);
  const Vec3 along = rotationZ(start.heading) * Vec3(start.speed, 0.0, 0.0);
  const btVector3 linear = frame_.length(Vec3(along + velocity.head<3>()));
  const btVector3 angular = frame_.direction(velocity.tail<3>());
  body_->setLinearVelocity(linear);
  body_->setAngularVelocity(angular);
  body_->setInterpolationWorldTransform(pose);
  body_->setInterpolationLinearVelocity(linear);
  body_->setInterpolationAngularVelocity(angular);
  if (btMotionState* drawn = body_->getMotionState()) drawn->setWorldTransform(pose);
  body_->clearForces();
  body_->forceActivationState(DISABLE_DEACTIVATION);
  record_.time = 0.0;
  record_.position = record_.attitude = Vec3::Zero();
  record_.velocity.setZero();
  for (Vec6& load : record_.loads) load.setZero();
  broken_ = kNone;
  lockedYaw_ = {};
  now_ = Now::Ticks;
  begun_ = false;
  forget();
  remember();
}

// As if the ship had been as it is for ever.
void Ship::forget() noexcept {
  startAgain();
  for (ShipPart& part : parts_) {
    if (part.force) part.force->reset();
  }
}

// v⁻ is the velocity as it is; a filtered course begins at it.
void Ship::startAgain() noexcept {
  turnAddedMass(headingAxes());
  added().forgetPast();
  velocityAfter_ = velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity());
  velocityBefore_ = velocityAfter_;
  lastStep_ = stepBefore_ = 0.0;
  input_.courseBegins = true;
  courseBeginsHere();
  headingAtSolve_ = course_.heading();
}

void Ship::courseBeginsHere() noexcept {
  if (!course_.follows()) return;
  const Vec3 at = position();
  const double heading = this->heading();
  const double ahead = (rotationZ(-heading) * velocityBefore_.head<3>()).x();
  course_.reset(at.x(), at.y(), heading, ahead, velocityBefore_[Yaw]);
}

Mat3 Ship::toCourse() const noexcept { return rotationZ(-course_.heading()); }

// Bullet moves x_{n+1} = x_n + h v_{n+1}: v_n is the mean over the tick that ended at t_n, centred
// at t_n − h_n/2, and v_n + (v_n − v_{n−1}) h_n/(h_n + h_{n−1}) is second order at t_n, of equal
// ticks (3 v_n − v_{n−1})/2. Blows since the last solve are not in it.
void Ship::findMotion(TickInput& input, const Mat3& heading) const noexcept {
  const Mat3 course = toCourse(), toHeading = heading.transpose();
  const Vec3 mean(course_.x(), course_.y(), coefficients().ship.cog.z());
  const Vec6& velocity = velocityAfter_;
  Vec6 steady = Vec6::Zero();
  steady[Surge] = course_.speed();
  steady[Yaw] = course_.turnRate();
  input.eta << course * (position() - mean), motionAngles(course * bodyAxes());
  input.etaDot = rotated(course, toHeading, velocity) - steady;
  const double ahead = stepBefore_ > 0.0 ? lastStep_ / (lastStep_ + stepBefore_) : 0.5;
  input.etaDotNow =
      rotated(course, toHeading, (1.0 + ahead) * velocity - ahead * velocityBefore_) - steady;
}

void Ship::findInput(double time, double step, const Mat3& heading) noexcept {
  TickInput& now = input_;
  now.time = time;
  now.step = step;
  now.lastStep = lastStep_ > 0.0 ? lastStep_ : step;
  now.position = position();
  now.attitude = bodyAxes();
  now.weight = coefficients().ship.mass * (toCourse() * frame_.lengthToEarth(world_.getGravity()));
  now.meanX = course_.x();
  now.meanY = course_.y();
  now.meanHeading = course_.heading();
  now.speed = course_.speed();
  now.turnRate = course_.turnRate();
  findMotion(now, heading);
  Vec6 velocity = now.etaDotNow;
  velocity[Surge] += now.speed;
  velocity[Yaw] += now.turnRate;
  const Mat3 toBody = now.attitude.transpose();
  now.velocityNow = rotated(toBody * rotationZ(now.meanHeading), toBody * heading, velocity);
  now.sea = &tables_->sea();
  now.ramp = now.sea->ramp(time);
  now.sea->phasors(time, now.meanX, now.meanY, phasors_);
  now.phasors = phasors_;
  elevation_ = now.ramp * now.sea->elevation(now.phasors);
}

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

Vec6 Ship::inCourseAxes(const Wrench& wrench, const Mat3& heading) const noexcept {
  if (wrench.axes == Axes::Course) return wrench.load;
  const Mat3 toEarth = wrench.axes == Axes::Own ? input_.attitude : Mat3(Mat3::Identity());
  return rotated(toCourse() * toEarth, heading.transpose() * toEarth, wrench.load);
}

// A load that is not finite is left out; with what carries the ship its weight is left out as well.
std::uint32_t Ship::evaluate(const Mat3& heading) noexcept {
  std::uint32_t faults = kStepOk;
  Vec6& gravity = record_.loads[gravityPart_];
  gravity.setZero();
  gravity.head<3>() = input_.weight;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    ShipPart& part = parts_[i];
    if (!part.force) continue;
    Vec6& load = record_.loads[i];
    load = part.active() ? inCourseAxes(evaluatePart(part), heading) : Vec6(Vec6::Zero());
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

// Impulses, not forces: Bullet keeps forces over all ticks of one stepSimulation.
bool Ship::apply(double step, const Mat3& heading) noexcept {
  const Vec6 loads = sumOfLoads();
  if (!loads.allFinite()) return false;
  const Vec6 impulse = step * rotated(rotationZ(course_.heading()), heading, loads);
  body_->applyCentralImpulse(frame_.force(impulse.head<3>()));
  body_->applyTorqueImpulse(frame_.moment(impulse.tail<3>()));
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
  const auto enable = [this](bool on) {
    if (rig_->addedMass.lent) rig_->addedMass.lent->setEnabled(on);
    if (rig_->restraint.lent) rig_->restraint.lent->setEnabled(on);
  };
  enable(false);
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
  enable(true);
  now_ = Now::Ticks;
  begun_ = true;
  return faults | tick(time, step);
}

// A contact may wake the ship within this tick.
void Ship::readyToWake(btScalar step) noexcept {
  added().setEnabled(true);
  turnAddedMass(headingAxes());
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
  const Mat3 heading = headingAxes();
  findInput(time, length, heading);
  record_.velocity = input_.velocityNow;
  faults |= outsideTheory();
  faults |= evaluate(heading);
  if (!apply(std::min(length, longestTick_), heading)) faults |= kLoadNotFinite;
  turnByInertia(length);
  holdLockedYaw(length);
  turnAddedMass(heading);
  AddedMassConstraint& addedMass = added();
  const Vec3 mean = rotationZ(headingAtSolve_) * Vec3(input_.speed, 0.0, 0.0);
  addedMass.setMean(frame_.length(mean), input_.meanHeading - headingAtSolve_, frame_.upwards());
  addedMass.beginTick(step);
  aimRestraint(heading, length);
  return faults;
}

// A∞ follows the ship's heading, not its heel: it belongs to the upright axes of linear theory, as
// K and C do; turned with a hull that rolls, heave would excite sway at second order.
void Ship::turnAddedMass(const Mat3& heading) noexcept { added().follow(frame_.rotation(heading)); }

void Ship::aimRestraint(const Mat3& heading, double step) noexcept {
  if (!rig_->restraint.lent) return;
  const MeanCourse::Place next = course_.ahead(step);
  const Mat3 course = rotationZ(input_.meanHeading);
  const Vec3 way = course.transpose() *
                   (Vec3(next.x, next.y, coefficients().ship.cog.z()) - record_.position) /
                   (step * frame_.metresPerUnit);
  const double turn =
      std::remainder(next.heading - input_.meanHeading - input_.eta[Yaw], 2.0 * kPi);
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
  Vec6 force;
  force << frame_.forceToEarth(toBullet(addedMass.force())),
      frame_.momentToEarth(toBullet(addedMass.moment()));
  if (!force.allFinite()) force.setZero();
  const double heading = this->heading();
  record_.loads[addedMassPart_] = rotated(toCourse(), rotationZ(-heading), force);
  headingAtSolve_ = course_.heading();
  stepBefore_ = lastStep_;
  lastStep_ = static_cast<double>(step);
  const Vec3 at = position();
  course_.advance(lastStep_, {at.x(), at.y(), heading, velocityAfter_[0], velocityAfter_[1],
                              velocityAfter_[Yaw]});
  remember();
  return faults;
}

CUTWATER_PLUGIN_END
