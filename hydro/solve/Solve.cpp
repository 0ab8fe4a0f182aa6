#include "hydro/solve/Solve.h"

#include <fmt/format.h>

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

std::string verdict(const Coefficients& c) {
  std::vector<std::string> against = panelWarnings(c);
  if (c.status == CoefficientStatus::Unfinished) {
    against.insert(against.begin(), c.unfinishedBecause);
    return fmt::format("good for the frequency domain only, at its own frequencies: {}",
                       fmt::join(against, "; "));
  }
  const std::vector<std::string> ofGrid = gridWarnings(c);
  against.insert(against.end(), ofGrid.begin(), ofGrid.end());
  for (const Mode mode : {Heave, Roll, Pitch})
    if (c.ship.restoring(mode, mode) + c.ship.supplementary.stiffness[mode] < 0.0)
      against.push_back(fmt::format("not stable upright in {}", kModeNames[mode]));
  const std::vector<std::string> ofSpeed = describe(c.stability);
  against.insert(against.end(), ofSpeed.begin(), ofSpeed.end());
  std::string line = c.status == CoefficientStatus::Given
                         ? "used as another program gave it, in the frequency and the time domain"
                         : "good for the frequency and the time domain";
  if (!against.empty()) line += fmt::format(", but: {}", fmt::join(against, "; "));
  return line;
}

ImpulseResponse impulseResponse(const Coefficients& coefficients, double step, double duration) {
  if (coefficients.status == CoefficientStatus::Unfinished) return {};
  return RetardationMatrix(coefficients).table(step, duration);
}

}  // namespace cutwater
