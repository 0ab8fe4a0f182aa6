#include <fmt/format.h>

#include "demos/cutwater/Commands.h"
#include "demos/cutwater/Progress.h"
#include "demos/cutwater/ShipFile.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::command {

void solve(const std::string& path, const std::string& database, int threads) {
  ShipFile ship = readShipFile(path);
  ship.solve.threads = threads;
  fmt::print(stderr, "solve: {} panels{}, {} frequencies, {} headings\n",
             ship.particulars.wetSurface.faces.size(), ship.particulars.symmetric ? " a side" : "",
             ship.solve.omega.size(), ship.solve.headings.size());
  Progress progress("solve");
  Coefficients coefficients = buildCoefficients(
      ship.particulars, ship.solve, [&progress](int done, int total) { progress.at(done, total); });
  coefficients.waveOmega = ship.waveOmega;
  writeCoefficients(coefficients, database);
}

}  // namespace cutwater::command
