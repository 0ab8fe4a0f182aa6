#include "plugin/Ship.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/AddedMassConstraint.h"
#include "plugin/CourseRestraint.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

// Gravity as the solver will apply it, in its own order of operations and rounding.
btVector3 gravityForce(const btRigidBody& body) {
  return body.getGravity() * (btScalar(1) / body.getInvMass());
}

bool finite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool stateFinite(const btRigidBody& body) {
  bool good = finite(body.getWorldTransform().getOrigin()) && finite(body.getLinearVelocity()) &&
              finite(body.getAngularVelocity());
  for (int i = 0; i < 3; ++i) good = good && finite(body.getWorldTransform().getBasis()[i]);
  return good;
}

}  // namespace

Ship::Ship(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
           std::shared_ptr<const SeaTables> tables, const ShipSettings& settings, btRigidBody* own)
    : world_(world),
      frame_(frame),
      tables_(std::move(tables)),
      course_(settings.model.mean == Mean::Filtered ? settings.model.followTime : 0.0),
      phasors_(tables_->sea().phasorBlocks()) {
  if (own != nullptr) {
    adoptBody(*own, settings);
  } else {
    createBody(settings);
  }
  makeParts(settings);
  body_->setDamping(0, 0);
  body_->setSleepingThresholds(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  addedMass_ = std::make_unique<AddedMassConstraint>(
      *body_, frame_.mass(coefficients().addedMass.atInfinity));
  switchOff(settings.model.without);
  const auto& held = settings.model.restrained;
  const auto grows = [&](const GrowthLimit& limit) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return held.at(static_cast<std::size_t>(limit.mode)) ? kNever : limit.speed.value_or(kNever);
  };
  growsAhead_ = grows(hydrodynamics().stability().ahead);
  growsAstern_ = grows(hydrodynamics().stability().astern);
  if (std::find(held.begin(), held.end(), true) != held.end())
    restraint_ = std::make_unique<CourseRestraint>(*body_, held);
  startAgain();
  if (ownBody_) world_.addRigidBody(body_);
  world_.addConstraint(addedMass_.get());
  if (restraint_) world_.addConstraint(restraint_.get());
}

Ship::~Ship() {
  if (restraint_) world_.removeConstraint(restraint_.get());
  world_.removeConstraint(addedMass_.get());
  if (ownBody_) world_.removeRigidBody(body_);
}

void Ship::createBody(const ShipSettings& settings) {
  const ShipParticulars& ship = coefficients().ship;
  const ShipStart& start = settings.start;
  btCollisionShape* given = settings.collision.shape;
  if (given == nullptr) hullShape_ = convexHull(ship, frame_);
  if (given != nullptr && settings.collision.inHullAxes) compound_ = aboutG(*given, ship, frame_);
  ownBody_ = makeBody(ship, frame_, compound_ ? *compound_ : given ? *given : *hullShape_);
  body_ = ownBody_.get();
  course_.reset(start.x, start.y, start.heading, start.speed);
  body_->setCenterOfMassTransform(poseAt(start.offset));
  const Vec6 velocity = rotated(bodyAxes(), bodyAxes(), start.velocity);
  const Vec3 along = rotationZ(start.heading) * Vec3(start.speed, 0.0, 0.0);
  body_->setLinearVelocity(frame_.length(Vec3(along + velocity.head<3>())));
  body_->setAngularVelocity(frame_.direction(velocity.tail<3>()));
}

void Ship::adoptBody(btRigidBody& own, const ShipSettings& settings) {
  requireBodyOf(coefficients().ship, frame_, own);
  body_ = &own;
  const Vec3 at = position();
  course_.reset(at.x(), at.y(), attitude()[2], settings.start.speed);
}

// v⁻ is the velocity as it is; a filtered course begins at it.
void Ship::startAgain() noexcept {
  turnAddedMass(headingAxes());
  addedMass_->forgetPast();
  velocityBefore_ = velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity());
  lastStep_ = stepBefore_ = 0.0;
  courseBeginsHere();
  headingAtSolve_ = course_.heading();
}

void Ship::courseBeginsHere() noexcept {
  if (!course_.follows()) return;
  const Vec3 at = position();
  const double heading = attitude()[2];
  const double ahead = (rotationZ(-heading) * velocityBefore_.head<3>()).x();
  course_.reset(at.x(), at.y(), heading, ahead, velocityBefore_[Yaw]);
  input_.courseBegins = true;
}

Mat3 Ship::toCourse() const noexcept { return rotationZ(-course_.heading()); }

// Bullet moves x_{n+1} = x_n + h v_{n+1}: v_n is the mean over the tick that ended at t_n, centred
// at t_n − h_n/2, and v_n + (v_n − v_{n−1}) h_n/(h_n + h_{n−1}) is second order at t_n, of equal
// ticks (3 v_n − v_{n−1})/2. Blows since the last solve are not in it.
void Ship::findMotion(TickInput& input, const Mat3& heading) const noexcept {
  const Mat3 course = toCourse(), toHeading = heading.transpose();
  const Vec3 mean(course_.x(), course_.y(), coefficients().ship.cog.z());
  const Vec6 velocity =
      velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  Vec6 steady = Vec6::Zero();
  steady[Surge] = course_.speed();
  steady[Yaw] = course_.turnRate();
  input.eta << course * (position() - mean), eulerAngles(course * bodyAxes());
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
  now.weight = toCourse() * frame_.forceToEarth(gravityForce(*body_));
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
}

void Ship::prepare(double step) {
  preparedFor_ = 0.0;
  for (ShipPart& part : parts_) {
    if (part.force) part.force->prepare(step);
  }
  preparedFor_ = step;
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

void Ship::undoWeight(btScalar step) noexcept {
  const btVector3 change = gravityForce(*body_) * body_->getInvMass() * step;
  if (finite(change)) body_->setLinearVelocity(body_->getLinearVelocity() - change);
}

// Impulses, not forces: Bullet keeps forces over all ticks of one stepSimulation. The part of the
// restoring load that carries the weight undoes Bullet's gravity in the solver's own arithmetic.
bool Ship::apply(btScalar step, const Mat3& heading) noexcept {
  const Vec6 loads = sumOfLoads();
  undoWeight(step);
  if (!loads.allFinite()) return false;  // without loads, but carried
  const Vec6 impulse =
      static_cast<double>(step) * rotated(rotationZ(course_.heading()), heading, loads);
  body_->applyCentralImpulse(frame_.force(impulse.head<3>()));
  body_->applyTorqueImpulse(frame_.moment(impulse.tail<3>()));
  return true;
}

// The last solve went wrong and the user has mended the body since: its past is gone.
bool Ship::recovered() noexcept {
  if (finite(addedMass_->linearVelocity()) && finite(addedMass_->angularVelocity())) return false;
  startAgain();
  for (ShipPart& part : parts_) {
    if (part.force) part.force->reset();
  }
  return true;
}

std::uint32_t Ship::beginTick(double time, btScalar step) noexcept {
  // Bullet would look up a simulation island for a constraint whose body has none.
  const bool wasInWorld = addedMass_->isEnabled();
  addedMass_->setEnabled(body_->isInWorld());
  if (restraint_) restraint_->setEnabled(body_->isInWorld());
  if (!body_->isInWorld()) return kBodyNotInWorld;
  if (!wasInWorld) startAgain();
  if (!(body_->getInvMass() > 0)) return kStepOk;  // held still by the user for now
  if (!stateFinite(*body_)) return kStateNotFinite;
  if (!(step > 0)) {
    addedMass_->setEnabled(false);
    undoWeight(step);
    return kTickNotPositive;
  }
  std::uint32_t faults = matchTick(static_cast<double>(step));
  if (recovered()) faults |= kStateNotFinite;
  body_->setDamping(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  record_.time = time;
  record_.position = position();
  record_.attitude = attitude();
  const Mat3 heading = rotationZ(record_.attitude.z());
  findInput(time, static_cast<double>(step), heading);
  record_.velocity = input_.velocityNow;
  if (input_.speed >= growsAhead_ || -input_.speed >= growsAstern_) faults |= kSpeedOutsideTheory;
  faults |= evaluate(heading);
  if (!apply(step, heading)) faults |= kLoadNotFinite;
  turnAddedMass(heading);
  const Vec3 mean = rotationZ(headingAtSolve_) * Vec3(input_.speed, 0.0, 0.0);
  addedMass_->setMean(frame_.length(mean), input_.meanHeading - headingAtSolve_, frame_.upwards());
  addedMass_->beginTick(step);
  aimRestraint(heading, static_cast<double>(step));
  return faults;
}

// A∞ follows the ship's heading, not its heel: it belongs to the upright axes of linear theory, as
// K and C do; turned with a hull that rolls, heave would excite sway at second order.
void Ship::turnAddedMass(const Mat3& heading) noexcept {
  addedMass_->follow(frame_.rotation(heading));
}

void Ship::aimRestraint(const Mat3& heading, double step) noexcept {
  if (!restraint_) return;
  const MeanCourse::Place next = course_.ahead(step);
  const Mat3 course = rotationZ(input_.meanHeading);
  const Vec3 way = course.transpose() *
                   (Vec3(next.x, next.y, coefficients().ship.cog.z()) - record_.position) /
                   (step * frame_.metresPerUnit);
  const double turn = std::remainder(next.heading - record_.attitude.z(), 2.0 * kPi);
  const Vec3 swing = Vec3(-input_.eta[Roll], -input_.eta[Pitch], turn) / step;
  std::array<btScalar, 6> wanted;
  for (std::size_t i = 0; i < 3; ++i) {
    wanted[i] = static_cast<btScalar>(way[static_cast<int>(i)]);
    wanted[3 + i] = static_cast<btScalar>(swing[static_cast<int>(i)]);
  }
  restraint_->aim(toBulletBasis(frame_.axes() * course), toBulletBasis(frame_.axes() * heading),
                  wanted);
}

void Ship::endTick(btScalar step) noexcept {
  if (!addedMass_->isEnabled()) return;
  velocityBefore_ = velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  addedMass_->endTick();
  Vec6 force;
  force << frame_.forceToEarth(toBullet(addedMass_->force())),
      frame_.momentToEarth(toBullet(addedMass_->moment()));
  const double heading = attitude().z();
  record_.loads[addedMassPart_] = rotated(toCourse(), rotationZ(-heading), force);
  headingAtSolve_ = course_.heading();
  stepBefore_ = lastStep_;
  lastStep_ = static_cast<double>(step);
  const Vec3 at = position();
  const Vec6 velocity =
      velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  course_.advance(lastStep_, {at.x(), at.y(), heading, velocity[0], velocity[1], velocity[Yaw]});
}

CUTWATER_PLUGIN_END
