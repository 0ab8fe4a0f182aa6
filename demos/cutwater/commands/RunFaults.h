#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plugin/Seaway.h"

namespace cutwater::command {

/// The faults of one run.
struct RunFaults {
  std::uint32_t bits = kStepOk;
  std::array<FaultCount, 32> counts{};  ///< of each bit
  std::string part{};                   ///< of the load, that was not finite; or ""
  double farthest = 0.0;                ///< from its mean place [m]
  std::string of{};                     ///< which of several runs, such as "omega = 0.4"; or ""

  bool broken() const noexcept { return (bits & ~kWarningBits) != 0; }
};

/// Of a world's ship since the run began.
RunFaults faultsOf(const Seaway& seaway, Ship& ship);

/// A line for each bit of kWarningBits, over all runs: text, name, first time, number of ticks.
std::vector<std::string> warningLines(const std::vector<RunFaults>& runs);

/// What broke in this run, as one line.
std::string brokenLine(const RunFaults& run);

}  // namespace cutwater::command
