#include "plugin/Ship.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"

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
           std::shared_ptr<ShipModel> model, const ShipSettings& settings, btRigidBody* own)
    : world_(world),
      frame_(frame),
      model_(std::move(model)),
      coefficients_(model_->coefficients()),
      memoryModel_(settings.memory),
      length_(model_->length()),
      keel_(model_->keel()),
      course_(settings.mean == Mean::Filtered ? settings.followTime : 0.0),
      restoring_(coefficients_),
      supplementary_(coefficients_.ship.supplementary, course_.follows()),
      keepers_(coefficients_.ship, coefficients_.addedMassInf, length_) {
  if (own != nullptr) {
    adoptBody(*own, settings);
  } else {
    createBody(settings);
  }
  makeExcitation(course_.heading(), course_.speed());
  if (settings.hullLift && course_.follows()) lift_.emplace(coefficients_, length_);
  if (settings.keepSpeed) keepSpeed(*settings.keepSpeed);
  if (settings.keepCourse) keepCourse(*settings.keepCourse);
  body_->setDamping(0, 0);
  body_->setSleepingThresholds(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  addedMass_ =
      std::make_unique<AddedMassConstraint>(*body_, frame_.mass(coefficients_.addedMassInf));
  const auto& held = settings.restrained;
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

void Ship::createBody(const ShipSettings& s) {
  const ShipParticulars& ship = coefficients_.ship;
  if (s.shape == nullptr) hullShape_ = convexHull(ship, frame_);
  if (s.shape != nullptr && s.shapeInHullAxes) compound_ = aboutG(*s.shape, ship, frame_);
  ownBody_ = makeBody(ship, frame_, compound_ ? *compound_ : s.shape ? *s.shape : *hullShape_);
  body_ = ownBody_.get();
  course_.reset(s.x, s.y, s.heading, s.speed);
  body_->setCenterOfMassTransform(poseAt(s.offset));
  const Vec6 velocity = rotated(bodyAxes(), bodyAxes(), s.velocity);
  const Vec3 along = rotationZ(s.heading) * Vec3(s.speed, 0.0, 0.0);
  body_->setLinearVelocity(frame_.length(Vec3(along + velocity.head<3>())));
  body_->setAngularVelocity(frame_.direction(velocity.tail<3>()));
}

void Ship::adoptBody(btRigidBody& own, const ShipSettings& settings) {
  requireBodyOf(coefficients_.ship, frame_, own);
  body_ = &own;
  const Vec3 at = position();
  course_.reset(at.x(), at.y(), attitude()[2], settings.speed);
}

// On a fixed course exact, once and for all; on one that turns from the table that all ships share.
void Ship::makeExcitation(double heading, double speed) {
  if (!course_.follows()) {
    excitation_.emplace(coefficients_, model_->sea(), heading, speed, usableForm(coefficients_));
  } else if (excitation_) {
    excitation_->renew(heading, speed);
  } else {
    excitation_.emplace(model_->excitation(), heading, speed);
  }
}

// v⁻ is the velocity as it is; a filtered course begins at it.
void Ship::startAgain() noexcept {
  turnAddedMass(headingAxes());
  addedMass_->forgetPast();
  velocityBefore_ = velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity());
  courseBeginsHere();
  headingAtSolve_ = course_.heading();
}

void Ship::courseBeginsHere() noexcept {
  if (!course_.follows()) return;
  const Vec3 at = position();
  const double heading = attitude()[2];
  const double ahead = (rotationZ(-heading) * velocityBefore_.head<3>()).x();
  course_.reset(at.x(), at.y(), heading, ahead, velocityBefore_[Yaw]);
  if (excitation_) excitation_->renew(heading, ahead);
}

Mat3 Ship::toCourse() const noexcept { return rotationZ(-course_.heading()); }

// Bullet moves x_{n+1} = x_n + h v_{n+1}: v_n is the mean over the tick that ended at t_n, centred
// at t_n − h/2, and (3 v_n − v_{n−1})/2 is second order at t_n. Blows since the last solve are not
// in it.
ShipMotion Ship::motionAt(double time, const Mat3& heading) const noexcept {
  const Mat3 course = toCourse(), toHeading = heading.transpose();
  const Vec3 mean(course_.x(), course_.y(), coefficients_.ship.cog.z());
  const Vec6 velocity =
      velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  Vec6 steady = Vec6::Zero();
  steady[Surge] = course_.speed();
  steady[Yaw] = course_.turnRate();
  ShipMotion motion;
  motion.time = time;
  motion.eta << course * (position() - mean), eulerAngles(course * bodyAxes());
  motion.etaDot = rotated(course, toHeading, velocity) - steady;
  motion.etaDotNow = rotated(course, toHeading, 1.5 * velocity - 0.5 * velocityBefore_) - steady;
  motion.meanX = course_.x();
  motion.meanY = course_.y();
  motion.meanHeading = course_.heading();
  motion.speed = course_.speed();
  motion.turnRate = course_.turnRate();
  return motion;
}

void Ship::prepare(double step) {
  radiation_.emplace(model_->radiation(memoryModel_), step, course_.follows());
}

// Bullet's tick is a float in one build: 1e-6 tells another length from another rounding.
std::uint32_t Ship::matchTick(double step) noexcept {
  const bool known = radiation_.has_value();
  if (known && std::abs(radiation_->memory().step() - step) <= 1e-6 * step) return kStepOk;
  try {
    prepare(step);
  } catch (...) {
    radiation_.reset();
    return kTickLengthChanged | kLoadNotFinite;
  }
  return known ? kTickLengthChanged : kStepOk;
}

void Ship::evaluate(const ShipMotion& motion) noexcept {
  ForceParts& parts = record_.forces;
  parts.gravity.setZero();
  parts.gravity.head<3>() = toCourse() * frame_.forceToEarth(gravityForce(*body_));
  parts.restoring = restoring_.at(motion) - parts.gravity;
  excitation_->at(motion);
  parts.froudeKrylov = excitation_->froudeKrylov();
  parts.diffraction = excitation_->diffraction();
  parts.radiation = radiation_ ? radiation_->at(motion) : Vec6::Zero();
  parts.supplementary = supplementary_.at(motion) + keepers_.at(motion);
  if (lift_) parts.supplementary += lift_->at(motion);
}

// Impulses, not forces: Bullet keeps forces over all ticks of one stepSimulation. The part of the
// restoring load that carries the weight undoes Bullet's gravity in the solver's own arithmetic.
bool Ship::apply(btScalar step, const Mat3& heading) noexcept {
  const ForceParts& p = record_.forces;
  const Vec6 loads =
      p.gravity + p.restoring + p.froudeKrylov + p.diffraction + p.radiation + p.supplementary;
  const btVector3 weightChange = gravityForce(*body_) * body_->getInvMass() * step;
  if (finite(weightChange)) body_->setLinearVelocity(body_->getLinearVelocity() - weightChange);
  if (!loads.allFinite()) return false;  // without loads, but carried
  const Vec6 impulse =
      static_cast<double>(step) * rotated(rotationZ(course_.heading()), heading, loads);
  body_->applyCentralImpulse(frame_.force(impulse.head<3>()));
  body_->applyTorqueImpulse(frame_.moment(impulse.tail<3>()));
  return true;
}

// The last solve went wrong and the user has mended the body since: her past is gone.
bool Ship::recovered() noexcept {
  if (finite(addedMass_->linearVelocity()) && finite(addedMass_->angularVelocity())) return false;
  startAgain();
  if (radiation_) radiation_->memory().reset();
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
  std::uint32_t faults = matchTick(static_cast<double>(step));
  if (recovered()) faults |= kStateNotFinite;
  body_->setDamping(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  record_.time = time;
  record_.position = position();
  record_.attitude = attitude();
  const Mat3 heading = rotationZ(record_.attitude.z()), toBody = bodyAxes().transpose();
  const ShipMotion motion = motionAt(time, heading);
  Vec6 velocity = motion.etaDotNow;
  velocity[Surge] += motion.speed;
  velocity[Yaw] += motion.turnRate;
  record_.velocity = rotated(toBody * rotationZ(motion.meanHeading), toBody * heading, velocity);
  evaluate(motion);
  if (!apply(step, heading)) faults |= kLoadNotFinite;
  turnAddedMass(heading);
  const Vec3 mean = rotationZ(headingAtSolve_) * Vec3(motion.speed, 0.0, 0.0);
  addedMass_->setMean(frame_.length(mean), motion.meanHeading - headingAtSolve_, frame_.upwards());
  addedMass_->beginTick(step);
  aimRestraint(motion, heading, static_cast<double>(step));
  return faults;
}

// A∞ follows her heading, not her heel: it belongs to the upright axes of linear theory, as K and C
// do; turned with a hull that rolls, heave would excite sway at second order.
void Ship::turnAddedMass(const Mat3& heading) noexcept {
  addedMass_->follow(frame_.rotation(heading));
}

void Ship::aimRestraint(const ShipMotion& motion, const Mat3& heading, double step) noexcept {
  if (!restraint_) return;
  const MeanCourse::Place next = course_.ahead(step);
  const Mat3 course = rotationZ(motion.meanHeading);
  const Vec3 way = course.transpose() *
                   (Vec3(next.x, next.y, coefficients_.ship.cog.z()) - record_.position) /
                   (step * frame_.metresPerUnit);
  const double turn = std::remainder(next.heading - record_.attitude.z(), 2.0 * kPi);
  const Vec3 swing = Vec3(-motion.eta[Roll], -motion.eta[Pitch], turn) / step;
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
  record_.forces.addedMass = rotated(toCourse(), rotationZ(-heading), force);
  headingAtSolve_ = course_.heading();
  lastStep_ = static_cast<double>(step);
  const Vec3 at = position();
  const Vec6 velocity =
      velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  course_.advance(lastStep_, {at.x(), at.y(), heading, velocity[0], velocity[1], velocity[Yaw]});
}

CUTWATER_PLUGIN_END
