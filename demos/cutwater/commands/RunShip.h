#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>

#include "demos/cutwater/commands/RunFaults.h"
#include "demos/cutwater/input/RunFile.h"
#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

namespace cutwater::command {

/// Counts the ticks until a fault that is no warning, and looks how far ships leave their course.
class GoodTicks final : private TickObserver {
 public:
  explicit GoodTicks(Seaway& seaway) : seaway_(seaway) { seaway_.addObserver(*this); }
  ~GoodTicks() override { seaway_.removeObserver(*this); }
  GoodTicks(const GoodTicks&) = delete;
  GoodTicks& operator=(const GoodTicks&) = delete;

  bool broken() const noexcept { return (seaway_.faults() & ~kWarningBits) != 0; }
  std::size_t count() const noexcept { return count_; }
  double farthest() const noexcept { return farthest_; }  ///< [m]

 private:
  void tickDone(const Seaway& seaway) noexcept override {
    if (broken()) return;
    ++count_;
    for (const auto& ship : seaway.ships()) farthest_ = std::max(farthest_, ship->offCourse());
  }

  Seaway& seaway_;
  std::size_t count_ = 0;
  double farthest_ = 0.0;
};

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
        substeps_(run.substeps) {
    for (const RunCompartment& room : run.compartments) {
      Compartment& made = ship_.addCompartment(room.box);
      made.setRate(room.rate);
      for (const Opening& opening : room.openings) made.openTo(opening);
    }
  }

  /// One stepSimulation of `substeps` ticks. Bullet counts ticks by dividing times and may round
  /// one away; it keeps the rest, so one tick more is allowed for the call after.
  void step() {
    bullet_.world.stepSimulation(tick_ * static_cast<btScalar>(substeps_), substeps_ + 1, tick_);
  }
  /// A tick broke something: to step on makes no sense. Those before it were good.
  bool broken() const noexcept { return good_.broken(); }
  std::size_t goodTicks() const noexcept { return good_.count(); }
  RunFaults faults() {
    RunFaults run = faultsOf(seaway_, ship_);
    run.farthest = good_.farthest();
    return run;
  }
  Seaway& seaway() { return seaway_; }
  Ship& ship() { return ship_; }

 private:
  BulletWorld bullet_;
  Seaway seaway_;
  GoodTicks good_{seaway_};
  Ship& ship_;
  btScalar tick_;
  int substeps_;
};

/// The run's ship, to be shared by the worlds of the run; may cut the run's spectrum.
/// @throws HydroError as readShipOfRun; naming the database, if it is unfinished.
std::shared_ptr<const Hydrodynamics> hydrodynamicsOf(RunFile& run);

}  // namespace cutwater::command
