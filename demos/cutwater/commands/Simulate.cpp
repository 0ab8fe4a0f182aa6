#include <algorithm>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/Precision.h"
#include "demos/cutwater/commands/RunShip.h"
#include "demos/cutwater/output/Csv.h"
#include "demos/cutwater/output/Progress.h"
#include "hydro/Errors.h"
#include "plugin/Recorder.h"

namespace cutwater::command {

std::string describeFaults(std::uint32_t faults) {
  std::string line;
  const auto add = [&](StepFault bit, const char* what) {
    if ((faults & bit) != 0) line += (line.empty() ? "" : "; ") + std::string(what);
  };
  add(kLoadNotFinite, "a load was not finite and was not applied");
  add(kStateNotFinite, "the ship's position or velocity was not finite");
  add(kTickLengthChanged, "the tick length changed");
  add(kBodyNotInWorld, "the ship's body left the world");
  add(kCallbackReplaced, "the world's pre-tick callback was overwritten");
  add(kSolverNotSupported, "the solver cannot carry added mass");
  return line;
}

void simulate(const std::string& path, bool forces, const std::string& out) {
  requireWritable(out);
  const RunFile run = readRunFile(path);
  usePrecision(run.doublePrecision);
  if (run.omega.size() > 1) {
    throw HydroError(Fault::ValueOutOfRange,
                     path + ": [waves] omega: simulate takes one frequency; `sweep` takes several");
  }
  const Coefficients coefficients = readShipOfRun(run);
  RunShip world(run, coefficients);
  Recorder recorder(world.seaway(), world.ship(), {.forces = forces});
  Progress progress("simulate");
  const auto rows = static_cast<std::size_t>(run.duration / run.tick + 1e-6) + 1;
  recorder.reserve(rows + static_cast<std::size_t>(run.substeps));
  while (recorder.rows() < rows) {
    world.step();
    progress.at(static_cast<int>(std::min(recorder.rows(), rows)), static_cast<int>(rows));
  }
  const std::string faults = describeFaults(world.seaway().faults());
  if (!faults.empty()) throw HydroError(Fault::ValueOutOfRange, path + ": " + faults);
  writeText(recorder.csv(), out);
}

}  // namespace cutwater::command
