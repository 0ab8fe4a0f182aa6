#pragma once
#include <optional>

#include "demos/cutwater/input/RunFile.h"
#include "demos/scenes/BulletWorld.h"
#include "plugin/Seaway.h"

namespace cutwater::command {

/// A run's ship in a Bullet world of its own. Not movable: the world holds addresses.
class RunShip {
 public:
  /// @param index  which of the run's wave frequencies.
  /// @throws HydroError.
  RunShip(const RunFile& run, const Coefficients& coefficients, std::size_t index = 0)
      : bullet_(coefficients.ship.gravity),
        seaway_(bullet_.world, run.seaState(coefficients.ship.gravity, index)),
        ship_(seaway_.addShip(coefficients, settings(run))),
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
  static ShipSettings settings(const RunFile& run) {
    ShipSettings s;
    s.offset = run.startOffset;
    s.velocity = run.startVelocity;
    s.restrained = run.restrained;
    s.speed = run.speed;
    s.mean = run.filtered ? Mean::Filtered : Mean::Fixed;
    s.followTime = run.followTime;
    s.memory = run.convolution ? MemoryModel::Convolution : MemoryModel::Exponential;
    if (run.keepSpeed) s.keepSpeed = SpeedKeeper{.speed = run.speed};
    if (run.keepCourse) s.keepCourse = CourseKeeper{.heading = run.startOffset[Yaw]};
    return s;
  }

  BulletWorld bullet_;
  Seaway seaway_;
  Ship& ship_;
  btScalar tick_;
  int substeps_;
};

/// One line for the faults of a run, empty if there were none.
std::string describeFaults(std::uint32_t faults);

}  // namespace cutwater::command
