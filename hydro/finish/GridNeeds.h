#pragma once
#include <string>
#include <vector>

#include "hydro/finish/ConsistentLimit.h"
#include "hydro/memory/Resonances.h"

namespace cutwater {

/// Steps and range of a frequency grid, beside what the memory of a ship under way needs: steps up
/// to 0.36 √(g/L), because damping in surge, pitch and yaw rises and falls with the interference of
/// bow and stern, cos(2ω²L/g); frequencies from 0.72 √(g/L) or less up to 3 √(g/B), where heave has
/// radiated most of its waves (decision 0070; the numbers are in tests/finish/grid_needs_test.cpp).
/// THEORY.md, chapter 7.
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
  /// The grid is fine and long enough for usual ships; damping that rises and falls faster, as that
  /// of hulls with full ends, may need more.
  bool suffices() const { return leastCount && !coarse() && !beginsHigh() && !endsLow(); }
  /// What is wrong with the grid and what would do; empty if it meets both needs.
  std::vector<std::string> advice() const;
};

/// The resonances that alone keep a limit from being trusted, on a grid that suffices otherwise:
/// then its median is taken (decision 0072). Empty if anything else does so too.
std::vector<Resonance> hinderingResonances(const CoefficientTables& coefficients,
                                           const RetardationMatrix& memory,
                                           const ConsistentLimit& limit, const GridNeeds& grid);

/// A negative diagonal damping below `resolvedOmega`, which no real ship has.
struct NegativeDamping {
  Mode mode;
  double omega;  ///< [rad/s]
  double share;  ///< of the mode's largest damping, < 0
};
/// The most negative of each mode; none where no B_jj is below zero by kNegativeDampingShare of its
/// largest value.
std::vector<NegativeDamping> negativeDampings(const CoefficientTables& coefficients);
/// They in words, a line each, with mode, frequency and size.
std::vector<std::string> dampingWarnings(const CoefficientTables& coefficients);

/// What the panels do not carry below `resolvedOmega`, a line each: damping below zero, unless
/// `unfinishedBecause` says it already; A or B that differ from their transposes, as the solver
/// found them, by more than a tenth of √(A_jj A_kk). Empty: nothing to say.
std::vector<std::string> panelWarnings(const Coefficients& coefficients);

/// Why these coefficients, whose limit is not to be trusted, have no memory.
/// @param damping  their dampingWarnings.
std::string unfinishedReason(const GridNeeds& grid, const ConsistentLimit& limit,
                             const std::vector<std::string>& damping);
/// The same of a single frequency.
std::string singleFrequencyReason(const GridNeeds& grid);

}  // namespace cutwater
