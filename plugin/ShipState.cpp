#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"

CUTWATER_PLUGIN_BEGIN

namespace {

Mat3 attitudeMatrix(const Vec3& rollPitchYaw) {
  return (Eigen::AngleAxisd(rollPitchYaw[2], Vec3::UnitZ()) *
          Eigen::AngleAxisd(rollPitchYaw[1], Vec3::UnitY()) *
          Eigen::AngleAxisd(rollPitchYaw[0], Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace

Vec3 eulerAngles(const Mat3& r) noexcept {
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
          std::atan2(r(1, 0), r(0, 0))};
}

Vec3 Ship::position() const noexcept {
  return frame_.placeToEarth(body_->getWorldTransform().getOrigin());
}

Mat3 Ship::bodyAxes() const noexcept {
  return frame_.rotationToEarth(body_->getWorldTransform().getBasis());
}

Vec3 Ship::attitude() const noexcept { return eulerAngles(bodyAxes()); }

// Axes with the ship's own heading, but upright: those of moments and of added mass.
Mat3 Ship::headingAxes() const noexcept { return rotationZ(attitude().z()); }

Vec6 Ship::velocityInEarth(const btVector3& linear, const btVector3& angular) const noexcept {
  Vec6 result;
  result << frame_.lengthToEarth(linear), frame_.directionToEarth(angular);
  return result;
}

Vec6 Ship::velocity() const noexcept {
  const Mat3 toBody = bodyAxes().transpose();
  return rotated(toBody, toBody,
                 velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity()));
}

Vec6 Ship::motion() const noexcept { return motionAt(0.0, headingAxes()).eta; }

PointMotion Ship::pointMotion(const Vec3& point) const noexcept {
  const Vec6 now = velocityInEarth(addedMass_->linearVelocity(), addedMass_->angularVelocity());
  const Vec6 rate =
      lastStep_ > 0.0 ? Vec6((now - velocityBefore_) / lastStep_) : Vec6(Vec6::Zero());
  const Vec3 arm = bodyAxes() * (point - coefficients_.ship.cog);
  const Vec3 velocity = now.head<3>(), spin = now.tail<3>();
  const Vec3 linear = rate.head<3>(), angular = rate.tail<3>();
  return {position() + arm, velocity + spin.cross(arm),
          linear + angular.cross(arm) + spin.cross(spin.cross(arm))};
}

double Ship::draught(double time, double x) const noexcept {
  const Vec3 keel = position() + bodyAxes() * (Vec3(x, 0.0, keel_) - coefficients_.ship.cog);
  return model_->sea().elevation(time, keel.x(), keel.y()) - keel.z();
}

btTransform Ship::hullTransform() const noexcept {
  const btTransform& pose = body_->getWorldTransform();
  const btVector3 origin = pose * frame_.length(-coefficients_.ship.cog);
  return btTransform(pose.getBasis() * toBulletBasis(frame_.axes()), origin);
}

btTransform Ship::poseAt(const Vec6& offset) const noexcept {
  const Vec3 mean(course_.x(), course_.y(), coefficients_.ship.cog.z());
  const Mat3 course = rotationZ(course_.heading());
  return btTransform(frame_.rotation(course * attitudeMatrix(offset.tail<3>())),
                     frame_.place(mean + course * offset.head<3>()));
}

void Ship::resetVelocity(const Vec3& linear, const Vec3& angular) noexcept {
  body_->setLinearVelocity(frame_.length(linear));
  body_->setAngularVelocity(frame_.direction(angular));
  startAgain();
}

void Ship::placeAt(double x, double y, double heading, const Vec6& offset, double speed) {
  makeExcitation(heading, speed);
  course_.reset(x, y, heading, speed);
  body_->setCenterOfMassTransform(poseAt(offset));
  resetVelocity(rotationZ(heading) * Vec3(speed, 0.0, 0.0), Vec3::Zero());
  if (radiation_) radiation_->memory().reset();
}

Ship::Snapshot Ship::save() const {
  Snapshot snapshot;
  save(snapshot);
  return snapshot;
}

void Ship::save(Snapshot& s) const {
  s.transform = body_->getWorldTransform();
  s.interpolated = body_->getInterpolationWorldTransform();
  s.velocities = {body_->getLinearVelocity(), body_->getAngularVelocity(),
                  body_->getInterpolationLinearVelocity(),
                  body_->getInterpolationAngularVelocity()};
  s.past = {addedMass_->linearVelocity(), addedMass_->angularVelocity()};
  s.pastAxes = addedMass_->pastAxes();
  s.before = velocityBefore_;
  s.headingAtSolve = headingAtSolve_;
  s.record = record_;
  course_.save(s.course);
  s.keepers = keepers_.save();
  s.memory.resize(radiation_ ? radiation_->memory().stateSize() : 0);
  if (radiation_) radiation_->memory().save(s.memory);
  s.excitation.resize(excitation_->stateSize());
  excitation_->save(s.excitation);
}

void Ship::restore(const Snapshot& s) {
  if (!s.memory.empty() && !radiation_) {
    throw HydroError(Fault::BadArgument,
                     "Ship::restore: no tick length is known yet; prepare() first");
  }
  MeanCourse course = course_;
  course.restore(s.course);
  if (!s.memory.empty()) radiation_->memory().restore(s.memory);
  if (s.memory.empty() && radiation_) radiation_->memory().reset();
  const bool moved = course.heading() != course_.heading() || course.speed() != course_.speed();
  if (moved && !course.follows()) makeExcitation(course.heading(), course.speed());
  excitation_->restore(s.excitation);
  course_ = course;
  keepers_.restore(s.keepers);
  body_->setCenterOfMassTransform(s.transform);
  body_->setInterpolationWorldTransform(s.interpolated);
  body_->setLinearVelocity(s.velocities[0]);
  body_->setAngularVelocity(s.velocities[1]);
  body_->setInterpolationLinearVelocity(s.velocities[2]);
  body_->setInterpolationAngularVelocity(s.velocities[3]);
  addedMass_->setPast(s.past[0], s.past[1], s.pastAxes);
  velocityBefore_ = s.before;
  headingAtSolve_ = s.headingAtSolve;
  record_ = s.record;
}

CUTWATER_PLUGIN_END
