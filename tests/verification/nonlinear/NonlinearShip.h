#pragma once
#include <memory>
#include <string>
#include <vector>

#include "demos/scenes/BulletWorld.h"
#include "plugin/Seaway.h"
#include "tests/support/BareHull.h"

/// Ships in nonlinear mode whose answers are known, in Bullet's double precision.
namespace cutwater::test {

inline constexpr const char* kTopic = "16 Nonlinear mode";  // of the results page

/// One ship in a world of its own.
struct OneShip {
  OneShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, const SeaState& sea,
          const ShipSettings& settings);
  void tick(double step) { bullet.world.stepSimulation(step, 1, step); }

  BulletWorld bullet;
  Seaway seaway;
  Ship& ship;
};

/// Weight and still or moving water's pressure on the hull, and nothing else.
ShipSettings pressureOnly(Mean mean = Mean::Fixed);

/// Times [s] at which samples `step` apart rise through 0, from the start of the samples.
std::vector<double> risesThroughZero(const std::vector<double>& samples, double step);
/// Mean time between the first and the last of them [s].
double meanPeriod(const std::vector<double>& samples, double step);

}  // namespace cutwater::test
