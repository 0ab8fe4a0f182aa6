#pragma once
#include <memory>
#include <vector>

#include "hydro/Errors.h"
#include "plugin/Ship.h"
#include "plugin/WorldHook.h"

CUTWATER_PLUGIN_BEGIN

class Seaway;

/// Sees every internal tick of a Seaway, when it is over.
class TickObserver {
 public:
  virtual ~TickObserver() = default;
  virtual void tickDone(const Seaway& seaway) noexcept = 0;
};

/// Waves and ships in a stock Bullet world: discrete, multi-body, soft-rigid or Mt.
///
///     btDiscreteDynamicsWorld world(...);
///     world.setGravity({0, 0, -9.81});   // z up, metres, calm water at z = 0
///     const auto frigate = cutwater::readCoefficients("frigate.h5");
///     cutwater::Seaway seaway(world, cutwater::SeaState(components, 9.81));
///     auto& ship = seaway.addShip(frigate, {.x = 0, .y = 0, .heading = 0.5});
///     while (running) world.stepSimulation(frame, 4, 1.0 / 60);   // ship.body() moves
///
/// All loads come from one evaluation per internal tick, so results do not depend on how ticks are
/// grouped into stepSimulation calls. The tick should be fixed: another length restarts the memory
/// of radiated waves. Gravity, contacts, joints, forces, callbacks of the user work as without us;
/// set velocities by Ship::resetVelocity. One thread at a time, as the world itself. Contacts and
/// joints need btContactSolverInfo::m_numIterations of AddedMassConstraint::iterationsFor.
class Seaway final : private TickListener {
 public:
  /// @param world must outlive the Seaway.  @param sea is copied.
  /// @throws HydroError SolverNotSupported: btMLCPSolver treats a constraint whose two bodies are one as
  ///         two bodies and ignores its softness, so that M + A∞ would be wrong in contacts;
  ///         BadArgument: the world has a Seaway.
  explicit Seaway(btDiscreteDynamicsWorld& world, SeaState sea = {});
  /// Takes its ships out and leaves the world's callback as it was found.
  ~Seaway() override;

  /// A new ship at its mean course. @param coefficients must outlive the ship; another mass
  /// distribution on the same waterline is withLoading(coefficients, …) of database/Loading.h.
  /// @throws HydroError ValueOutOfRange: gravity not along −z or zero, mass or gyradii not
  /// positive, a
  ///         wave outside the database; DatabaseIncomplete: no hull in it and no shape given.
  Ship& addShip(const Coefficients& coefficients, const ShipSettings& settings = {});
  /// The user's own body, already in the world, origin in G, axes B; the database's mass within 0.1
  /// %. Its pose becomes the mean course (x, y, heading); of `settings` only `restrained` is used.
  Ship& addShip(const Coefficients& coefficients, btRigidBody& body,
                const ShipSettings& settings = {});
  Ship& addShip(Coefficients&&, const ShipSettings& = {}) = delete;  // would dangle
  Ship& addShip(Coefficients&&, btRigidBody&, const ShipSettings& = {}) = delete;
  /// Ends the hydrodynamics of a ship; a body we made leaves the world.
  void removeShip(Ship& ship);
  const std::vector<std::unique_ptr<Ship>>& ships() const noexcept { return ships_; }

  /// Sum of all ticks [s] since the Seaway joined the world.
  double time() const noexcept { return time_; }
  const SeaState& sea() const noexcept { return sea_; }
  /// ζ [m] at x, y in E, now.
  double waveHeight(double x, double y) const noexcept { return sea_.elevation(time_, x, y); }

  /// StepFault bits of all ticks since clearFaults(), of all ships.
  std::uint32_t faults() const noexcept { return faults_; }
  void clearFaults() noexcept { faults_ = kStepOk; }

  /// Exact state of time and ships, in their order. @throws HydroError BadArgument: other ships.
  struct Snapshot {
    double time = 0.0;
    std::vector<Ship::Snapshot> ships;
  };
  Snapshot save() const;
  void restore(const Snapshot& snapshot);

  /// Observers must outlive the Seaway or be removed.
  void addObserver(TickObserver& observer);
  void removeObserver(TickObserver& observer) noexcept;

 private:
  Ship& add(const Coefficients& coefficients, const ShipSettings& settings, btRigidBody* own);
  void beforeTick(btScalar step) noexcept override;
  void afterTick(btScalar step) noexcept override;
  void slotTaken() noexcept override;

  btDiscreteDynamicsWorld& world_;
  SeaState sea_;
  double time_ = 0.0;
  std::uint32_t faults_ = kStepOk;
  std::vector<std::unique_ptr<Ship>> ships_;
  std::vector<TickObserver*> observers_;
  WorldHook hook_;  // last: no tick reaches us before all else is there
};

CUTWATER_PLUGIN_END
