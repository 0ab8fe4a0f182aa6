// What a Bullet program does to a ship's body and constraints between two ticks.
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/Rig.h"
#include "plugin/Ship.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kSetElsewhere = 0.25;     // of the length: further than a correction by hand
constexpr double kTurnedAway = kPi / 6.0;  // [rad] likewise
constexpr double kSameHeading = 0.1;       // [rad]: a fixed course keeps its heading
constexpr double kFarOff = 0.5;            // of the length, from the mean place
constexpr double kLargestYaw = kPi / 4.0;  // [rad] from the mean heading
constexpr double kSameMass = 1e-4;         // more than rounding of 1/(1/m)

bool finite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool stateFinite(const btRigidBody& body) {
  bool good = finite(body.getWorldTransform().getOrigin()) && finite(body.getLinearVelocity()) &&
              finite(body.getAngularVelocity());
  for (int i = 0; i < 3; ++i) good = good && finite(body.getWorldTransform().getBasis()[i]);
  return good;
}

// Of the rotation from one pose to the other.
double turnBetween(const btTransform& a, const btTransform& b) {
  const Mat3 turn = fromBullet(a.getBasis()).transpose() * fromBullet(b.getBasis());
  return std::acos(std::clamp(0.5 * (turn.trace() - 1.0), -1.0, 1.0));
}

bool nearly(double value, double right) {
  return std::abs(value - right) <= kSameMass * std::abs(right);
}

// Bullet keeps no place in a constraint; it is looked for where it was, then everywhere.
template <class T>
bool stands(const btDiscreteDynamicsWorld& world, RigConstraint<T>& ours) {
  const btTypedConstraint* wanted = ours.lent.get();
  const int count = world.getNumConstraints();
  if (ours.place < count && world.getConstraint(ours.place) == wanted) return true;
  for (ours.place = 0; ours.place < count; ++ours.place) {
    if (world.getConstraint(ours.place) == wanted) return true;
  }
  return false;
}

}  // namespace

// A world that still lists a constraint of ours may live on, so nothing that it could read is freed
// unless it is known to be out of its lists. A body of the user's whose constraint somebody deleted
// may be gone as well.
void Ship::leaveWorld() {
  AddedMassConstraint* added = rig_->addedMass.lent.get();
  const bool known = ownBody_ || added != nullptr;
  if (known && (worldLives_ || body_->isInWorld())) {
    if (added != nullptr) world_.removeConstraint(added);
    if (rig_->restraint.lent) world_.removeConstraint(rig_->restraint.lent.get());
    if (!body_->isInWorld()) return;
    if (!ownBody_) {
      body_->setFlags(flagsFound_);
      if ((flagsFound_ & BT_DISABLE_WORLD_GRAVITY) == 0) body_->setGravity(world_.getGravity());
      return;
    }
    while (btTypedConstraint* foreign = foreignConstraint()) world_.removeConstraint(foreign);
    world_.removeRigidBody(body_);
    return;
  }
  if (added != nullptr) added->setEnabled(false);
  if (rig_->restraint.lent) rig_->restraint.lent->setEnabled(false);
  rig_->addedMass.lent.abandon();
  rig_->restraint.lent.abandon();
  rig_->body.abandon();
}

// Called while the body is still whole. Who deletes it has found it in the world, which so lives.
void Ship::bodyDeleted() {
  btRigidBody& dying = *body_;
  if (rig_->addedMass.lent) world_.removeConstraint(rig_->addedMass.lent.get());
  if (rig_->restraint.lent) world_.removeConstraint(rig_->restraint.lent.get());
  if (dying.isInWorld()) world_.removeRigidBody(&dying);
  const ShipParticulars& ship = coefficients().ship;
  rig_->standIn = std::make_unique<btRigidBody>(bodyInfo(ship, frame_, *dying.getCollisionShape()));
  body_ = rig_->standIn.get();
  body_->setCenterOfMassTransform(known_.pose);
  rig_->restraint.lent.end();
  rig_->addedMass.lent.make(*body_, frame_.mass(coefficients().addedMass.atInfinity));
}

void Ship::motionStateDeleted() noexcept { body_->setMotionState(nullptr); }

btTypedConstraint* Ship::foreignConstraint() const noexcept {
  if (!ownBody_) return nullptr;
  for (int i = 0; i < world_.getNumConstraints(); ++i) {
    btTypedConstraint* constraint = world_.getConstraint(i);
    if (constraint == rig_->addedMass.lent.get() || constraint == rig_->restraint.lent.get())
      continue;
    if (&constraint->getRigidBodyA() == body_ || &constraint->getRigidBodyB() == body_)
      return constraint;
  }
  return nullptr;
}

// A new one for one that somebody deleted; what happened before is not felt by it.
AddedMassConstraint& Ship::added() const {
  Lent<AddedMassConstraint>& lent = rig_->addedMass.lent;
  if (!lent) {
    lent.make(*body_, frame_.mass(coefficients().addedMass.atInfinity));
    lent->follow(frame_.rotation(headingAxes()));
    lent->forgetPast();
    lent->setActive(parts_[addedMassPart_].on);
  }
  return *lent;
}

// A constraint of ours that somebody took out, or deleted, is put back for this tick.
std::uint32_t Ship::keepConstraints() noexcept {
  if (!body_->isInWorld()) return kStepOk;
  std::uint32_t faults = kStepOk;
  const auto putBack = [&](auto& ours) {
    if (!ours.lent || stands(world_, ours)) return;
    faults |= kConstraintRemoved;
    world_.addConstraint(ours.lent.get());
  };
  try {
    added();
    const bool restrains = std::count(restrained_.begin(), restrained_.end(), true) > 0;
    if (restrains && !rig_->restraint.lent) rig_->restraint.lent.make(*body_, restrained_);
    putBack(rig_->addedMass);
    putBack(rig_->restraint);
  } catch (...) {  // no memory for a new one
    faults |= kConstraintRemoved;
  }
  return faults;
}

// Forces that are not finite are taken off, a state that is not finite is put back to the last one
// that was.
std::uint32_t Ship::mendState() noexcept {
  std::uint32_t faults = kStepOk;
  if (!finite(body_->getTotalForce()) || !finite(body_->getTotalTorque())) {
    body_->clearForces();
    faults |= kLoadNotFinite;
  }
  if (stateFinite(*body_)) return faults;
  body_->setWorldTransform(known_.pose);
  body_->setInterpolationWorldTransform(known_.pose);
  body_->setLinearVelocity(known_.linear);
  body_->setAngularVelocity(known_.angular);
  body_->setInterpolationLinearVelocity(known_.linear);
  body_->setInterpolationAngularVelocity(known_.angular);
  body_->updateInertiaTensor();
  return faults | kStateNotFinite;
}

std::uint32_t Ship::lookForChanges() noexcept {
  std::uint32_t faults = kStepOk;
  const Vec3 inertia = fromBullet(body_->getInvInertiaDiagLocal());
  const Vec3 right = fromBullet(inverseInertia_);
  bool same = nearly(static_cast<double>(body_->getInvMass()), static_cast<double>(inverseMass_));
  for (int i = 0; i < 3; ++i) same = same && nearly(inertia[i], right[i]);
  if (body_->getInvMass() > 0 && !same) faults |= kMassChanged;
  const bool ownGravity = body_->getGravity().length2() > 0;
  if (ownGravity || (world_.getGravity() - worldGravity_).length2() > 0) faults |= kGravityChanged;
  return faults;
}

// Further than a correction: the ship was set there, and its mean course goes on from there.
std::uint32_t Ship::lookForMoves() noexcept {
  const btTransform& pose = body_->getWorldTransform();
  const double moved = frame_.metresPerUnit *
                       static_cast<double>((pose.getOrigin() - known_.pose.getOrigin()).length());
  if (moved <= kSetElsewhere * length() && turnBetween(known_.pose, pose) <= kTurnedAway)
    return kStepOk;
  const double before = motionAngles(frame_.rotationToEarth(known_.pose.getBasis())).z();
  const double turn = std::remainder(heading() - before, 2.0 * kPi);
  const Vec3 at = position();
  course_.reset(at.x(), at.y(), course_.heading() + (std::abs(turn) > kSameHeading ? turn : 0.0),
                course_.speed());
  forget();
  return kCourseBegan;
}

std::uint32_t Ship::outsideTheory() const noexcept {
  std::uint32_t faults = kStepOk;
  const Hydrodynamics& hydro = hydrodynamics();
  const Vec6& eta = input_.eta;
  if (input_.speed >= growsAhead_ || -input_.speed >= growsAstern_) faults |= kSpeedOutsideTheory;
  if (input_.attitude(2, 2) < std::cos(kLargestTilt) || std::abs(eta[Yaw]) > kLargestYaw)
    faults |= kAttitudeOutsideTheory;
  const double above = eta[Heave] - elevation_;  // G's calm place, over the waves
  const bool flies = hydro.keel() < 0.0 && above + hydro.keel() > 0.0;
  const bool drowns = hydro.top() > 0.0 && above + hydro.top() < 0.0;
  if (flies || drowns) faults |= kOutOfWater;
  const bool waves = input_.ramp > 0.0 && !input_.sea->components().empty();
  if (!course_.follows() && waves && std::hypot(eta[Surge], eta[Sway]) > kFarOff * length())
    faults |= kFarFromCourse;
  return faults;
}

void Ship::remember() noexcept {
  known_ = {body_->getWorldTransform(), body_->getLinearVelocity(), body_->getAngularVelocity()};
}

CUTWATER_PLUGIN_END
