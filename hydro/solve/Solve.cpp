#include "hydro/solve/Solve.h"

#include "hydro/finish/Finish.h"

namespace cutwater {

Coefficients solve(const ShipParticulars& ship, const SolveSettings& settings,
                   const SolveProgress& progress, const std::string& journal) {
  return finish(buildCoefficients(ship, settings, progress, journal));
}

}  // namespace cutwater
