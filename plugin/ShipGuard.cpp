// What a Bullet program does to a ship's body and constraints between two ticks.
#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
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
constexpr double kKnownTop = 1e-3;         // of the length: less is a hull known below water
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

// By address alone: the body may be gone.
bool lists(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
  const btCollisionObjectArray& objects = world.getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    if (objects[i] == &body) return true;
  }
  return false;
}

}  // namespace

template <class T>
bool Rig::constraintDeleted(void* ship, T& dying) {
  static_cast<Ship*>(ship)->constraintDeleted(dying);
  return false;
}

Rig::Rig(Ship& ship)
    : motionState(
          [](void* self, ShipMotionState& dying) {
            btRigidBody& body = static_cast<Ship*>(self)->body();
            if (body.getMotionState() == &dying) body.setMotionState(nullptr);
            return false;
          },
          &ship),
      body([](void* self,
              btRigidBody& dying) { return static_cast<Ship*>(self)->bodyDeleted(dying); },
           &ship),
      addedMass(&constraintDeleted<AddedMassConstraint>, &ship),
      restraint(&constraintDeleted<CourseRestraint>, &ship) {}

bool Ship::restrains() const noexcept {
  return std::find(restrained_.begin(), restrained_.end(), true) != restrained_.end();
}

// A body of the user's whose constraint somebody deleted may be gone as well.
bool Ship::inWorld() const noexcept {
  return (ownBody_ || rig_->addedMass.lent) && body_->isInWorld();
}

// A world that still lists a constraint of ours may live on, so nothing that it could read is freed
// unless it is known to be out of its lists.
void Ship::leaveWorld() {
  if (inWorld()) worldLives_ = true;
  if (worldLives_) {
    const bool stands = inWorld();
    takeOutOfWorld();
    if (ownBody_) takeJointsOut();
    if (stands && ownBody_) world_.removeRigidBody(body_);
    if (stands && !ownBody_) giveBack();
    return;
  }
  rig_->enable(false);
  rig_->addedMass.lent.abandon();
  rig_->restraint.lent.abandon();
  rig_->body.abandon();
}

// What of ours is in the lists of a world that lives.
void Ship::takeOutOfWorld() {
  if (rig_->addedMass.lent) world_.removeConstraint(rig_->addedMass.lent.get());
  if (rig_->restraint.lent) world_.removeConstraint(rig_->restraint.lent.get());
  for (btTypedConstraint* constraint : rig_->leftOver) world_.removeConstraint(constraint);
  rig_->leftOver.clear();
}

void Ship::takeJointsOut() noexcept {
  while (btTypedConstraint* foreign = foreignConstraint()) world_.removeConstraint(foreign);
}

void Ship::giveBack() noexcept {
  body_->setFlags((body_->getFlags() & ~kFlagsTaken) | flagsFound_);
  body_->setGravity(gravityFound_);
  body_->forceActivationState(activationFound_);
}

// The body is still whole. In the world, that lives. Taken out of it before, nothing is known: then
// our constraints, which the world may still list, and the memory of the body stay.
bool Ship::bodyDeleted(btRigidBody& dying) {
  const bool stands = dying.isInWorld();
  if (stands) {
    takeOutOfWorld();
    takeJointsOut();
    world_.removeRigidBody(&dying);
  } else {
    rig_->enable(false);
    const auto leave = [&](auto& lent) {
      if (!lent) return;
      rig_->leftOver.push_back(lent.get());
      lent.abandon();
    };
    leave(rig_->addedMass.lent);
    leave(rig_->restraint.lent);
  }
  adoptStandIn();
  return !stands;
}

void Ship::adoptStandIn() {
  rig_->addedMass.lent.end();
  rig_->restraint.lent.end();
  rig_->standIn = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
      btScalar(1) / inverseMass_, nullptr, nullptr, btVector3(1, 1, 1)));
  body_ = rig_->standIn.get();
  body_->setCenterOfMassTransform(known_.pose);
  added();
}

// Somebody removed it earlier, and we have put it back since. A body of the user's may be gone.
void Ship::constraintDeleted(btTypedConstraint& dying) noexcept {
  const bool stands = ownBody_ ? body_->isInWorld() : lists(world_, *body_);
  if (stands) world_.removeConstraint(&dying);
}

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
    Vec6 mass;
    mass.head<3>().setConstant(1.0 / static_cast<double>(inverseMass_));
    mass.tail<3>() = fromBullet(inverseInertia_).cwiseInverse();
    lent.make(*body_, frame_.mass(coefficients().addedMass.atInfinity), mass);
    if (nonlinear()) lent->setAddedMass(frame_.mass(addedMassNow()));
    turnAddedMass(ownAxesNow());
    if (carried_ != nullptr) {
      const Mat6 carried = frame_.mass(carriedMatrix());
      lent->carry(carried, carried);
    }
    lent->forgetPast();
    lent->setActive(parts_[addedMassPart_].on);
  }
  return *lent;
}

// A constraint of ours that somebody took out, or deleted, is put back for this tick. A tick proves
// that the world lives.
std::uint32_t Ship::keepConstraints() noexcept {
  std::uint32_t faults = kStepOk;
  const auto putBack = [&](auto& ours) {
    if (!ours.lent || stands(world_, ours)) return;
    if (!rig_->takenOut) faults |= kConstraintRemoved;
    world_.addConstraint(ours.lent.get());
  };
  try {
    if (!ownBody_ && !rig_->addedMass.lent && !lists(world_, *body_)) adoptStandIn();
    if (!body_->isInWorld()) {
      takeOutOfWorld();
      rig_->takenOut = true;
      return kStepOk;
    }
    added();
    if (restrains() && !rig_->restraint.lent) rig_->restraint.lent.make(*body_, restrained_);
    putBack(rig_->addedMass);
    putBack(rig_->restraint);
    rig_->takenOut = false;
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
  set(known_);
  return faults | kStateNotFinite;
}

void Ship::set(const Known& state) noexcept {
  body_->setCenterOfMassTransform(state.pose);
  body_->setInterpolationWorldTransform(state.pose);
  body_->setLinearVelocity(state.linear);
  body_->setAngularVelocity(state.angular);
  body_->setInterpolationLinearVelocity(state.linear);
  body_->setInterpolationAngularVelocity(state.angular);
}

std::uint32_t Ship::lookForChanges() noexcept {
  std::uint32_t faults = kStepOk;
  const Vec3 inertia = fromBullet(body_->getInvInertiaDiagLocal());
  const Vec3 right = fromBullet(inverseInertia_);
  bool same = nearly(static_cast<double>(body_->getInvMass()), static_cast<double>(inverseMass_));
  for (int i = 0; i < 3; ++i) same = same && nearly(inertia[i], right[i]);
  if (body_->getInvMass() > 0 && !same) faults |= kMassChanged;
  const bool ownGravity = body_->getGravity().length2() > 0;
  const bool asItWas = (world_.getGravity() - worldGravity_).length2() == 0;
  if (ownGravity ||
      (!asItWas && !gravityFits(world_.getGravity(), frame_, coefficients().ship.gravity)))
    faults |= kGravityChanged;
  return faults;
}

// Further than a correction: the ship was set there, and its mean course goes on from there.
std::uint32_t Ship::lookForMoves() noexcept {
  const btTransform& pose = body_->getWorldTransform();
  const double moved = frame_.metresPerUnit *
                       static_cast<double>((pose.getOrigin() - known_.pose.getOrigin()).length());
  if (moved <= kSetElsewhere * length() && turnBetween(known_.pose, pose) <= kTurnedAway)
    return kStepOk;
  const double before = ownAngles(frame_.rotationToEarth(known_.pose.getBasis())).z();
  const double turn = std::remainder(heading() - before, 2.0 * kPi);
  body_->updateInertiaTensor();
  const Vec3 at = position();
  beginFixed(at.x(), at.y(), course_.heading() + (std::abs(turn) > kSameHeading ? turn : 0.0),
             course_.speed());
  forget();
  return kCourseBegan;
}

// Wholly above the waves, or below them.
bool Ship::outOfWater() const noexcept {
  if (nonlinear()) {
    const std::size_t wet = wetted_->wetVertices();
    return wet == 0 || wet == pressureHull_->triangles().vertices();
  }
  const Hydrodynamics& hydro = hydrodynamics();
  const double above = input_.eta[Heave] - elevation_;  // G's calm place, over the waves
  const bool flies = hydro.keel() < 0.0 && above + hydro.keel() > 0.0;
  const bool drowns = hydro.top() > kKnownTop * length() && above + hydro.top() < 0.0;
  return flies || drowns;
}

std::uint32_t Ship::outsideTheory() const noexcept {
  std::uint32_t faults = kStepOk;
  const Vec6& eta = input_.eta;
  if (input_.speed >= growsAhead_ || -input_.speed >= growsAstern_) faults |= kSpeedOutsideTheory;
  if (input_.attitude(2, 2) < std::cos(kLargestTilt) || std::abs(eta[Yaw]) > kLargestYaw)
    faults |= kAttitudeOutsideTheory;
  if (outOfWater()) faults |= kOutOfWater;
  const bool waves = input_.ramp > 0.0 && !input_.sea->components().empty();
  if (!free() && waves && std::hypot(eta[Surge], eta[Sway]) > kFarOff * length())
    faults |= kFarFromCourse;
  return faults;
}

void Ship::remember() noexcept {
  known_ = {body_->getWorldTransform(), body_->getLinearVelocity(), body_->getAngularVelocity()};
}

CUTWATER_PLUGIN_END
