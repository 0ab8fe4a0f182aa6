#include <fmt/format.h>

#include <algorithm>

#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Csv.h"
#include "demos/cutwater/Progress.h"
#include "demos/cutwater/ShipFile.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/memory/ConsistentLimit.h"

namespace cutwater::command {

namespace {

// What of the mask does not do what its user may expect.
void warnOfMask(const std::string& path, const ShipFile& ship) {
  const SolveSettings& s = ship.solve;
  if (s.lid && !(s.conditionLimitEven.empty() && s.conditionLimitOdd.empty())) {
    warn(path +
         ": [solve] condition limits with lid = true: condition numbers jump by a factor of about "
         "5 where the lid begins, one limit does not fit both sides");
  }
  // With G off the centre plane the modes mix and the hull is solved whole, too.
  const bool halves = ship.particulars.symmetric && ship.particulars.cog.y() == 0.0;
  if (!halves && !s.conditionLimitOdd.empty()) {
    warn(path +
         ": [solve] condition_limit_odd: without symmetry about the centre plane all modes are one "
         "system, which condition_limit_even masks; this one is not used");
  }
}

}  // namespace

// A sweep can take minutes: better to know first that its result can be kept.
void solve(const std::string& path, const std::string& database, int threads) {
  requireWritable(database);
  ShipFile ship = readShipFile(path);
  ship.solve.threads = threads;
  warnOfMask(path, ship);
  fmt::print(stderr, "solve: {} panels{}, {} frequencies, {} headings\n",
             ship.particulars.wetSurface.faces.size(), ship.particulars.symmetric ? " a side" : "",
             ship.solve.omega.size(), ship.solve.headings.size());
  Progress progress("solve");
  Coefficients coefficients;
  naming(path, [&] {
    coefficients = readyForUse(
        buildCoefficients(ship.particulars, ship.solve,
                          [&progress](int done, int total) { progress.at(done, total); }));
  });
  if (const auto left = std::count(coefficients.masked.begin(), coefficients.masked.end(), 1);
      left > 0) {
    fmt::print(stderr, "solve: {} of {} frequencies masked and interpolated\n", left,
               coefficients.omega.size());
  }
  const std::vector<double>& waveOmega = ship.solve.waveOmega;
  if (coefficients.resolvedOmega > 0.0 && coefficients.resolvedOmega < waveOmega.back()) {
    warn(
        fmt::format("{}: the panels resolve waves up to {:.2f} rad/s only, wave_omega ends at "
                    "{:.2f}; use a finer mesh",
                    path, coefficients.resolvedOmega, waveOmega.back()));
  }
  constexpr double kStep = 0.05, kDuration = 30.0;  // of K for the readers of BEMIO [s]
  ImpulseResponse memory;
  naming(path, [&] { memory = RetardationMatrix(coefficients).table(kStep, kDuration); });
  writeCoefficients(coefficients, database, memory);
}

}  // namespace cutwater::command
