#pragma once
#include <array>
#include <vector>

#include "hydro/ship/StillWater.h"

namespace cutwater {

/// Does the ship trim as it heels?
enum class RightingTrim {
  Free,  ///< until nothing tilts it about the level y
  Fixed  ///< never: the waterline of its hull file stays parallel to calm water along the ship
};
inline constexpr std::array<const char*, 2> kRightingTrimNames{"free", "fixed"};

/// The ship afloat at a heel that somebody holds.
struct RightingLever {
  double heel = 0.0;       ///< roll, starboard down [rad]
  double gz = 0.0;         ///< of the buoyancy about G, level and across [m]; above 0 turns to port
  double height = 0.0;     ///< of the hull file's origin above calm water [m]
  double trim = 0.0;       ///< pitch, bow down [rad]
  double volume = 0.0;     ///< displaced [m³]: mass / density
  double heightOfG = 0.0;  ///< above calm water [m]
  bool trimIsStable = true;  ///< pushed out of its trim, it comes back
};

/// Righting levers of a closed hull in calm water, at constant mass:
///     Righting righting(ship, RightingTrim::Free);
///     for (int i = 0; i <= 180; ++i) levers.push_back(righting.at(i * kPi / 180.0));
/// Heel turns the ship about its own x, trim about the level y (StillWater.h). ρ V = m, and with
/// free trim the centre of buoyancy lies level beside G, not before or behind it. Both are met to
/// round-off.
///
/// Height is unique. Trim need not be: the trim told is the one that the ship comes to when it is
/// heeled from upright in steps of a degree or less, whether it is stable or not. So a lever does
/// not depend on what else was asked. Where that trim ends it goes to the next one: trimJumps().
/// THEORY.md, chapter 2.
class Righting {
 public:
  /// @throws HydroError as StillWater; ValueOutOfRange if the mass exceeds what the closed hull
  ///         can displace, or no trim balances the ship.
  Righting(const ShipParticulars& ship, RightingTrim trim);

  /// @param heel  −π … π [rad].  @throws HydroError ValueOutOfRange if no trim balances the ship.
  RightingLever at(double heel);

  /// Heels on the way to those asked at which the trim went to another equilibrium.
  struct TrimJump {
    double heel, from, to;  ///< [rad]
  };
  const std::vector<TrimJump>& trimJumps() const noexcept { return jumps_; }

  /// ∛V [m]: levers are known to about 1e-13 of it.
  double scale() const noexcept { return scale_; }

 private:
  RightingLever advanced(const RightingLever& from, double heel, std::vector<TrimJump>& jumps);
  RightingLever balanced(double heel, const RightingLever& guess);
  bool newton(const RightingLever& guess);
  void balanceTrim(double start);
  double trimmingLever(double trim);
  bool pitchesBack();

  StillWater water_;
  RightingTrim mode_;
  double volume_, scale_;
  Vec3 fileOrigin_;                                  // from G, hull axes
  Attitude pose_;                                    // the last one found
  std::array<std::vector<RightingLever>, 2> steps_;  // every whole degree to starboard, to port
  std::vector<TrimJump> jumps_;
};

}  // namespace cutwater
