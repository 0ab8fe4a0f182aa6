#include "hydro/solve/Solve.h"

#include <algorithm>

#include "hydro/bem/BuildCoefficients.h"
#include "hydro/finish/Finish.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/memory/Resonances.h"
#include "hydro/memory/SpeedStability.h"

namespace cutwater {

Coefficients solve(const ShipParticulars& ship, const SolveSettings& settings,
                   const SolveProgress& progress, const std::string& journal) {
  Coefficients c = finish(buildCoefficients(ship, settings, progress, journal));
  if (c.status != CoefficientStatus::Finished) return c;
  const double asked = settings.speeds.empty()
                           ? 0.0
                           : *std::max_element(settings.speeds.begin(), settings.speeds.end());
  c.stability = speedStability(c, RadiationModel(c, c.forwardSpeed),
                               std::max(asked, lastSpeedToCheck(c.ship)));
  return c;
}

std::vector<std::string> gridWarnings(const Coefficients& c) {
  if (c.status == CoefficientStatus::Unfinished) {
    return {
        "the database is unfinished, for coefficients, excitation and motions in the frequency "
        "domain only: " +
        c.unfinishedBecause};
  }
  std::vector<std::string> lines = GridNeeds(c).advice();
  for (std::string& line : lines)
    line = "the memory of a ship under way (K^UU) is not accurate: " + line;
  if (std::string resonances = resonanceWarning(c); !resonances.empty())
    lines.push_back(std::move(resonances));
  return lines;
}

ImpulseResponse impulseResponse(const Coefficients& coefficients, double step, double duration) {
  if (coefficients.status == CoefficientStatus::Unfinished) return {};
  return RetardationMatrix(coefficients).table(step, duration);
}

}  // namespace cutwater
