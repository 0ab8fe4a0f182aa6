#include "hydro/ship/Righting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/base/EnumNames.h"
#include "hydro/ship/StabilityRange.h"

namespace cutwater::command {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kLeastTold = 0.0005 * kDegree;  // a list of which three decimals show something

std::string heelText(double heel) {
  return fmt::format("{:.3f} deg to {}", std::abs(heel) / kDegree,
                     heel < 0.0 ? "port" : "starboard");
}

/// A ship that does not stay upright, and where it goes.
void tellRest(const std::string& path, const ShipFile& ship, const StabilityRange& range,
              const char* side) {
  if (range.gm < 0.0 && ship.hydrostatics.gmT > 0.0)  // else readShipFile has said so
    warn(
        fmt::format("{}: GM is {:.3f} m as it floats with its mass: the ship is not stable upright",
                    path, range.gm));
  if (!range.rest) {
    warn(fmt::format("{}: to {} it comes to rest at no angle of heel but keel up", path, side));
  } else if (std::abs(*range.rest) > kLeastTold) {
    warn(fmt::format("{}: it lies at rest at {} of {}", path,
                     range.gm < 0.0 ? "an angle of loll" : "a list", heelText(*range.rest)));
  }
}

/// One side of the table, `last` its greatest heel there [rad]. A list that was told of the other
/// side is not told again.  @return where the ship lies at rest.
std::optional<double> tellSide(const std::string& path, const ShipFile& ship, Righting& righting,
                               double last, std::optional<double> told = {}) {
  const StabilityRange range = stabilityRange(righting, last);
  if (!told || range.rest != told) tellRest(path, ship, range, last < 0.0 ? "port" : "starboard");
  if (range.greatest)
    say(fmt::format("{}: greatest gz {:.4f} m at {}", path, std::abs(range.greatest->gz),
                    heelText(range.greatest->heel)));
  if (range.vanishing) say(fmt::format("{}: gz vanishes at {}", path, heelText(*range.vanishing)));
  return range.rest;
}

/// Where the trim is not that of a ship heeled slowly.
void tellTrim(const std::string& path, const Righting& righting,
              const std::vector<RightingLever>& levers) {
  for (const Righting::TrimJump& jump : righting.trimJumps())
    warn(
        fmt::format("{}: at heel {:.2f} deg the trim goes from {:.2f} to {:.2f} deg: the "
                    "equilibrium that begins upright ends there",
                    path, jump.heel / kDegree, jump.from / kDegree, jump.to / kDegree));
  const auto unstable = std::count_if(levers.begin(), levers.end(),
                                      [](const auto& lever) { return !lever.trimIsStable; });
  if (unstable > 0)
    warn(
        fmt::format("{}: at {} of {} heels the trim is an equilibrium that the ship would leave "
                    "end over end",
                    path, unstable, levers.size()));
}

}  // namespace

void righting(const std::string& path, const std::string& heels, const std::string& trim,
              const std::string& out) {
  const std::vector<double> degrees = rangeOption("--heel", heels, 180.0, "0:180:37");
  const auto mode = fromName<RightingTrim>(kRightingTrimNames, trim);
  const ShipFile ship = readShipFile(path);
  Csv csv("heel_deg,gz,height,trim_deg,volume");
  naming(path, [&] {
    Righting righting(ship.particulars, mode.value_or(RightingTrim::Free));
    std::vector<RightingLever> levers;
    for (const double heel : degrees) {
      levers.push_back(righting.at(heel * kDegree));
      const RightingLever& lever = levers.back();
      csv.row({heel, lever.gz, lever.height, lever.trim / kDegree, lever.volume});
    }
    std::optional<double> rest;
    if (degrees.back() > 0.0 || degrees.front() >= 0.0)
      rest = tellSide(path, ship, righting, degrees.back() * kDegree);
    if (degrees.front() < 0.0) tellSide(path, ship, righting, degrees.front() * kDegree, rest);
    tellTrim(path, righting, levers);
  });
  csv.write(out);
}

}  // namespace cutwater::command
