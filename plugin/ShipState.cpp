#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/FreeMotion.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "hydro/forces/linear/FreeRadiation.h"
#include "hydro/forces/nonlinear/CarriedLoad.h"
#include "plugin/Rig.h"
#include "plugin/SettingsCheck.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "plugin/ShipPart.h"

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

namespace {

constexpr double kUpright = kPi / 6.0, kBeyond = kPi / 4.0;

// Euler's angles up to kUpright of `tilt`, from kBeyond on those of a turn about a level axis after
// one about the vertical.
Vec3 goneOver(const Mat3& r, double tilt) {
  const Vec3 euler = eulerAngles(r);
  if (!(tilt > kUpright)) return euler;
  const Eigen::Quaterniond all(r);
  const double yaw = 2.0 * std::atan2(all.z(), all.w());
  const Eigen::Quaterniond back(Eigen::AngleAxisd(-yaw, Vec3::UnitZ()));
  const Vec3 axis = (back * all).vec();
  const double size = std::hypot(axis.x(), axis.y());
  const double turn = std::acos(std::clamp(r(2, 2), -1.0, 1.0));
  Vec3 swing = size > 0.0 ? Vec3(axis * (turn / size)) : Vec3(Vec3::Zero());
  swing.z() = yaw;
  const double share = std::min(1.0, (tilt - kUpright) / (kBeyond - kUpright));
  Vec3 way = swing - euler;
  way.z() = std::remainder(way.z(), 2.0 * kPi);
  Vec3 angles = euler + share * share * (3.0 - 2.0 * share) * way;
  angles.z() = std::remainder(angles.z(), 2.0 * kPi);
  return angles;
}

}  // namespace

Vec3 motionAngles(const Mat3& r) noexcept {
  return goneOver(r, std::acos(std::clamp(r(2, 2), -1.0, 1.0)));
}

Vec3 bowAngles(const Mat3& r) noexcept {
  return goneOver(r, std::asin(std::clamp(std::abs(r(2, 0)), 0.0, 1.0)));
}

const Hydrodynamics& Ship::hydrodynamics() const noexcept { return *tables_->hydrodynamics(); }
const Coefficients& Ship::coefficients() const noexcept { return hydrodynamics().coefficients(); }
double Ship::length() const noexcept { return hydrodynamics().length(); }

Vec3 Ship::position() const noexcept {
  return frame_.placeToEarth(body_->getWorldTransform().getOrigin());
}

Mat3 Ship::bodyAxes() const noexcept {
  return frame_.rotationToEarth(body_->getWorldTransform().getBasis());
}

Vec3 Ship::attitude() const noexcept { return eulerAngles(bodyAxes()); }

double Ship::heading() const noexcept { return ownAngles(bodyAxes()).z(); }

// A ship that turns over passes keel up, where motionAngles jump.
Vec3 Ship::ownAngles(const Mat3& attitude) const noexcept {
  return nonlinear() ? bowAngles(attitude) : motionAngles(attitude);
}

Mat3 Ship::ownAxesNow() const noexcept {
  const Vec3 angles = ownAngles(bodyAxes());
  return ownAxes(angles.z(), angles.y());
}

Vec6 Ship::velocityInEarth(const btVector3& linear, const btVector3& angular) const noexcept {
  Vec6 result;
  result << frame_.lengthToEarth(linear), frame_.directionToEarth(angular);
  result[Heave] -= waterRate_;
  return result;
}

Vec6 Ship::velocity() const noexcept {
  const Mat3 toBody = bodyAxes().transpose();
  return rotated(toBody, toBody,
                 velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity()));
}

Vec6 Ship::motion() const noexcept {
  TickInput input;
  findMotion(input);
  return input.eta;
}

// What the solver left: A∞v⁻ in the axes of that solve, and of a free ship the memory's share.
Vec6 Ship::waterMomentum() const noexcept {
  const Vec6 inWorld = addedMass().momentum();
  Vec6 momentum;
  momentum << frame_.forceToEarth(toBullet(Vec3(inWorld.head<3>()))),
      frame_.momentToEarth(toBullet(Vec3(inWorld.tail<3>())));
  return momentum;
}

Vec6 Ship::momentum() const noexcept {
  const Mat3 body = bodyAxes();
  const Vec6 inertia = (coefficients().ship.massMatrix() + carriedMatrix()) * velocity();
  const Vec6 momentum = rotated(body, body, inertia) + waterMomentum();
  if (radiation_ == nullptr || !enabled("radiation")) return momentum;
  const Mat3 own = frame_.axes().transpose() * addedMass().pastAxes().angular * frame_.axes();
  if (!input_.courseBegins) return momentum + rotated(own, own, radiation_->momentum());
  const Mat3 toOwn = own.transpose() * body;
  const Vec6 now = rotated(toOwn, toOwn, velocity());
  return momentum + rotated(own, own, radiation_->momentumOf({now[Surge], now[Sway], now[Yaw]}));
}

double Ship::energy() const noexcept {
  const Mat3 body = bodyAxes(), halfStep = 0.5 * lastStep_ * toCourse();
  const Vec6 own = this->velocity(), velocity = rotated(body, body, own);
  if (nonlinear()) return energyAtTick() + carriedEnergy();
  const Vec6 motion = this->motion() - rotated(halfStep, halfStep, velocity);
  const Mat6& given = coefficients().ship.restoring;
  const Mat6 restoring = free() ? freeRestoring(given) : given;
  return 0.5 * own.dot(coefficients().ship.massMatrix() * own) +
         0.5 * velocity.dot(waterMomentum()) + 0.5 * motion.dot(restoring * motion) +
         carriedEnergy();
}

// The velocities before and after the kick of a tick, with the place in between. Of a fixed course
// the linear axes of A∞ do not pitch (turnAddedMass).
double Ship::energyAtTick() const noexcept {
  const ShipParticulars& ship = coefficients().ship;
  const Mat3 toBody = input_.attitude.transpose();
  const Vec6 velocity = 0.5 * (velocityAfter_ + velocityBefore_);
  const Vec6 own = rotated(toBody, toBody, velocity);
  const Mat3& pitched = input_.ownAxes;
  const Mat3 level = rotationZ(std::atan2(pitched(1, 0), pitched(0, 0)));
  const Vec6 turned =
      rotated((free() ? pitched : level).transpose(), pitched.transpose(), velocity);
  const double gravity = ship.gravity, rho = ship.density;
  const double potential = mass() * gravity * (input_.position.z() - ship.cog.z()) -
                           rho * gravity * wetted_->volume() * wetted_->centre().z();
  const double added = parts_[addedMassPart_].on ? turned.dot(addedMassNow() * turned) : 0.0;
  return 0.5 * (own.dot(ship.massMatrix() * own) + added) + potential - pressureHull_->energy();
}

PointMotion Ship::pointMotion(const Vec3& point) const noexcept {
  const Vec6& now = velocityAfter_;
  // From the middle of one tick to the middle of the next.
  const double between = stepBefore_ > 0.0 ? 0.5 * (lastStep_ + stepBefore_) : lastStep_;
  const Vec6 rate = between > 0.0 ? Vec6((now - velocityBefore_) / between) : Vec6(Vec6::Zero());
  const Vec3 arm = bodyAxes() * (point - coefficients().ship.cog);
  const Vec3 velocity = now.head<3>(), spin = now.tail<3>();
  const Vec3 linear = rate.head<3>(), angular = rate.tail<3>();
  return {position() + arm, velocity + spin.cross(arm),
          linear + angular.cross(arm) + spin.cross(spin.cross(arm))};
}

std::optional<Wetted> Ship::wetted() const noexcept {
  if (!nonlinear()) return {};
  return Wetted{wetted_->area(), wetted_->volume(), wetted_->centre(), wetted_->immersion()};
}

std::vector<std::pair<Vec3, Vec3>> Ship::waterline() const {
  std::vector<std::pair<Vec3, Vec3>> pieces;
  if (!nonlinear()) return pieces;
  for (const auto& [a, b] : wetted_->waterline())
    pieces.emplace_back(wetted_->inEarth(a), wetted_->inEarth(b));
  return pieces;
}

double Ship::offCourse() const noexcept {
  const Vec3 at = position();
  return std::hypot(at.x() - course_.x(), at.y() - course_.y());
}

const AddedMassConstraint& Ship::addedMass() const noexcept { return added(); }

double Ship::draught(double time, double x) const noexcept {
  const Vec3 keel =
      position() + bodyAxes() * (Vec3(x, 0.0, hydrodynamics().keel()) - coefficients().ship.cog);
  return tables_->sea().elevation(time, keel.x(), keel.y()) - keel.z();
}

btTransform Ship::hullTransform() const noexcept {
  btTransform pose = body_->getWorldTransform();
  if (const btMotionState* drawn = body_->getMotionState()) drawn->getWorldTransform(pose);
  const btVector3 origin = pose * frame_.length(-coefficients().ship.cog);
  return btTransform(pose.getBasis() * toBulletBasis(frame_.axes()), origin);
}

btTransform Ship::poseAt(const Vec6& offset) const noexcept {
  const Vec3 mean(course_.x(), course_.y(), coefficients().ship.cog.z());
  const Mat3 course = rotationZ(course_.heading());
  return btTransform(frame_.rotation(course * attitudeMatrix(offset.tail<3>())),
                     frame_.place(mean + course * offset.head<3>()));
}

double Ship::modelScale() const noexcept {
  return coefficients().ship.file.metresPerUnit / frame_.metresPerUnit;
}

btTransform Ship::modelTransform() const noexcept {
  const FilePlacement& file = coefficients().ship.file;
  const btTransform inHull(toBulletBasis(modelScale() * file.rotation),
                           toBullet(Vec3(file.origin / frame_.metresPerUnit)));
  return hullTransform() * inHull;
}

void Ship::resetVelocity(const Vec3& linear, const Vec3& angular) noexcept {
  body_->setLinearVelocity(frame_.length(Vec3(linear + waterRate_ * Vec3::UnitZ())));
  body_->setAngularVelocity(frame_.direction(angular));
  startAgain();
  known_.linear = body_->getLinearVelocity();
  known_.angular = body_->getAngularVelocity();
  if (lockedYaw_.on) lockedYaw_.rate = angular.z();
}

void Ship::reset(const ShipStart& start) {
  checkStart(start, "Ship::reset");
  requireCourse(free() ? Mean::Free : Mean::Fixed, start.speed);
  if (!free()) onCourse_ = tables_->exact(start.heading, start.speed);  // what throws
  place(start);
}

void Ship::placeAt(double x, double y, double heading, const Vec6& offset, double speed) {
  reset({.x = x, .y = y, .heading = heading, .speed = speed, .offset = offset});
}

Ship::Snapshot Ship::save() const {
  Snapshot snapshot;
  save(snapshot);
  return snapshot;
}

void Ship::save(Snapshot& s) const {
  s.transform = body_->getWorldTransform();
  s.interpolated = body_->getInterpolationWorldTransform();
  s.velocities = velocitiesOf(*body_);
  s.past = {addedMass().linearVelocity(), addedMass().angularVelocity()};
  s.pastBody = added().pastBody();
  s.carries = added().carries();
  s.pastAxes = {addedMass().pastAxes().linear, addedMass().pastAxes().angular};
  s.before = velocityBefore_;
  s.lastStep = lastStep_;
  s.stepBefore = stepBefore_;
  s.courseBegins = input_.courseBegins;
  s.anew = anew_;
  s.activation = body_->getActivationState();
  s.now = static_cast<int>(now_);
  s.lockedYaw = {lockedYaw_.on ? 1.0 : 0.0, lockedYaw_.heading, lockedYaw_.rate};
  s.known = known_.pose;
  s.record = record_;
  course_.save(s.course);
  line_.save(s.line);
  s.predicted.resize(free() ? predicted_->stateSize() : 0);
  if (free()) predicted_->save(s.predicted);
  s.immersed.resize(nonlinear() ? wetted_->stateSize() : 0);
  if (nonlinear()) wetted_->save(s.immersed);
  saveParts(s);
}

void Ship::saveParts(Snapshot& s) const {
  s.hydrodynamicsKey = hydrodynamics().key();
  s.partsKey = partsKey_;
  s.sizes.resize(parts_.size());
  s.enabled.resize(parts_.size());
  std::size_t all = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    s.enabled[i] = parts_[i].on ? 1 : 0;
    s.sizes[i] = parts_[i].force ? parts_[i].force->stateSize() : 0;
    all += s.sizes[i];
  }
  s.states.resize(all);
  double* to = s.states.data();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (s.sizes[i] > 0) parts_[i].force->save({to, s.sizes[i]});
    to += s.sizes[i];
  }
}

// A part that had no state yet when the snapshot was taken had no past.
void Ship::checkParts(const Snapshot& s) const {
  const auto refuse = [](const std::string& why) {
    throw HydroError(Fault::BadArgument, "Ship::restore: " + why);
  };
  if (s.hydrodynamicsKey != hydrodynamics().key()) {
    refuse("the snapshot is of a ship of another database");
  }
  if (s.partsKey != partsKey_ || s.sizes.size() != parts_.size()) {
    refuse("the snapshot is of a ship whose load has other parts");
  }
  if (free() != !s.predicted.empty() || (free() && !predicted_->fits(s.predicted))) {
    refuse("the snapshot is of a ship on another kind of course, or in another sea");
  }
  if (s.immersed.size() != (nonlinear() ? wetted_->stateSize() : 0))
    refuse("the snapshot is of a ship in another mode");
  const double* from = s.states.data();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::span<const double> state(from, s.sizes[i]);
    from += s.sizes[i];
    if (state.empty() || (parts_[i].force && parts_[i].force->fits(state))) continue;
    if (preparedFor_ == 0.0) refuse("no tick length is known yet; prepare() first");
    refuse("\"" + parts_[i].name +
           "\" cannot take its state from the snapshot; it is of another ship or tick length");
  }
}

void Ship::restoreParts(const Snapshot& s) {
  const double* from = s.states.data();
  bool changed = false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    ShipPart& part = parts_[i];
    const bool on = s.enabled[i] != 0;
    changed = changed || part.on != on;
    part.on = on;
    if (i == addedMassPart_) added().setActive(on);
    if (!part.force) continue;
    if (s.sizes[i] > 0) {
      part.force->restore({from, s.sizes[i]});
    } else {
      part.force->reset();
    }
    from += s.sizes[i];
  }
  if (changed) partsChanged();
}

void Ship::restoreWetted(const Snapshot& s) {
  input_.position = s.record.position;
  input_.attitude = attitudeMatrix(s.record.attitude);
  input_.ownAxes = frame_.axes().transpose() * s.pastAxes[1] * frame_.axes();
  const WettedHull::Place place{input_.position, input_.attitude};
  wetted_->see(s.record.time, place, place, Vec6::Zero(), {0.0, 0.0});
  wetted_->restore(s.immersed);
  added().setAddedMass(frame_.mass(wetted_->mass().now));
}

void Ship::restore(const Snapshot& s) {
  checkParts(s);
  course_.restore(s.course);
  line_.restore(s.line);
  if (free()) predicted_->restore(s.predicted);
  if (nonlinear()) restoreWetted(s);
  restoreParts(s);
  putBack(*body_, s.transform, s.interpolated, s.velocities, s.activation);
  added().setPast(s.past[0], s.past[1], {s.pastAxes[0], s.pastAxes[1]});
  if (carried_ != nullptr) added().setCarried(frame_.mass(carriedMatrix()), s.pastBody, s.carries);
  velocityAfter_ = velocityInEarth(s.past[0], s.past[1]);
  velocityBefore_ = s.before;
  lastStep_ = s.lastStep;
  stepBefore_ = s.stepBefore;
  input_.courseBegins = s.courseBegins;
  anew_ = s.anew;
  now_ = static_cast<Now>(s.now);
  lockedYaw_ = {s.lockedYaw[0] != 0.0, s.lockedYaw[1], s.lockedYaw[2]};
  begun_ = false;
  record_ = s.record;
  remember();
  known_.pose = s.known;
  if (btMotionState* drawn = body_->getMotionState()) drawn->setWorldTransform(s.interpolated);
}

CUTWATER_PLUGIN_END
