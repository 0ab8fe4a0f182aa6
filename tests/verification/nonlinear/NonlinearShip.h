#pragma once
#include <memory>
#include <string>
#include <vector>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

/// Ships in nonlinear mode whose answers are known, in Bullet's double precision.
namespace cutwater::test {

inline constexpr const char* kTopic = "16 Nonlinear mode";  // of the results page

/// A closed hull afloat at its mass, with G over the centre of buoyancy: x of `cog` is not read.
/// Its own mass is added `share` times in each mode, heave and pitch coupled, with a damping that
/// belongs to it. It throws no waves back; F_I is that of the faces below water, the linear one's
/// panels. For tests that look at the pressure alone.
struct BareHull {
  SurfaceMesh closed;
  Vec3 cog = Vec3::Zero();
  Vec3 gyradii = Vec3::Ones();
  double density = 1025.0, gravity = 9.81;
  Vec6 share = (Vec6() << 0.05, 0.5, 0.8, 0.2, 0.9, 0.6).finished();
};
Coefficients bareCoefficients(const BareHull& hull);
std::shared_ptr<const Hydrodynamics> bareShip(const BareHull& hull);

/// Vertices moved from and to the origin by a factor, so that the hull encloses `volume` [m³].
SurfaceMesh scaledToVolume(SurfaceMesh mesh, double volume);

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
