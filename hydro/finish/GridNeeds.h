#pragma once
#include <string>
#include <vector>

#include "hydro/finish/ConsistentLimit.h"

namespace cutwater {

/// Steps and range of a frequency grid, beside what the memory of the ship's waves needs.
///
/// Damping in surge, pitch and yaw rises and falls with the interference of bow and stern,
/// cos(2ω²L/g): steps of 0.7 √(g/L), 0.2 rad/s for the frigate of 124.5 m, leave two points to a
/// period at 1 rad/s. There A₁₁(∞) scatters by 3.8 %, with 0.1 rad/s by 0.4 %; K^UU₅₅ is 7 % off,
/// with 0.1 rad/s 0.2 %. The range is set by the beam: K^UU₅₅ is 5 % off if the frequencies end at
/// 3 √(g/B), 18 % at 2.4, 48 % at 1.8. What lies below the first frequency is interpolated: two
/// steps do no harm (0.1 %), four do (16 %).
struct GridNeeds {
  double first = 0.0;         ///< first frequency [rad/s]
  double step = 0.0;          ///< largest step in use [rad/s]
  double last = 0.0;          ///< last frequency in use [rad/s]
  bool endsAtPanels = false;  ///< the panels, not the grid, end the range
  bool leastCount = true;     ///< at least eight frequencies are resolved by the panels
  double neededStep = 0.0;    ///< 0.36 √(g/L) [rad/s]
  double neededLast = 0.0;    ///< 3 √(g/B) [rad/s]

  explicit GridNeeds(const Coefficients& coefficients);
  bool coarse() const { return step > neededStep * (1.0 + 1e-9); }
  bool beginsHigh() const { return first > 2.0 * neededStep * (1.0 + 1e-9); }
  bool endsLow() const { return last < neededLast * (1.0 - 1e-9); }
  /// What is wrong with the grid and what would do; empty if it meets both needs.
  std::vector<std::string> advice() const;
};

/// Why these coefficients, whose limit is not to be trusted, have no memory.
std::string unfinishedReason(const GridNeeds& grid, const ConsistentLimit& limit);
/// The same of a single frequency.
std::string singleFrequencyReason(const GridNeeds& grid);

}  // namespace cutwater
