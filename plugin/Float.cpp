#include "plugin/Float.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "hydro/Errors.h"
#include "hydro/forces/floats/FloatBody.h"
#include "plugin/FloatRig.h"
#include "plugin/FloatShape.h"
#include "plugin/ShipBody.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr double kStillSpeed = 2e-4;    // [m/s]: a wet body that moves does not sleep
constexpr double kStillSpin = 1e-3;     // [rad/s]
constexpr double kMovedAway = 2.0;      // of its reach, further than which a body was set
constexpr double kLockedInertia = 1e9;  // of mV^{2/3}: an inertia that Bullet takes as infinite

bool allFinite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool placeFinite(const btTransform& pose) {
  bool good = allFinite(pose.getOrigin());
  for (int i = 0; i < 3; ++i) good = good && allFinite(pose.getBasis()[i]);
  return good;
}

/// The list of a world, which knows its constraints by address.
struct ConstraintList : btDiscreteDynamicsWorld {
  static btAlignedObjectArray<btTypedConstraint*>& of(btDiscreteDynamicsWorld& world) {
    return world.*(&ConstraintList::m_constraints);
  }
};

bool stands(btDiscreteDynamicsWorld& world, const btTypedConstraint* wanted, int& place) {
  const auto& list = ConstraintList::of(world);
  if (place < list.size() && list[place] == wanted) return true;
  for (place = 0; place < list.size(); ++place) {
    if (list[place] == wanted) return true;
  }
  return false;
}

[[noreturn]] void refuseSetting(const std::string& field, double value, const std::string& bounds) {
  throw HydroError(Fault::ValueOutOfRange,
                   field + " = " + std::to_string(value) + ": give " + bounds);
}

void checkFloatSettings(const FloatSettings& settings) {
  const auto within = [](const char* field, double value, double least, double most) {
    if (value >= least && value <= most) return;
    refuseSetting(field, value, std::to_string(least) + " to " + std::to_string(most));
  };
  within("waterDensity", settings.waterDensity, 1.0, 20000.0);
  within("normalDrag", settings.normalDrag, 0.0, 10.0);
  within("friction", settings.friction, 0.0, 1.0);
  within("slowDrag", settings.slowDrag, 0.0, 1.0);
}

// In SI, about the centre of mass, in axes that are to E as the body's are to the world.
SurfaceMesh meshOfBody(const WorldFrame& frame, const btRigidBody& body,
                       const FloatSettings& settings) {
  if (!settings.mesh && body.getCollisionShape() == nullptr)
    throw HydroError(Fault::BadArgument, "the body has no collision shape; give it one, or a mesh");
  SurfaceMesh mesh = settings.mesh ? *settings.mesh : meshOf(*body.getCollisionShape());
  const Mat3 toEarth = frame.metresPerUnit * frame.axes().transpose();
  for (Vec3& p : mesh.vertices) p = toEarth * p;
  return mesh;
}

}  // namespace

void strike(btDiscreteDynamicsWorld& world, const btTypedConstraint& constraint) noexcept {
  ConstraintList::of(world).remove(const_cast<btTypedConstraint*>(&constraint));
}

Float::Float(btDiscreteDynamicsWorld& world, const WorldFrame& frame, btRigidBody& body,
             const FloatSettings& settings)
    : world_(world), frame_(frame), body_(&body), shape_(body.getCollisionShape()) {
  checkFloatSettings(settings);
  hull_ = std::make_shared<const FloatHull>(meshOfBody(frame, body, settings));
  water_ =
      std::make_unique<FloatBody>(hull_, FloatProperties{settings.waterDensity, settings.normalDrag,
                                                         settings.friction, settings.slowDrag});
  rig_ = std::make_unique<FloatRig>();
  inverseMass_ = body_->getInvMass();
  inverseInertia_ = body_->getInvInertiaDiagLocal();
  remember();
  keepConstraint();
}

// Constraints are taken out of the world by FloatFleet, which knows whether it lives.
Float::~Float() = default;

double Float::volume() const noexcept { return hull_->volume(); }
double Float::wetVolume() const noexcept { return water_->volume(); }
double Float::immersion() const noexcept { return water_->immersion(); }
double Float::wetArea() const noexcept { return water_->area(); }
Vec6 Float::pressure() const noexcept { return water_->pressure(); }
const Vec3& Float::semiAxes() const noexcept { return hull_->semiAxes(); }
const AddedMassConstraint* Float::addedMass() const noexcept { return rig_->added.get(); }

std::vector<std::pair<Vec3, Vec3>> Float::waterline() const {
  std::vector<std::pair<Vec3, Vec3>> pieces;
  for (const auto& [a, b] : water_->waterline())
    pieces.emplace_back(water_->inEarth(a), water_->inEarth(b));
  return pieces;
}

// A body that turns about no axis, as characters do, has an inertia that nothing moves.
Vec6 Float::massNow() const noexcept {
  Vec6 mass;
  const double own = 1.0 / static_cast<double>(inverseMass_);
  const double size = hull_->size() / frame_.metresPerUnit;
  mass.head<3>().setConstant(own);
  for (int i = 0; i < 3; ++i) {
    const auto inverse = static_cast<double>(inverseInertia_[i]);
    mass[3 + i] = inverse > 0.0 ? 1.0 / inverse : kLockedInertia * own * size * size;
  }
  return mass;
}

// By its address alone: it may be gone.
bool Float::findBody() noexcept {
  const btCollisionObjectArray& objects = world_.getCollisionObjectArray();
  if (place_ < objects.size() && objects[place_] == body_) return true;
  place_ = objects.findLinearSearch(body_);
  return place_ < objects.size();
}

// A tick proves that the world lives.
void Float::strikeOut() noexcept {
  if (!rig_->added) return;
  strike(world_, *rig_->added);
  rig_->added.end();
}

// Of a world of which nothing is known: what it may still list stays where it is, and does nothing.
btTypedConstraint* Float::retire() {
  AddedMassConstraint* ours = rig_->added.get();
  if (ours == nullptr) return nullptr;
  static_assert(sizeof(RetiredConstraint) <= sizeof(AddedMassConstraint));
  rig_->added.abandon();
  ours->~AddedMassConstraint();
  return ::new (static_cast<void*>(ours)) RetiredConstraint;
}

std::uint32_t Float::keepConstraint() {
  if (!(inverseMass_ > 0) || body_->isStaticOrKinematicObject()) return kStepOk;
  Lent<AddedMassConstraint>& added = rig_->added;
  if (!added) {
    added.make(*body_, Mat6::Zero(), massNow());
    dry_ = true;
    world_.addConstraint(added.get());
    return kStepOk;
  }
  if (stands(world_, added.get(), rig_->place)) return kStepOk;
  world_.addConstraint(added.get());
  return kConstraintRemoved;
}

void Float::heedMass() noexcept {
  const bool same = inverseMass_ == body_->getInvMass() &&
                    (inverseInertia_ - body_->getInvInertiaDiagLocal()).length2() == 0;
  if (same) return;
  inverseMass_ = body_->getInvMass();
  inverseInertia_ = body_->getInvInertiaDiagLocal();
  if (rig_->added && inverseMass_ > 0) rig_->added->setMass(massNow());
}

void Float::heedMoves() noexcept {
  const btVector3 moved = body_->getWorldTransform().getOrigin() - known_.pose.getOrigin();
  if (static_cast<double>(moved.length()) * frame_.metresPerUnit > kMovedAway * hull_->reach())
    water_->forget();
}

// Forces that are not finite are taken off, a state that is not finite is put back to the last one
// that was.
std::uint32_t Float::mendState() noexcept {
  std::uint32_t faults = kStepOk;
  if (!allFinite(body_->getTotalForce()) || !allFinite(body_->getTotalTorque())) {
    body_->clearForces();
    faults |= kLoadNotFinite;
  }
  if (placeFinite(body_->getWorldTransform()) && allFinite(body_->getLinearVelocity()) &&
      allFinite(body_->getAngularVelocity()))
    return faults;
  body_->setCenterOfMassTransform(known_.pose);
  body_->setInterpolationWorldTransform(known_.pose);
  body_->setLinearVelocity(known_.linear);
  body_->setAngularVelocity(known_.angular);
  body_->setInterpolationLinearVelocity(known_.linear);
  body_->setInterpolationAngularVelocity(known_.angular);
  if (rig_->added) rig_->added->forgetPast();
  water_->forget();
  return faults | kStateNotFinite;
}

void Float::remember() noexcept {
  known_ = {body_->getWorldTransform(), body_->getLinearVelocity(), body_->getAngularVelocity()};
}

std::uint32_t Float::look() noexcept {
  const Now before = now_;
  ticked_ = false;
  const bool found = findBody() && (listed_ || body_->getCollisionShape() == shape_);
  if (!found) {
    strikeOut();
    listed_ = false;
    now_ = Now::Away;
    return kStepOk;
  }
  listed_ = true;
  std::uint32_t faults = kStepOk;
  heedMass();
  try {
    faults |= keepConstraint();
  } catch (...) {  // no memory for a new one
    faults |= kConstraintRemoved;
  }
  const int activation = body_->getActivationState();
  const bool held = !rig_->added || !(inverseMass_ > 0) || body_->isStaticOrKinematicObject() ||
                    activation == DISABLE_SIMULATION;
  // Bullet would look up a simulation island for a constraint whose body has none.
  if (rig_->added) rig_->added->setEnabled(!held);
  if (held) {
    now_ = Now::Held;
    return faults;
  }
  if (before == Now::Away) remember();
  faults |= mendState();
  now_ = activation == ISLAND_SLEEPING ? Now::Asleep : Now::Ticks;
  if (now_ == Now::Ticks && before != Now::Ticks) water_->forget();
  if (before == Now::Away || before == Now::Held) rig_->added->forgetPast();
  heedMoves();
  return faults;
}

// A sleeping body wakes in waves that reach it. A contact may wake it within this tick.
bool Float::wakesIn(bool waves, btScalar step) noexcept {
  if (waves && water_->immersion() > 0.0) {
    body_->activate(true);
    water_->forget();
    rig_->added->forgetPast();
    now_ = Now::Ticks;
    return true;
  }
  rig_->added->forgetPast();
  rig_->added->beginTick(step);
  return false;
}

void Float::keepAwake(bool waves) noexcept {
  const double speed =
      static_cast<double>(body_->getLinearVelocity().length()) * frame_.metresPerUnit;
  const auto spin = static_cast<double>(body_->getAngularVelocity().length());
  if (waves || speed > kStillSpeed || spin > kStillSpin) body_->setDeactivationTime(0);
}

std::uint32_t Float::begin(bool waves, const Vec3& water, const Mat3& gradient,
                           const Vec3& convective, btScalar step) noexcept {
  AddedMassConstraint& added = *rig_->added;
  waterVelocity_ = water_->immersion() > 0.0 ? water : Vec3(Vec3::Zero());
  const FloatBody::Velocity velocity{frame_.lengthToEarth(added.linearVelocity()),
                                     frame_.directionToEarth(added.angularVelocity())};
  const double mass = frame_.kilogramsPerUnit / static_cast<double>(inverseMass_);
  FloatBody::Tick tick =
      water_->tick(velocity, mass, {water, gradient, convective}, static_cast<double>(step));
  std::uint32_t faults = kStepOk;
  if (!tick.impulse.allFinite() || !tick.inertia.allFinite()) {
    tick = {};
    water_->forget();
    faults |= kLoadNotFinite;
  }
  const bool dry = tick.inertia(0, 0) == 0.0;
  if (!dry) keepAwake(waves);
  const Mat3 axes = fromBullet(body_->getWorldTransform().getBasis());
  // The rows resist changes of the velocity in the world; turning is in the impulse.
  added.follow({axes, axes}, frame_.axes(), 0.0);
  added.setPast(added.linearVelocity(), added.angularVelocity(), {axes, axes});
  if (!dry || !dry_) added.setAddedMass(frame_.mass(tick.inertia));
  dry_ = dry;
  body_->applyCentralImpulse(frame_.force(tick.impulse.head<3>()));
  body_->applyTorqueImpulse(frame_.moment(tick.impulse.tail<3>()));
  added.beginTick(step);
  ticked_ = true;
  return faults;
}

std::uint32_t Float::end() noexcept {
  if (!ticked_ || !rig_->added) return kStepOk;
  rig_->added->endTick();
  const std::uint32_t faults = mendState();
  remember();
  return faults;
}

void Float::velocityWasSet() noexcept {
  water_->forget();
  if (!listed_) return;
  remember();
  if (rig_->added) rig_->added->forgetPast();
}

void Float::save(Snapshot& s) const noexcept {
  s.inWorld = listed_;
  if (!listed_) return;
  s.transform = body_->getWorldTransform();
  s.interpolated = body_->getInterpolationWorldTransform();
  s.velocities = velocitiesOf(*body_);
  s.past = {btVector3(0, 0, 0), btVector3(0, 0, 0)};
  if (rig_->added) {
    s.past = {rig_->added->linearVelocity(), rig_->added->angularVelocity()};
  }
  s.known = known_.pose.getBasis();
  s.knownAt = known_.pose.getOrigin();
  s.activation = body_->getActivationState();
  s.stillFor = static_cast<double>(body_->getDeactivationTime());
  const FloatBody::Past past = water_->past();
  s.share = past.moving.share;
  s.addedMass = {past.moving.linear, past.moving.angular};
  s.momentum = {past.moving.arm, past.moving.waterLinear, past.moving.waterAngular};
  s.begun = past.begun;
  s.now = static_cast<int>(now_);
}

// A body that was in no world then, or is in none now, stays as it is.
void Float::restore(const Snapshot& s) noexcept {
  if (!s.inWorld || !listed_) return;
  putBack(*body_, s.transform, s.interpolated, s.velocities, s.activation);
  body_->setDeactivationTime(static_cast<btScalar>(s.stillFor));
  if (rig_->added) rig_->added->setPast(s.past[0], s.past[1], {});
  water_->setPast(
      {{s.addedMass[0], s.addedMass[1], s.momentum[0], s.momentum[1], s.momentum[2], s.share},
       s.begun});
  now_ = static_cast<Now>(s.now);
  remember();
  known_.pose = btTransform(s.known, s.knownAt);
  if (btMotionState* drawn = body_->getMotionState()) drawn->setWorldTransform(s.interpolated);
}

CUTWATER_PLUGIN_END
