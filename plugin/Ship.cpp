#include "plugin/Ship.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/Errors.h"
#include "hydro/base/SymmetricEigen.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/OwnAxes.h"
#include "hydro/forces/PredictedMotion.h"
#include "hydro/forces/SeaTables.h"
#include "hydro/forces/WettedHull.h"
#include "plugin/Rig.h"
#include "plugin/ShipAxes.h"
#include "plugin/ShipBody.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kBeforePitching = 0.8;

// Munk's moment in pitch, U²(A33(0) − A11(0))θ, would turn the ship over where it is C55; its terms
// grow no more from well below that speed.
double fastestFree(const Hydrodynamics& hydro) {
  const Mat6& A = hydro.coefficients().addedMass.atZero;
  const double munk = A(Heave, Heave) - A(Surge, Surge), C55 = hydro.ship().restoring(Pitch, Pitch);
  const double overturns = munk > 0.0 && C55 > 0.0 ? std::sqrt(C55 / munk) : kNever;
  return std::min(hydro.fastest(), kBeforePitching * overturns);
}

}  // namespace

Ship::Ship(btDiscreteDynamicsWorld& world, const WorldFrame& frame,
           std::shared_ptr<const SeaTables> tables, const ShipSettings& settings, btRigidBody* own)
    : world_(world),
      frame_(frame),
      tables_(std::move(tables)),
      rig_(std::make_unique<Rig>(*this)),
      ownBody_(own == nullptr),
      restrained_(settings.model.restrained),
      fastest_(settings.model.mean == Mean::Free ? fastestFree(hydrodynamics())
                                                 : hydrodynamics().fastest()),
      phasors_(tables_->sea().phasorBlocks()) {
  const ShipStart& start = settings.start;
  requireCourse(settings.model.mean, start.speed);
  if (settings.model.mean == Mean::Free)
    predicted_ = std::make_shared<PredictedMotion>(tables_, ActiveParts{.restrained = restrained_});
  if (ownBody_) {
    beginFixed(start.x, start.y, start.heading, start.speed);
    createBody(settings.collision);
  } else {
    adoptBody(*own);
    const Vec3 at = position();
    beginFixed(at.x(), at.y(), attitude()[2], start.speed);
  }
  makeWetted(settings.model);
  makeParts(settings);
  rig_->addedMass.lent.make(*body_, frame_.mass(coefficients().addedMass.atInfinity));
  switchOff(settings.model.without);
  findLimits();
  if (restrains()) rig_->restraint.lent.make(*body_, restrained_);
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

// The report's form has the lift of the stern drive a ship sideways that goes astern.
void Ship::requireCourse(Mean mean, double speed) const {
  if (mean == Mean::Free || !(speed < 0.0) || hydrodynamics().form() == ForwardSpeedForm::Tuck)
    return;
  throw HydroError(Fault::ValueOutOfRange,
                   "start.speed = " + std::to_string(speed) +
                       " m/s on a fixed course: the report's form of the speed terms holds ahead "
                       "only; take Tuck's, or Mean::Free");
}

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

void Ship::makeWetted(const ShipModel& model) {
  const bool usual = free() && hydrodynamics().closedHull();
  const HullPressure mode =
      model.mode.value_or(usual ? HullPressure::Nonlinear : HullPressure::Linear);
  if (mode == HullPressure::Linear) return;
  pressureHull_ = tables_->pressureHull(static_cast<std::size_t>(model.hullTriangles));
  wetted_ =
      std::make_shared<WettedHull>(pressureHull_, tables_, model.immersion == Immersion::Scaled);
}

// Speeds at which free motions grow, and the tick that the fastest of them can bear.
void Ship::findLimits() {
  const auto grows = [&](const GrowthLimit& limit) {
    const bool held = restrained_.at(static_cast<std::size_t>(limit.mode));
    return std::min(held ? kNever : limit.speed.value_or(kNever), fastest_);
  };
  growsAhead_ = growsAstern_ = fastest_;
  if (!free() || hydrodynamics().form() == ForwardSpeedForm::Tuck) {
    growsAhead_ = grows(hydrodynamics().stability().ahead);
    growsAstern_ = grows(hydrodynamics().stability().astern);
  }
  const Mat6& stiffness = coefficients().ship.restoring;
  const Mat6& added = coefficients().addedMass.atInfinity;
  const Mat6 inertia = coefficients().ship.massMatrix() + 0.5 * (added + added.transpose());
  const double fastest =
      symmetricEigenvalues(0.5 * (stiffness + stiffness.transpose()), inertia)[5];
  longestTick_ = fastest > 0.0 ? 1.0 / std::sqrt(fastest) : kNever;
}

// As a new ship with this start. The body is ours, or one that has come to its place.
void Ship::place(const ShipStart& start) noexcept {
  beginFixed(start.x, start.y, start.heading, start.speed);
  const btTransform pose = poseAt(start.offset);
  body_->setCenterOfMassTransform(pose);
  const Vec6 velocity = rotated(bodyAxes(), bodyAxes(), start.velocity);
  const Vec3 along = rotationZ(start.heading) * Vec3(start.speed, 0.0, 0.0);
  set({pose, frame_.length(Vec3(along + velocity.head<3>() + waterRate_ * Vec3::UnitZ())),
       frame_.direction(velocity.tail<3>())});
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
  anew_ = true;
  for (ShipPart& part : parts_) {
    if (part.force) part.force->reset();
  }
}

// The hull in the water as it is now, without a past.
void Ship::lookAgain() noexcept {
  if (!nonlinear()) return;
  input_.time = record_.time;
  input_.position = position();
  input_.attitude = bodyAxes();
  input_.ownAxes = ownAxesNow();
  wetted_->look(input_.time, {input_.position, input_.attitude});
  wetted_->forget();
}

// v⁻ is the velocity as it is; a free ship's course begins at it.
void Ship::startAgain() noexcept {
  lookAgain();
  turnAddedMass(ownAxesNow());
  added().forgetPast();
  velocityAfter_ = velocityInEarth(body_->getLinearVelocity(), body_->getAngularVelocity());
  velocityBefore_ = velocityAfter_;
  lastStep_ = stepBefore_ = 0.0;
  input_.courseBegins = true;
  courseBeginsHere();
}

void Ship::beginFixed(double x, double y, double heading, double speed) noexcept {
  course_.set({x, y, heading}, {speed, 0.0, 0.0});
  line_ = course_;
}

void Ship::courseBeginsHere() noexcept {
  if (!free()) return;
  const Vec3 at = position();
  const double heading =
      course_.heading() + std::remainder(this->heading() - course_.heading(), 2.0 * kPi);
  const Vec3 along = rotationZ(-heading) * velocityBefore_.head<3>();
  course_.set({at.x(), at.y(), heading}, {along.x(), along.y(), velocityBefore_[Yaw]});
}

Mat3 Ship::toCourse() const noexcept { return rotationZ(-course_.heading()); }

CUTWATER_PLUGIN_END
