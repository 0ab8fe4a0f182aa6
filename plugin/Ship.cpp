#include "plugin/Ship.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "plugin/ShipBody.h"

CUTWATER_PLUGIN_BEGIN

namespace {

Mat3 rotationZ(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(); }

Mat3 attitudeMatrix(const Vec3& rollPitchYaw) {
  return (Eigen::AngleAxisd(rollPitchYaw[2], Vec3::UnitZ()) *
          Eigen::AngleAxisd(rollPitchYaw[1], Vec3::UnitY()) *
          Eigen::AngleAxisd(rollPitchYaw[0], Vec3::UnitX()))
      .toRotationMatrix();
}

// The two halves of a velocity or a force, each by its own rotation.
Vec6 rotated(const Mat3& linear, const Mat3& angular, const Vec6& v) {
  Vec6 result;
  result << linear * v.head<3>(), angular * v.tail<3>();
  return result;
}

Mat3 attitudeOf(const btRigidBody& body) { return fromBullet(body.getWorldTransform().getBasis()); }

// Axes with the ship's own heading, but upright: those of moments and of added mass.
Mat3 headingOf(const btRigidBody& body) { return rotationZ(eulerAngles(attitudeOf(body)).z()); }

Vec6 sixOf(const btVector3& linear, const btVector3& angular) {
  Vec6 result;
  result << fromBullet(linear), fromBullet(angular);
  return result;
}

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

Vec3 eulerAngles(const Mat3& r) noexcept {
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
          std::atan2(r(1, 0), r(0, 0))};
}

Ship::Ship(btDiscreteDynamicsWorld& world, const Coefficients& coefficients, const SeaState& sea,
           const ShipSettings& settings, btRigidBody* own)
    : world_(world),
      coefficients_(coefficients),
      sea_(sea),
      courseX_(settings.x),
      courseY_(settings.y),
      courseHeading_(settings.heading),
      restrained_(settings.restrained),
      restoring_(coefficients),
      excitation_(coefficients, sea, settings.heading),
      supplementary_(coefficients.ship.supplementary) {
  if (own != nullptr) {
    adoptBody(*own);
  } else {
    createBody(settings);
  }
  body_->setDamping(0, 0);
  body_->setSleepingThresholds(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  addedMass_ = std::make_unique<AddedMassConstraint>(*body_, coefficients.addedMassInf);
  turnAddedMass(headingOf(*body_));
  addedMass_->forgetPast();
  resetVelocity(fromBullet(body_->getLinearVelocity()), fromBullet(body_->getAngularVelocity()));
  if (ownBody_) world_.addRigidBody(body_);
  world_.addConstraint(addedMass_.get());
  restrain();
}

Ship::~Ship() {
  if (restraint_) world_.removeConstraint(restraint_.get());
  world_.removeConstraint(addedMass_.get());
  if (ownBody_) world_.removeRigidBody(body_);
}

void Ship::createBody(const ShipSettings& settings) {
  if (settings.shape == nullptr) hullShape_ = convexHull(coefficients_.ship);
  ownBody_ = makeBody(coefficients_.ship, settings.shape ? *settings.shape : *hullShape_);
  body_ = ownBody_.get();
  body_->setCenterOfMassTransform(poseAt(settings.offset));
  const Vec6 velocity = rotated(attitudeOf(*body_), attitudeOf(*body_), settings.velocity);
  body_->setLinearVelocity(toBullet(velocity.head<3>()));
  body_->setAngularVelocity(toBullet(velocity.tail<3>()));
}

void Ship::adoptBody(btRigidBody& own) {
  requireBodyOf(coefficients_.ship, own);
  body_ = &own;
  const Vec3 at = position();
  courseX_ = at.x();
  courseY_ = at.y();
  courseHeading_ = attitude()[2];
  excitation_ = ExcitationForce(coefficients_, sea_, courseHeading_);
}

btTransform Ship::poseAt(const Vec6& offset) const noexcept {
  const Vec3 mean(courseX_, courseY_, coefficients_.ship.cog.z());
  const Mat3 course = rotationZ(courseHeading_);
  return btTransform(toBulletBasis(course * attitudeMatrix(offset.tail<3>())),
                     toBullet(mean + course * offset.head<3>()));
}

void Ship::restrain() {
  if (restraint_) world_.removeConstraint(restraint_.get());
  restraint_ = makeRestraint(*body_, poseAt(Vec6::Zero()), restrained_);
  if (restraint_) world_.addConstraint(restraint_.get());
}

Vec3 Ship::position() const noexcept { return fromBullet(body_->getWorldTransform().getOrigin()); }

Vec3 Ship::attitude() const noexcept { return eulerAngles(attitudeOf(*body_)); }

Vec6 Ship::velocity() const noexcept {
  const Mat3 toBody = attitudeOf(*body_).transpose();
  return rotated(toBody, toBody, sixOf(body_->getLinearVelocity(), body_->getAngularVelocity()));
}

Vec6 Ship::motion() const noexcept { return motionAt(0.0, headingOf(*body_)).eta; }

Mat3 Ship::toCourse() const noexcept { return rotationZ(-courseHeading_); }

// Bullet moves x_{n+1} = x_n + h v_{n+1}: v_n is the mean over the tick that ended at t_n, centred
// at t_n − h/2, and (3 v_n − v_{n−1})/2 is second order at t_n. Blows since the last solve are not
// in it.
ShipMotion Ship::motionAt(double time, const Mat3& heading) const noexcept {
  const Mat3 course = toCourse(), toHeading = heading.transpose();
  const Vec3 mean(courseX_, courseY_, coefficients_.ship.cog.z());
  const Vec6 velocity = sixOf(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  ShipMotion motion;
  motion.time = time;
  motion.eta << course * (position() - mean), eulerAngles(course * attitudeOf(*body_));
  motion.etaDot = rotated(course, toHeading, velocity);
  motion.etaDotNow = rotated(course, toHeading, 1.5 * velocity - 0.5 * velocityBefore_);
  motion.meanX = courseX_;
  motion.meanY = courseY_;
  return motion;
}

void Ship::resetVelocity(const Vec3& linear, const Vec3& angular) noexcept {
  body_->setLinearVelocity(toBullet(linear));
  body_->setAngularVelocity(toBullet(angular));
  turnAddedMass(headingOf(*body_));
  addedMass_->forgetPast();
  velocityBefore_ = sixOf(body_->getLinearVelocity(), body_->getAngularVelocity());
}

void Ship::placeAt(double x, double y, double heading, const Vec6& offset) {
  ExcitationForce excitation(coefficients_, sea_, heading);
  excitation_ = std::move(excitation);
  courseX_ = x;
  courseY_ = y;
  courseHeading_ = heading;
  body_->setCenterOfMassTransform(poseAt(offset));
  resetVelocity(Vec3::Zero(), Vec3::Zero());
  restrain();
  if (radiation_) radiation_->memory().reset();
}

Ship::Snapshot Ship::save() const {
  Snapshot s;
  s.transform = body_->getWorldTransform();
  s.interpolated = body_->getInterpolationWorldTransform();
  s.velocities = {body_->getLinearVelocity(), body_->getAngularVelocity(),
                  body_->getInterpolationLinearVelocity(),
                  body_->getInterpolationAngularVelocity()};
  s.past = {addedMass_->linearVelocity(), addedMass_->angularVelocity()};
  s.pastAxes = addedMass_->pastAxes();
  s.before = velocityBefore_;
  s.record = record_;
  s.course = {courseX_, courseY_, courseHeading_};
  if (radiation_) s.memory = radiation_->memory().save();
  return s;
}

void Ship::restore(const Snapshot& s) {
  const std::array<double, 3> course{courseX_, courseY_, courseHeading_};
  if (s.memory && !radiation_) {
    throw HydroError(Fault::BadArgument,
                     "Ship::restore: no tick length is known yet; prepare() first");
  }
  if (s.memory) radiation_->memory().restore(*s.memory);
  if (!s.memory && radiation_) radiation_->memory().reset();
  if (course != s.course) placeAt(s.course[0], s.course[1], s.course[2]);
  if (s.memory && course != s.course) radiation_->memory().restore(*s.memory);
  body_->setCenterOfMassTransform(s.transform);
  body_->setInterpolationWorldTransform(s.interpolated);
  body_->setLinearVelocity(s.velocities[0]);
  body_->setAngularVelocity(s.velocities[1]);
  body_->setInterpolationLinearVelocity(s.velocities[2]);
  body_->setInterpolationAngularVelocity(s.velocities[3]);
  addedMass_->setPast(s.past[0], s.past[1], s.pastAxes);
  velocityBefore_ = s.before;
  record_ = s.record;
}

void Ship::prepare(double step) { radiation_.emplace(coefficients_, step); }

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
  parts.gravity.head<3>() = toCourse() * fromBullet(gravityForce(*body_));
  parts.restoring = restoring_.at(motion) - parts.gravity;
  excitation_.at(motion);
  parts.froudeKrylov = excitation_.froudeKrylov();
  parts.diffraction = excitation_.diffraction();
  parts.radiation = radiation_ ? radiation_->at(motion) : Vec6::Zero();
  parts.supplementary = supplementary_.at(motion);
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
      static_cast<double>(step) * rotated(rotationZ(courseHeading_), heading, loads);
  body_->applyCentralImpulse(toBullet(impulse.head<3>()));
  body_->applyTorqueImpulse(toBullet(impulse.tail<3>()));
  return true;
}

std::uint32_t Ship::beginTick(double time, btScalar step) noexcept {
  // Bullet would look up a simulation island for a constraint whose body has none.
  const bool wasInWorld = addedMass_->isEnabled();
  addedMass_->setEnabled(body_->isInWorld());
  if (!body_->isInWorld()) return kBodyNotInWorld;
  if (!wasInWorld) {
    resetVelocity(fromBullet(body_->getLinearVelocity()), fromBullet(body_->getAngularVelocity()));
  }
  if (!(body_->getInvMass() > 0)) return kStepOk;  // held still by the user for now
  if (!stateFinite(*body_)) return kStateNotFinite;
  std::uint32_t faults = matchTick(static_cast<double>(step));
  if (!finite(addedMass_->linearVelocity()) || !finite(addedMass_->angularVelocity())) {
    // The last solve went wrong and the user has mended the body since: her past is gone.
    resetVelocity(fromBullet(body_->getLinearVelocity()), fromBullet(body_->getAngularVelocity()));
    if (radiation_) radiation_->memory().reset();
    faults |= kStateNotFinite;
  }
  body_->setDamping(0, 0);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  record_.time = time;
  record_.position = position();
  record_.attitude = attitude();
  const Mat3 heading = rotationZ(record_.attitude.z());
  const ShipMotion motion = motionAt(time, heading);
  const Mat3 toBody = attitudeOf(*body_).transpose();
  record_.velocity =
      rotated(toBody * rotationZ(courseHeading_), toBody * heading, motion.etaDotNow);
  record_.wave = sea_.elevation(time, record_.position.x(), record_.position.y());
  evaluate(motion);
  if (!apply(step, heading)) faults |= kLoadNotFinite;
  turnAddedMass(heading);
  addedMass_->beginTick(step);
  return faults;
}

// A∞ follows her heading, not her heel: it belongs to the upright axes of linear theory, as K and C
// do; turned with a hull that rolls, heave would excite sway at second order.
void Ship::turnAddedMass(const Mat3& heading) noexcept {
  addedMass_->follow(toBulletBasis(heading));
}

void Ship::endTick() noexcept {
  if (!addedMass_->isEnabled()) return;
  velocityBefore_ = sixOf(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  addedMass_->endTick();
  record_.forces.addedMass << addedMass_->force(), addedMass_->moment();
  record_.forces.addedMass =
      rotated(toCourse(), headingOf(*body_).transpose(), record_.forces.addedMass);
}

CUTWATER_PLUGIN_END
