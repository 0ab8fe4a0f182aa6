#pragma once
#include <string>
#include <vector>

#include "demos/cutwater/input/RunFile.h"
#include "plugin/Ship.h"

namespace cutwater::command {

/// What is to be said of the hull that the waves press on, in one run.
struct HullNotes {
  bool nonlinear = false;
  bool closedHull = false;     ///< the database holds one
  double pressureError = 0.0;  ///< PressureHull::pressureError
  std::string weight{};        ///< PressureHull::warning
  std::string of{};            ///< which of several runs, such as "omega = 0.4"; or ""
};
HullNotes hullNotes(const Ship& ship);

/// Lines to warn of, over all runs of a file: a hull that floats elsewhere, one that is too coarse
/// for its waves, linear mode for want of a closed hull, a wave profile that nothing reads.
std::vector<std::string> hullWarnings(const RunFile& run, const std::vector<HullNotes>& notes);

}  // namespace cutwater::command
