#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/output/ShipListing.h"
#include "hydro/base/CsvRow.h"
#include "hydro/base/EnumNames.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/finish/Finish.h"
#include "hydro/memory/RadiationModel.h"
#include "hydro/solve/Solve.h"

namespace cutwater::command {

namespace {

// Where the coefficients may not be taken as solved: mask, its envelopes, condition numbers.
void listMask(Listing& rows, const Coefficients& c) {
  std::string masked;
  int count = 0;
  for (std::size_t i = 0; i < c.masked.size(); ++i) {
    if (c.masked[i] == 0) continue;
    masked += (count++ > 0 ? " " : "") + csvNumber(c.omega[i]);
  }
  rows.add("masked_frequencies", static_cast<double>(count));
  if (count > 0) rows.add("masked_omega", masked, "rad/s");
  for (const auto& [name, limit] : {std::pair{"condition_limit_even", &c.conditionLimitEven},
                                    std::pair{"condition_limit_odd", &c.conditionLimitOdd}}) {
    std::string points;
    for (const auto& [omega, value] : *limit) {
      points +=
          fmt::format("{}[{}; {}]", points.empty() ? "" : " ", csvNumber(omega), csvNumber(value));
    }
    if (!points.empty()) rows.add(name, points, "[rad/s; 1]");
  }
  for (const auto& [name, table] : {std::pair{"condition_even_max", &c.conditionEven},
                                    std::pair{"condition_odd_max", &c.conditionOdd}}) {
    if (!table->empty()) rows.add(name, *std::max_element(table->begin(), table->end()));
  }
}

// Speeds at which the ship's own motions grow.
void listStability(Listing& rows, const SpeedStability& stability) {
  if (stability.checkedTo <= 0.0) return;
  rows.add("stability_checked_to", stability.checkedTo, "m/s");
  const auto limit = [&](const std::string& name, const GrowthLimit& found) {
    rows.add(name, found.speed ? csvNumber(*found.speed) : "none", "m/s");
    if (found.speed) rows.add(name + "_mode", kModeNames[found.mode]);
  };
  limit("unstable_above", stability.ahead);
  limit("unstable_above_astern", stability.astern);
  rows.add("course_stable", stability.course ? "0" : "1");
  if (stability.course) rows.add("course_unstable_above", *stability.course, "m/s");
}

// What the file holds for forward speed.
void listSpeed(Listing& rows, const Coefficients& c) {
  rows.add("forward_speed", nameOf(kForwardSpeedNames, c.forwardSpeed));
  rows.add("adjoint_vectors", c.adjoint.empty() ? "0" : "1");
  rows.add("adjoint_vectors_dx", c.adjointX.empty() ? "0" : "1");
  rows.add("x_derivatives", c.addedMassX.empty() ? "0" : "1");
  for (std::size_t i = 0; i < c.diffractionTable.speeds.size(); ++i) {
    rows.add(fmt::format("speed_{}", i + 1), c.diffractionTable.speeds[i], "m/s");
  }
  if (!c.adjoint.empty()) rows.add("speeds", "any", "m/s");
  listStability(rows, c.stability);
}

// How the time domain remembers: the fit's size and its distance from the convolution.
void listMemory(Listing& rows, const Coefficients& c) {
  if (c.omega.size() < 2 || c.status == CoefficientStatus::Unfinished) return;
  const RadiationModel model(c, usableForm(c));
  if (model.sum().size() == 0) return;
  rows.add("memory_duration", model.retardation().duration(), "s");
  rows.add("memory_poles", static_cast<double>(model.sum().size()));
  rows.add("memory_fit_error", 100.0 * model.sum().error(), "%");
}

}  // namespace

void info(const std::string& database, const std::string& out) {
  std::string warning;
  const Coefficients c = readCoefficients(database, &warning);
  warn(warning);
  warnOfResonances(database, c);
  Listing rows;
  rows.add("status", nameOf(kCoefficientStatusNames, c.status));
  if (!c.unfinishedBecause.empty()) rows.add("unfinished_because", c.unfinishedBecause);
  listShip(rows, c.ship);
  rows.add("frequencies", static_cast<double>(c.omega.size()));
  rows.add("omega_first", c.omega.front(), "rad/s");
  rows.add("omega_last", c.omega.back(), "rad/s");
  rows.add("omega_resolved", c.resolvedOmega, "rad/s");
  rows.add("headings", static_cast<double>(c.headings.size()));
  for (std::size_t i = 0; i < c.headings.size(); ++i) {
    rows.add(fmt::format("heading_{}", i + 1), c.headings[i] * 180.0 / kPi, "deg");
  }
  rows.add("formulation", c.provenance.setting("formulation"));
  listSpeed(rows, c);
  listMask(rows, c);
  listMemory(rows, c);
  rows.add("check_added_mass_asymmetry", solversAsymmetry(c, "added_mass", c.addedMass), "%");
  rows.add("check_damping_asymmetry", solversAsymmetry(c, "damping", c.damping), "%");
  double smallest = std::numeric_limits<double>::infinity();
  for (const Mat6& b : c.damping) smallest = std::min(smallest, b.diagonal().minCoeff());
  rows.add("check_damping_smallest_diagonal", smallest);
  rows.add("added_mass_inf_from_finite_frequencies", c.hasConsistentLimit() ? 1 : 0);
  rows.add("check_added_mass_inf_direct_difference", infinityDifference(c), "%");
  rows.add("code", c.provenance.code);
  rows.add("version", c.provenance.version);
  rows.add("mesh_hash", c.provenance.meshHash);
  rows.add("settings", c.provenance.settings);
  rows.add("verdict", verdict(c));
  rows.write(out);
}

}  // namespace cutwater::command
