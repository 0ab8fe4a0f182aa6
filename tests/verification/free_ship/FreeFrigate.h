#pragma once
#include <Eigen/Dense>
#include <memory>
#include <string>
#include <vector>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

/// The coarse frigate (tests/demos/frigate_coarse.toml) set free in Bullet, double precision.
namespace cutwater::test {

inline constexpr double kGravity = 9.80665;            // [m/s²] of that database
inline constexpr double kDegree = kPi / 180.0;         // [rad]
inline constexpr double kKnot = 1852.0 / 3600.0;       // [m/s]
inline constexpr double kTick = 0.02;                  // [s]
inline constexpr const char* kTopic = "15 Free ship";  // of the results page

/// As the ctest fixture `frigate` solved it; read once. Its stiffness of yaw is for fixed courses:
/// a free ship leaves it out.
std::shared_ptr<const Hydrodynamics> coarseFrigate();

/// A free ship of linear theory, with which all tests here compare: waves and restoring force of
/// the hull at rest, the lift of the hull as asked, no resistance, which is of the second order.
ShipSettings freeShip(double speed = 0.0, bool hullLift = true);

/// One ship in a world of its own.
struct OneShip {
  OneShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, const SeaState& sea,
          const ShipSettings& settings, double gravity = kGravity);
  void tick(double step = kTick) { bullet.world.stepSimulation(step, 1, step); }
  double time() const { return seaway.time(); }

  BulletWorld bullet;
  Seaway seaway;
  Ship& ship;
};

/// ½νᵀ(M + A(0))ν [J] of a steady motion in own axes: what it took to get there slowly from rest,
/// and so the most that a ship and its water hold. Ship::energy() counts A(∞) of it alone; the rest
/// is in the waves' memory, which may give it back.
double steadyEnergy(const Hydrodynamics& hydrodynamics, const Vec6& velocity);
/// (u, v, 0, 0, 0, r) [m/s, rad/s].
Vec6 steadyWay(double ahead, double leeway = 0.0, double turn = 0.0);

/// Unknowns x of rows · x = values by least squares; unknowns that the rows do not tell apart are
/// taken as small as they can be.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& values);

/// Standard deviation, about 0.
double rootMeanSquare(const std::vector<double>& values);

/// What is above ω [rad/s] of samples `step` [s] apart; a window of Blackman of 400 s, so that what
/// is 0.05 rad/s off is let through or stopped to 1 %. 200 s at each end are lost.
std::vector<double> above(double omega, double step, const std::vector<double>& values);

}  // namespace cutwater::test
