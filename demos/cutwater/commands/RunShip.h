#pragma once
#include <optional>

#include "demos/cutwater/input/RunFile.h"
#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

namespace cutwater::command {

/// A run's ship in a Bullet world of its own. Not movable: the world holds addresses.
class RunShip {
 public:
  /// @param index  which of the run's wave frequencies.
  /// @throws HydroError.
  RunShip(const RunFile& run, std::shared_ptr<const Hydrodynamics> hydrodynamics,
          std::size_t index = 0)
      : bullet_(hydrodynamics->ship().gravity),
        seaway_(bullet_.world, run.seaState(hydrodynamics->ship().gravity, index)),
        ship_(seaway_.addShip(std::move(hydrodynamics), {run.start, run.model, {}})),
        tick_(static_cast<btScalar>(run.tick)),
        substeps_(run.substeps) {}

  /// One stepSimulation of `substeps` ticks. Bullet counts ticks by dividing times and may round
  /// one away; it keeps the rest, so one tick more is allowed for the call after.
  void step() {
    bullet_.world.stepSimulation(tick_ * static_cast<btScalar>(substeps_), substeps_ + 1, tick_);
  }
  Seaway& seaway() { return seaway_; }
  Ship& ship() { return ship_; }

 private:
  BulletWorld bullet_;
  Seaway seaway_;
  Ship& ship_;
  btScalar tick_;
  int substeps_;
};

/// The run's ship, to be shared by the worlds of the run; may cut the run's spectrum.
/// @throws HydroError as readShipOfRun; naming the database, if it is unfinished.
std::shared_ptr<const Hydrodynamics> hydrodynamicsOf(RunFile& run);

/// One line for the faults of a run, naming the part of the load that broke; empty if there were
/// none.
std::string describeFaults(RunShip& run);

}  // namespace cutwater::command
