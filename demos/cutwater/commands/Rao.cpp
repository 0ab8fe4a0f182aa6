#include <fmt/format.h>

#include <cmath>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/WaveGrid.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/Errors.h"
#include "hydro/database/ChangeOfLoading.h"
#include "hydro/memory/SpeedStability.h"
#include "hydro/response/FrequencyResponse.h"
#include "hydro/waves/Wave.h"

namespace cutwater::command {

namespace {

// The option's vector; absent where it is not given.
std::optional<Vec3> given(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  return vectorOption(option, text);
}

// A ship on a fixed course at a speed at which its own motions grow has no steady answer.
void warnIfUnstable(const std::string& database, const Coefficients& c, double speed) {
  const GrowthLimit& limit = speed < 0.0 ? c.stability.astern : c.stability.ahead;
  if (limit.speed && std::abs(speed) >= *limit.speed)
    warn(database + ": " + describe(limit, speed < 0.0));
}

}  // namespace

void rao(const std::string& database, const WaveOptions& options, const LoadingOptions& loading,
         bool free, const std::string& out) {
  if (free && options.moving.formName == "report")
    throw UsageError("--free: a free ship has Tuck's form; --form report belongs to fixed courses");
  SpeedOptions moving = options.moving;
  if (free) moving.formName = "tuck";
  const auto cog = given("--cog", loading.cog), gyradii = given("--gyradii", loading.gyradii);
  if (loading.mass && !(*loading.mass > 0.0 && *loading.mass <= 1e15))
    throw UsageError(fmt::format("--mass {}: must be in 0..1e15 kg", *loading.mass));
  Coefficients coefficients = readDatabase(database, moving);
  if (loading.mass || cog || gyradii) {
    const ShipParticulars ship = coefficients.ship;
    naming(database, [&] {
      coefficients = withLoading(coefficients, loading.mass.value_or(ship.mass),
                                 cog.value_or(ship.cog), gyradii.value_or(ship.gyradii));
    });
  }
  std::optional<FrequencyResponse> response;
  naming(database, [&] {
    if (free) {
      response.emplace(coefficients, FrequencyResponse::Free{});
    } else {
      response.emplace(coefficients, std::array<bool, 6>{}, moving.form(coefficients));
    }
  });
  const double heading = headingRadians(options.headingDeg), speed = moving.speed;
  Csv csv("omega,omega_e,j,amplitude,phase_deg");
  int slow = 0;
  const auto add = [&](double omega) {
    const double met = encounterFrequency(omega, speed, heading, coefficients.ship.gravity);
    if (speed != 0.0 && std::abs(met) < kLeastEncounterFrequency) ++slow;
    const CVec6 eta = response->atOrNan(omega, heading, speed);
    for (int j = 0; j < 6; ++j) {
      csv.row({omega, met, j + 1.0, std::abs(eta[j]), phaseDegrees(eta[j])});
    }
  };
  const auto omegas = omegaList(options.omegaRange, defaultWaveOmega(coefficients));
  warnIfUnresolved(database, coefficients, omegas.back());
  if (!free && moving.form(coefficients) == coefficients.forwardSpeed)
    warnIfUnstable(database, coefficients, speed);
  naming(database, [&] {
    for (const double omega : omegas) add(omega);
  });
  if (slow > 0) {
    warn(
        fmt::format("{} of {} waves are met at less than {} rad/s, where surge, sway and yaw are "
                    "not theory",
                    slow, omegas.size(), kLeastEncounterFrequency));
  }
  csv.write(out);
}

}  // namespace cutwater::command
