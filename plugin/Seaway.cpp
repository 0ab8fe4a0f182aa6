#include "plugin/Seaway.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"

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

void checkGravity(const btVector3& g) {
  const auto sideways = static_cast<double>(std::hypot(g.x(), g.y()));
  const auto down = static_cast<double>(-g.z());
  if (down >= 0.0 && sideways <= 1e-6 * down) return;
  throw HydroError(
      Fault::ValueOutOfRange,
      "Seaway::addShip: gravity must point along -z (z up, metres) or be zero, it is (" +
          std::to_string(g.x()) + ", " + std::to_string(g.y()) + ", " + std::to_string(g.z()) +
          ")");
}

}  // namespace

Seaway::Seaway(btDiscreteDynamicsWorld& world, SeaState sea)
    : world_(checked(world)), sea_(std::move(sea)), hook_(world, *this) {}

Seaway::~Seaway() = default;

Ship& Seaway::add(const Coefficients& coefficients, const ShipSettings& settings,
                  btRigidBody* own) {
  checkGravity(world_.getGravity());
  return *ships_.emplace_back(std::make_unique<Ship>(world_, coefficients, sea_, settings, own));
}

Ship& Seaway::addShip(const Coefficients& coefficients, const ShipSettings& settings) {
  return add(coefficients, settings, nullptr);
}

Ship& Seaway::addShip(const Coefficients& coefficients, btRigidBody& body,
                      const ShipSettings& settings) {
  return add(coefficients, settings, &body);
}

void Seaway::removeShip(Ship& ship) {
  std::erase_if(ships_, [&](const auto& owned) { return owned.get() == &ship; });
}

Seaway::Snapshot Seaway::save() const {
  Snapshot snapshot{time_, {}};
  for (const auto& ship : ships_) snapshot.ships.push_back(ship->save());
  return snapshot;
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

void Seaway::addObserver(TickObserver& observer) { observers_.push_back(&observer); }

void Seaway::removeObserver(TickObserver& observer) noexcept { std::erase(observers_, &observer); }

void Seaway::beforeTick(btScalar step) noexcept {
  if (!solverCarriesAddedMass(world_)) faults_ |= kSolverNotSupported;
  for (const auto& ship : ships_) faults_ |= ship->beginTick(time_, step);
}

void Seaway::afterTick(btScalar step) noexcept {
  for (const auto& ship : ships_) ship->endTick();
  for (TickObserver* observer : observers_) observer->tickDone(*this);
  time_ += static_cast<double>(step);
}

void Seaway::slotTaken() noexcept { faults_ |= kCallbackReplaced; }

CUTWATER_PLUGIN_END
