#include "plugin/Seaway.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/SettingsCheck.h"
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

void checkGravity(const btVector3& gravity, const WorldFrame& frame) {
  const Vec3 g = frame.lengthToEarth(gravity);
  const double sideways = std::hypot(g.x(), g.y()), down = -g.z();
  if (down >= 0.0 && sideways <= 1e-6 * down) return;
  throw HydroError(Fault::ValueOutOfRange,
                   std::string("Seaway::addShip: gravity must point down (along -") +
                       (frame.up == WorldFrame::Up::Z ? "z" : "y, as WorldFrame says") +
                       ") or be zero, it is (" + std::to_string(gravity.x()) + ", " +
                       std::to_string(gravity.y()) + ", " + std::to_string(gravity.z()) + ")");
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
  void slotTaken() noexcept override { seaway_.faults_ |= kCallbackReplaced; }
  void draw(btIDebugDraw& drawer) noexcept override { seaway_.debugDraw(drawer); }

 private:
  Seaway& seaway_;
};

Seaway::Seaway(btDiscreteDynamicsWorld& world, SeaState sea, const WorldFrame& frame)
    : world_(checked(world)),
      sea_(std::make_shared<const SeaState>(std::move(sea))),
      frame_(checked(frame)),
      listener_(std::make_unique<Listener>(*this)),
      hook_(std::make_unique<WorldHook>(world, *listener_)) {}

Seaway::~Seaway() = default;

void Seaway::setThreads(unsigned threads) {
  if (threads < 1 || threads > 1024) {
    throw HydroError(Fault::ValueOutOfRange,
                     "Seaway::setThreads: " + std::to_string(threads) + " threads");
  }
  pool_ = threads > 1 ? std::make_unique<ThreadPool>(threads) : nullptr;
}

std::shared_ptr<const SeaTables> Seaway::tablesOf(
    std::shared_ptr<const Hydrodynamics> hydrodynamics) {
  for (const auto& tables : tables_) {
    if (tables->hydrodynamics() == hydrodynamics) return tables;
  }
  return tables_.emplace_back(std::make_shared<const SeaTables>(std::move(hydrodynamics), sea_));
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
  checkGravity(world_.getGravity(), frame_);
  ships_.reserve(ships_.size() + 1);
  shipFaults_.resize(ships_.size() + 1);
  return *ships_.emplace_back(
      std::make_unique<Ship>(world_, frame_, tablesOf(std::move(hydrodynamics)), settings, own));
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
  std::erase_if(ships_, [&](const auto& owned) { return owned.get() == &ship; });
  std::erase_if(tables_, [](const auto& tables) { return tables.use_count() == 1; });
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
  snapshot.ships.resize(ships_.size());
  for (std::size_t i = 0; i < ships_.size(); ++i) ships_[i]->save(snapshot.ships[i]);
}

void Seaway::restore(const Snapshot& snapshot) {
  if (snapshot.ships.size() != ships_.size()) {
    throw HydroError(Fault::BadArgument, "Seaway::restore: snapshot has " +
                                             std::to_string(snapshot.ships.size()) +
                                             " ships, here are " + std::to_string(ships_.size()));
  }
  for (std::size_t i = 0; i < ships_.size(); ++i) ships_[i]->restore(snapshot.ships[i]);
  time_ = snapshot.time;
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

void Seaway::beforeTick(btScalar step) noexcept {
  if (!solverCarriesAddedMass(world_)) faults_ |= kSolverNotSupported;
  step_ = step;
  const auto one = [](void* self, std::size_t i) {
    auto& s = *static_cast<Seaway*>(self);
    s.shipFaults_[i] = s.ships_[i]->beginTick(s.time_, s.step_);
  };
  if (pool_) {
    pool_->run(ships_.size(), one, this);
  } else {
    for (std::size_t i = 0; i < ships_.size(); ++i) one(this, i);
  }
  for (std::size_t i = 0; i < ships_.size(); ++i) faults_ |= shipFaults_[i];
}

void Seaway::afterTick(btScalar step) noexcept {
  for (const auto& ship : ships_) ship->endTick(step);
  for (TickObserver* observer : observers_) observer->tickDone(*this);
  time_ += static_cast<double>(step);
}

CUTWATER_PLUGIN_END
