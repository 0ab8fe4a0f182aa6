#include "plugin/Seaway.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>
#include <string>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/FloatFleet.h"
#include "plugin/SeaChange.h"
#include "plugin/SeaView.h"
#include "plugin/SettingsCheck.h"
#include "plugin/ShipBody.h"
#include "plugin/ThreadPool.h"
#include "plugin/WorldHook.h"

CUTWATER_PLUGIN_BEGIN

namespace {

bool solverCarriesAddedMass(btDiscreteDynamicsWorld& world) {
  return world.getConstraintSolver()->getSolverType() != BT_MLCP_SOLVER;
}

btDiscreteDynamicsWorld& checked(btDiscreteDynamicsWorld& world) {
  if (solverCarriesAddedMass(world)) return world;
  throw HydroError(
      Fault::SolverNotSupported,
      "Seaway: btMLCPSolver ignores the softness of a constraint and takes one body for "
      "two; added mass would be wrong. Use btSequentialImpulseConstraintSolver");
}

std::string text(const btVector3& v) {
  std::ostringstream line;
  line << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
  return line.str();
}

void checkGravity(const btVector3& gravity, const WorldFrame& frame, double right) {
  const Vec3 g = frame.lengthToEarth(gravity);
  const double sideways = std::hypot(g.x(), g.y()), down = -g.z();
  const auto refuse = [&](const std::string& what) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Seaway::addShip: the world's gravity " + what + ", it is " + text(gravity));
  };
  if (!(down >= 0.0 && sideways <= 1e-6 * down)) {
    refuse(std::string("must point down (along -") +
           (frame.up == WorldFrame::Up::Z ? "z; in a world with y up give WorldFrame::Up::Y"
                                          : "y, as WorldFrame says") +
           ") or be zero");
  }
  if (down == 0.0 || gravityFits(gravity, frame, right)) return;
  std::ostringstream line;
  line << "must be that of the database, " << right << " m/s2, here " << right / frame.metresPerUnit
       << " units/s2 (WorldFrame::metresPerUnit = " << frame.metresPerUnit << ')';
  refuse(line.str());
}

std::string kindOf(const btTypedConstraint& joint) {
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE:
      return "btPoint2PointConstraint";
    case HINGE_CONSTRAINT_TYPE:
      return "btHingeConstraint";
    case CONETWIST_CONSTRAINT_TYPE:
      return "btConeTwistConstraint";
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return "btGeneric6DofConstraint";
    case D6_SPRING_2_CONSTRAINT_TYPE:
      return "btGeneric6DofSpring2Constraint";
    case SLIDER_CONSTRAINT_TYPE:
      return "btSliderConstraint";
    case GEAR_CONSTRAINT_TYPE:
      return "btGearConstraint";
    case FIXED_CONSTRAINT_TYPE:
      return "btFixedConstraint";
    default:
      return "constraint of type " + std::to_string(joint.getConstraintType());
  }
}

WorldFrame checked(const WorldFrame& frame) {
  frame.check();
  return frame;
}

}  // namespace

class Seaway::Listener final : public TickListener {
 public:
  explicit Listener(Seaway& seaway) : seaway_(seaway) {}
  void beforeTick(btScalar step) noexcept override { seaway_.beforeTick(step); }
  void afterTick(btScalar step) noexcept override { seaway_.afterTick(step); }
  void slotTaken() noexcept override { seaway_.raise(kCallbackReplaced); }
  void draw(btIDebugDraw& drawer) noexcept override { seaway_.debugDraw(drawer); }

 private:
  Seaway& seaway_;
};

Seaway::Seaway(btDiscreteDynamicsWorld& world, SeaState sea, const WorldFrame& frame)
    : world_(checked(world)),
      sea_(std::make_shared<const SeaState>(std::move(sea))),
      frame_(checked(frame)),
      seaKey_(sea_->key()),
      firstLevel_(frame.seaLevel),
      floats_(std::make_unique<FloatFleet>(world_, frame_, sea_)),
      watch_(std::make_shared<SeaWatch>(sea_, frame_)),
      listener_(std::make_unique<Listener>(*this)),
      hook_(std::make_unique<WorldHook>(world, *listener_)) {}

bool Seaway::worldLives() const noexcept {
  return std::any_of(ships_.begin(), ships_.end(),
                     [](const auto& ship) { return ship->inWorld(); });
}

Seaway::~Seaway() {
  if (!worldLives()) return;
  hook_->worldLives();
  for (const auto& ship : ships_) ship->worldLives();
  floats_->worldLives();
}

void Seaway::setThreads(unsigned threads) {
  if (threads < 1 || threads > 1024) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Seaway::setThreads: " + std::to_string(threads) + " threads");
  }
  pool_ = threads > 1 ? std::make_unique<ThreadPool>(threads) : nullptr;
}

Ship& Seaway::add(std::shared_ptr<const Hydrodynamics> hydrodynamics, const ShipSettings& settings,
                  btRigidBody* own) {
  if (!hydrodynamics) {
    throw HydroError(Fault::BadArgument, "Seaway::addShip: no hydrodynamics (null pointer)");
  }
  checkSettings(settings, "Seaway::addShip");
  for (const auto& ship : ships_) {
    if (own != &ship->body()) continue;
    throw HydroError(Fault::BadArgument, "Seaway::addShip: the body is a ship of this sea already");
  }
  if (own != nullptr && floatOf(*own) != nullptr)
    throw HydroError(Fault::BadArgument, "Seaway::addShip: the body is a float of this sea");
  checkGravity(world_.getGravity(), frame_, hydrodynamics->ship().gravity);
  settleSea();
  checkSea(*sea_, hydrodynamics->ship().gravity, "Seaway::addShip");
  ships_.reserve(ships_.size() + 1);
  shipFaults_.resize(ships_.size() + 1);
  auto ship = std::make_unique<Ship>(
      world_, frame_, tablesOf(tables_, std::move(hydrodynamics), sea_), settings, own);
  ship->setWater(frame_.seaLevel, calm_.now);
  if (preparedFor_ > 0.0) ship->prepare(preparedFor_);
  if (coming_) {
    const auto next =
        tablesOf(coming_->tablesInNext, ship->tables().hydrodynamics(), coming_->next);
    coming_->shipsInNext.emplace_back(next, ship->seaOrder());
  }
  return *ships_.emplace_back(std::move(ship));
}

void Seaway::prepare(double step) {
  for (const auto& ship : ships_) ship->prepare(step);
  preparedFor_ = step;
}

Ship* Seaway::shipOf(const btCollisionObject& body) const noexcept {
  for (const auto& ship : ships_) {
    if (&ship->body() == &body) return ship.get();
  }
  return nullptr;
}

Ship& Seaway::addShip(std::shared_ptr<const Hydrodynamics> hydrodynamics,
                      const ShipSettings& settings) {
  return add(std::move(hydrodynamics), settings, nullptr);
}

Ship& Seaway::addShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, btRigidBody& body,
                      const ShipSettings& settings) {
  return add(std::move(hydrodynamics), settings, &body);
}

Ship& Seaway::addShip(Coefficients coefficients, const ShipSettings& settings) {
  return add(std::make_shared<const Hydrodynamics>(std::move(coefficients)), settings, nullptr);
}

Ship& Seaway::addShip(Coefficients coefficients, btRigidBody& body, const ShipSettings& settings) {
  return add(std::make_shared<const Hydrodynamics>(std::move(coefficients)), settings, &body);
}

// The tables of a sea go with their last ship; Hydrodynamics live as long as somebody holds them.
void Seaway::removeShip(Ship& ship) {
  const auto refuse = [](const std::string& what) {
    throw HydroError(Fault::BadArgument, "Seaway::removeShip: " + what);
  };
  const auto isIt = [&](const auto& owned) { return owned.get() == &ship; };
  if (std::none_of(ships_.begin(), ships_.end(), isIt)) refuse("it is no ship of this sea");
  const bool lives = worldLives();
  const btTypedConstraint* joint = lives ? ship.foreignConstraint() : nullptr;
  if (joint != nullptr) {
    refuse("a joint of yours (" + kindOf(*joint) +
           ") still holds the body that is about to go; removeConstraint() it first");
  }
  if (lives) ship.worldLives();
  settleSea();
  const auto place = std::find_if(ships_.begin(), ships_.end(), isIt);
  if (coming_) coming_->shipsInNext.erase(coming_->shipsInNext.begin() + (place - ships_.begin()));
  ships_.erase(place);
  std::erase_if(tables_, [](const auto& tables) { return tables.use_count() == 1; });
}

Float& Seaway::addFloat(btRigidBody& body, const FloatSettings& settings) {
  if (shipOf(body) != nullptr)
    throw HydroError(Fault::BadArgument, "Seaway::addFloat: the body is a ship of this sea");
  settleSea();
  return floats_->add(body, settings);
}

void Seaway::removeFloat(Float& floating) { floats_->remove(floating); }

Float* Seaway::floatOf(const btCollisionObject& body) const noexcept { return floats_->of(body); }

const std::vector<std::unique_ptr<Float>>& Seaway::floats() const noexcept {
  return floats_->floats();
}

btVector3 Seaway::waterAt(const btVector3& place) const noexcept {
  Vec3 at = frame_.placeToEarth(place);
  at.z() = waveHeight(at.x(), at.y());
  return frame_.place(at);
}

Seaway::Snapshot Seaway::save() const {
  Snapshot snapshot;
  save(snapshot);
  return snapshot;
}

void Seaway::save(Snapshot& snapshot) const {
  snapshot.time = time_;
  snapshot.seaKey = seaKey_;
  saveCalmLevel(snapshot);
  snapshot.ships.resize(ships_.size());
  for (std::size_t i = 0; i < ships_.size(); ++i) ships_[i]->save(snapshot.ships[i]);
  snapshot.floats.resize(floats().size());
  for (std::size_t i = 0; i < floats().size(); ++i) floats()[i]->save(snapshot.floats[i]);
}

void Seaway::restore(const Snapshot& snapshot) {
  if (snapshot.ships.size() != ships_.size()) {
    throw HydroError(Fault::BadArgument, "Seaway::restore: snapshot has " +
                                             std::to_string(snapshot.ships.size()) +
                                             " ships, here are " + std::to_string(ships_.size()));
  }
  if (snapshot.seaKey != seaKey_) {
    throw HydroError(Fault::BadArgument,
                     "Seaway::restore: the snapshot was taken in another sea than this one");
  }
  if (snapshot.floats.size() != floats().size()) {
    throw HydroError(Fault::BadArgument,
                     "Seaway::restore: snapshot has " + std::to_string(snapshot.floats.size()) +
                         " floats, here are " + std::to_string(floats().size()));
  }
  restoreCalmLevel(snapshot);
  for (std::size_t i = 0; i < ships_.size(); ++i) ships_[i]->restore(snapshot.ships[i]);
  for (std::size_t i = 0; i < floats().size(); ++i) floats()[i]->restore(snapshot.floats[i]);
  time_ = snapshot.time;
  watch_->set(nullptr, time_);
}

void Seaway::forgetContacts() {
  btOverlappingPairCache* pairs = world_.getBroadphase()->getOverlappingPairCache();
  for (int i = 0; i < world_.getNumCollisionObjects(); ++i) {
    btBroadphaseProxy* proxy = world_.getCollisionObjectArray()[i]->getBroadphaseHandle();
    if (proxy != nullptr) pairs->cleanProxyFromPairs(proxy, world_.getDispatcher());
  }
  world_.getConstraintSolver()->reset();
}

void Seaway::addObserver(TickObserver& observer) { observers_.push_back(&observer); }

void Seaway::removeObserver(TickObserver& observer) noexcept { std::erase(observers_, &observer); }

// A bit counts once a tick, however many ships raise it.
void Seaway::raise(std::uint32_t faults) noexcept {
  for (std::uint32_t left = faults & ~tickFaults_; left != 0; left &= left - 1) {
    FaultCount& count = faultCounts_[static_cast<std::size_t>(std::countr_zero(left))];
    if (count.ticks++ == 0) count.first = time_;
  }
  tickFaults_ |= faults;
  faults_ |= faults;
}

FaultCount Seaway::faultCount(StepFault bit) const noexcept {
  if (!std::has_single_bit(static_cast<std::uint32_t>(bit))) return {};
  return faultCounts_[static_cast<std::size_t>(std::countr_zero(static_cast<std::uint32_t>(bit)))];
}

void Seaway::clearFaults() noexcept {
  faults_ = tickFaults_ = kStepOk;
  faultCounts_.fill({});
}

void Seaway::beforeTick(btScalar step) noexcept {
  if (!solverCarriesAddedMass(world_)) raise(kSolverNotSupported);
  followSea();
  step_ = step;
  beginCalmLevel(static_cast<double>(step));
  for (const auto& ship : ships_) raise(ship->keepConstraints());
  const auto one = [](void* self, std::size_t i) {
    auto& s = *static_cast<Seaway*>(self);
    s.shipFaults_[i] = s.ships_[i]->beginTick(s.time_, s.step_);
  };
  if (pool_) {
    pool_->run(ships_.size(), one, this);
  } else {
    for (std::size_t i = 0; i < ships_.size(); ++i) one(this, i);
  }
  for (std::size_t i = 0; i < ships_.size(); ++i) raise(shipFaults_[i]);
  raise(floats_->beginTick(time_, step));
}

void Seaway::afterTick(btScalar step) noexcept {
  for (const auto& ship : ships_) raise(ship->endTick(step));
  raise(floats_->endTick());
  endCalmLevel(static_cast<double>(step));
  for (TickObserver* observer : observers_) observer->tickDone(*this);
  if (std::isfinite(step)) time_ += static_cast<double>(step);
  watch_->set(nullptr, time_);
  tickFaults_ = kStepOk;
}

CUTWATER_PLUGIN_END
