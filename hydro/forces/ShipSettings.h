#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/ship/ShipParticulars.h"

/// Where a ship starts and what acts on it: plain data, known to run files as to programs.
namespace cutwater {

/// What a ship's motions are linear about (frame H).
enum class Mean {
  Fixed,  ///< a straight line at constant speed, whatever the ship does: a towing tank, and [M03]
  Free    ///< the ship's own slow motion: to be driven, turned, pushed and towed
};

/// What carries a ship, and how its hull meets the waves that it does not change.
enum class HullPressure {
  Linear,  ///< restoring by C and Froude-Krylov force, both of the hull at rest, and small motions
  Nonlinear  ///< pressure on the hull as it lies in the waves, in any attitude (WettedPressure.h)
};
inline constexpr std::array kHullPressureNames{"linear", "nonlinear"};

/// Whether a hull that leaves the water takes its added mass and its waves with it.
enum class Immersion {
  Scaled,   ///< no: they go with the share of the hull that is in the water (PressureHull.h)
  Constant  ///< yes, as codes do that the theory is compared with
};
inline constexpr std::array kImmersionNames{"scaled", "constant"};

/// How the memory of radiated waves is computed.
enum class MemoryModel {
  Exponential,  ///< a sum of damped oscillations; the default
  Convolution   ///< the convolution itself, slower by a factor of ten or more: for comparison
};

/// Where a ship starts. SI units and E (z up) whatever the world's are.
struct ShipStart {
  double x = 0.0, y = 0.0;     ///< place of G in E [m]; of a fixed course the mean one
  double heading = 0.0;        ///< mean heading [rad], −2π..2π: of the bow from E's x, about +z
  double speed = 0.0;          ///< U [m/s] along the mean heading
  Vec6 offset = Vec6::Zero();  ///< from the mean course, in H [m]; roll, pitch, yaw [rad], −π..π
  Vec6 velocity = Vec6::Zero();  ///< beside U: u, v, w [m/s], p, q, r [rad/s] in B
};

/// Holds a speed by a thrust in G along the bow, or, of a ship that has an engine, by its throttle:
///     T = R + m'(2ν e + ν² ∫e dt),   e = speed wanted − speed now,   m' = m + A_11(∞)
/// held to the limit. R is the calm-water resistance of a free ship at the speed wanted
/// (Resistance.h). A free ship's speed is that of its slow motion, without the surge in waves. On a
/// fixed course surge at wave frequency ω ≫ ν is damped by 2ν/ω of the ship's inertia.
struct SpeedKeeper {
  double speed = 0.0;      ///< wanted [m/s]
  double maxThrust = 0.0;  ///< [N], ahead and astern; 0: 3 % of the ship's weight
  double rate = 0.02;      ///< ν [1/s]
};

/// Holds a heading by a moment about G, or, of a ship that has a rudder, by the rudder angle that
/// would make that moment, δ = N / (dN/dδ), with dN/dδ at least I'ν²:
///     N = k e − 2√(k I') r,   e = heading wanted − heading now,   I' = I_66 + A_66(∞),
///     k = I'ν² + U² a,   |N| ≤ limit,   a = A_22(∞), of a free ship 1.5 (A_22 − A_11)(0)
/// The last term of k acts against the Munk moment that turns a hull without rudder broadside on. A
/// free ship's heading is that of its slow motion: its yaw in waves is not answered.
struct CourseKeeper {
  double heading = 0.0;    ///< wanted [rad], −2π..2π: of the bow from E's x axis, about +z
  double maxMoment = 0.0;  ///< [N·m]; 0: 2 % of weight times length
  double rate = 0.1;       ///< ν [1/s]
};

/// Which theory acts on a ship, and what is added to it.
struct ShipModel {
  Mean mean = Mean::Free;
  /// Absent: nonlinear, of a free ship whose database holds a closed hull; else linear.
  std::optional<HullPressure> mode{};
  Immersion immersion = Immersion::Scaled;  ///< nonlinear mode only
  int hullTriangles = 2000;                 ///< nonlinear mode only: at most, 100 .. 1000000
  MemoryModel memory = MemoryModel::Exponential;
  bool hullLift = true;    ///< HullLift.h, Mean::Free only
  bool resistance = true;  ///< calm-water drag (Resistance.h), Mean::Free only
  /// In place of the database's, or where it has none; Mean::Free only. EngineParticulars{} and
  /// RudderParticulars{} suffice: the rest follows from the hull.
  std::optional<EngineParticulars> engine{};
  std::optional<RudderParticulars> rudder{};
  std::array<bool, 6> restrained{};  ///< modes held on the mean course, each by a row of the solver
  std::optional<SpeedKeeper> keepSpeed{};
  std::optional<CourseKeeper> keepCourse{};
  std::vector<std::string> without{};  ///< parts of the load that are switched off, by name
};

}  // namespace cutwater
