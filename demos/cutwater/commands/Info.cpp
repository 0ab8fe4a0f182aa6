#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/output/Csv.h"
#include "hydro/base/EnumNames.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/finish/Finish.h"
#include "hydro/memory/RadiationModel.h"
#include "hydro/solve/Solve.h"

namespace cutwater::command {

namespace {

void list(Csv& csv, const std::string& name, const std::string& value, const std::string& unit) {
  const bool quoted = value.find_first_of(",\"\n") != std::string::npos;
  std::string cell = value;
  for (std::size_t i = 0; quoted && (i = cell.find_first_of("\"\n", i)) != std::string::npos;
       i += 2) {
    cell.replace(i, 1, cell[i] == '"' ? "\"\"" : "; ");
  }
  cell = printable(cell, cell.size());  // texts of a file, perhaps of another code
  csv.line(name + "," + (quoted ? "\"" + cell + "\"" : cell) + "," + unit);
}

// An axis of the ship in the file's: by name where it is one of them.
std::string axisText(const Vec3& axis) {
  for (int i = 0; i < 3; ++i) {
    if (axis == Vec3::Unit(i)) return std::string(1, "xyz"[i]);
    if (axis == -Vec3::Unit(i)) return std::string("-") + "xyz"[i];
  }
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", axis.x(), axis.y(), axis.z());
}

// The hull file's own axes, unit and origin, as the ship was solved with.
void listFile(Csv& csv, const FilePlacement& file) {
  list(csv, "file_up", axisText(file.rotation.row(2)), "");
  list(csv, "file_forward", axisText(file.rotation.row(0)), "");
  list(csv, "file_unit", csvNumber(file.metresPerUnit), "m");
  for (int i = 0; i < 3; ++i)
    list(csv, std::string("file_origin_") + "xyz"[i], csvNumber(file.origin[i]), "m");
}

void listShip(Csv& csv, const ShipParticulars& ship) {
  list(csv, "ship", ship.name, "");
  const auto number = [&](const std::string& name, double value, const std::string& unit) {
    list(csv, name, csvNumber(value), unit);
  };
  number("mass", ship.mass, "kg");
  const char* axes[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) number(std::string("cog_") + axes[i], ship.cog[i], "m");
  const char* about[3] = {"roll", "pitch", "yaw"};
  for (int i = 0; i < 3; ++i) number(std::string("gyradius_") + about[i], ship.gyradii[i], "m");
  number("volume", ship.volume, "m^3");
  number("density", ship.density, "kg/m^3");
  number("gravity", ship.gravity, "m/s^2");
  number("symmetric", ship.symmetric ? 1 : 0, "");
  listFile(csv, ship.file);
  number("wet_panels_stored", static_cast<double>(ship.wetSurface.faces.size()), "");
  number("hull_faces", static_cast<double>(ship.hull.faces.size()), "");
  for (int i = 0; i < 6; ++i) {
    const std::string mode = kModeNames[i];
    if (ship.supplementary.damping[i] != 0.0) {
      number(mode + "_damping", ship.supplementary.damping[i], i < 3 ? "N/(m/s)" : "N m/(rad/s)");
    }
    if (ship.supplementary.stiffness[i] != 0.0) {
      number(mode + "_stiffness", ship.supplementary.stiffness[i], i < 3 ? "N/m" : "N m/rad");
    }
  }
  number("roll_damping_quadratic", ship.supplementary.rollDampingQuadratic, "N m/(rad/s)^2");
  number("cross_flow_drag", ship.drag.crossFlow, "");
  number("form_factor", ship.drag.formFactor, "");
  list(csv, "engine", ship.engine ? "1" : "0", "");
  list(csv, "rudder", ship.rudder ? "1" : "0", "");
}

// Largest distance of A(∞) of the ω = ∞ problem itself from the one in use, in % of √(A_jj A_kk).
double infinityDifference(const Coefficients& c) {
  if (!c.hasConsistentLimit()) return 0.0;
  const Vec6 size = c.addedMass.atInfinity.diagonal().cwiseSqrt();
  const Mat6 difference = c.addedMassInfDirect - c.addedMass.atInfinity;
  return 100.0 * difference.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff();
}

// Where the coefficients may not be taken as solved: mask, its envelopes, condition numbers.
void listMask(Csv& csv, const Coefficients& c) {
  std::string masked;
  int count = 0;
  for (std::size_t i = 0; i < c.masked.size(); ++i) {
    if (c.masked[i] == 0) continue;
    masked += (count++ > 0 ? " " : "") + csvNumber(c.omega[i]);
  }
  list(csv, "masked_frequencies", csvNumber(count), "");
  if (count > 0) list(csv, "masked_omega", masked, "rad/s");
  for (const auto& [name, limit] : {std::pair{"condition_limit_even", &c.conditionLimitEven},
                                    std::pair{"condition_limit_odd", &c.conditionLimitOdd}}) {
    std::string points;
    for (const auto& [omega, value] : *limit) {
      points +=
          fmt::format("{}[{}; {}]", points.empty() ? "" : " ", csvNumber(omega), csvNumber(value));
    }
    if (!points.empty()) list(csv, name, points, "[rad/s; 1]");
  }
  for (const auto& [name, table] : {std::pair{"condition_even_max", &c.conditionEven},
                                    std::pair{"condition_odd_max", &c.conditionOdd}}) {
    if (!table->empty())
      list(csv, name, csvNumber(*std::max_element(table->begin(), table->end())), "");
  }
}

// As the solver found it, if the file tells; the matrices themselves are symmetrised in ours.
double solversAsymmetry(const Coefficients& c, const std::string& name,
                        const OverFrequency<Mat6>& table) {
  std::string told = c.provenance.setting(name + "_asymmetry_resolved");
  if (told.empty()) told = c.provenance.setting(name + "_asymmetry");  // as 0.1.0 wrote it
  return 100.0 * (told.empty() ? asymmetry(table) : std::strtod(told.c_str(), nullptr));
}

// Speeds at which the ship's own motions grow.
void listStability(Csv& csv, const SpeedStability& stability) {
  if (stability.checkedTo <= 0.0) return;
  list(csv, "stability_checked_to", csvNumber(stability.checkedTo), "m/s");
  const auto limit = [&](const std::string& name, const GrowthLimit& found) {
    list(csv, name, found.speed ? csvNumber(*found.speed) : "none", "m/s");
    if (found.speed) list(csv, name + "_mode", kModeNames[found.mode], "");
  };
  limit("unstable_above", stability.ahead);
  limit("unstable_above_astern", stability.astern);
  list(csv, "course_stable", stability.course ? "0" : "1", "");
  if (stability.course) list(csv, "course_unstable_above", csvNumber(*stability.course), "m/s");
}

// What the file holds for forward speed.
void listSpeed(Csv& csv, const Coefficients& c) {
  list(csv, "forward_speed", nameOf(kForwardSpeedNames, c.forwardSpeed), "");
  list(csv, "adjoint_vectors", c.adjoint.empty() ? "0" : "1", "");
  list(csv, "adjoint_vectors_dx", c.adjointX.empty() ? "0" : "1", "");
  list(csv, "x_derivatives", c.addedMassX.empty() ? "0" : "1", "");
  for (std::size_t i = 0; i < c.diffractionTable.speeds.size(); ++i) {
    list(csv, fmt::format("speed_{}", i + 1), csvNumber(c.diffractionTable.speeds[i]), "m/s");
  }
  if (!c.adjoint.empty()) list(csv, "speeds", "any", "m/s");
  listStability(csv, c.stability);
}

// How the time domain remembers: the fit's size and its distance from the convolution.
void listMemory(Csv& csv, const Coefficients& c) {
  if (c.omega.size() < 2 || c.status == CoefficientStatus::Unfinished) return;
  const RadiationModel model(c, usableForm(c));
  if (model.sum().size() == 0) return;
  list(csv, "memory_duration", csvNumber(model.retardation().duration()), "s");
  list(csv, "memory_poles", csvNumber(static_cast<double>(model.sum().size())), "");
  list(csv, "memory_fit_error", csvNumber(100.0 * model.sum().error()), "%");
}

}  // namespace

void info(const std::string& database, const std::string& out) {
  std::string warning;
  const Coefficients c = readCoefficients(database, &warning);
  warn(warning);
  warnOfResonances(database, c);
  Csv csv("name,value,unit");
  list(csv, "status", nameOf(kCoefficientStatusNames, c.status), "");
  if (!c.unfinishedBecause.empty()) list(csv, "unfinished_because", c.unfinishedBecause, "");
  listShip(csv, c.ship);
  const auto number = [&](const std::string& name, double value, const std::string& unit) {
    list(csv, name, csvNumber(value), unit);
  };
  number("frequencies", static_cast<double>(c.omega.size()), "");
  number("omega_first", c.omega.front(), "rad/s");
  number("omega_last", c.omega.back(), "rad/s");
  number("omega_resolved", c.resolvedOmega, "rad/s");
  number("headings", static_cast<double>(c.headings.size()), "");
  for (std::size_t i = 0; i < c.headings.size(); ++i) {
    number(fmt::format("heading_{}", i + 1), c.headings[i] * 180.0 / kPi, "deg");
  }
  list(csv, "formulation", c.provenance.setting("formulation"), "");
  listSpeed(csv, c);
  listMask(csv, c);
  listMemory(csv, c);
  number("check_added_mass_asymmetry", solversAsymmetry(c, "added_mass", c.addedMass), "%");
  number("check_damping_asymmetry", solversAsymmetry(c, "damping", c.damping), "%");
  double smallest = std::numeric_limits<double>::infinity();
  for (const Mat6& b : c.damping) smallest = std::min(smallest, b.diagonal().minCoeff());
  number("check_damping_smallest_diagonal", smallest, "");
  number("added_mass_inf_from_finite_frequencies", c.hasConsistentLimit() ? 1 : 0, "");
  number("check_added_mass_inf_direct_difference", infinityDifference(c), "%");
  list(csv, "code", c.provenance.code, "");
  list(csv, "version", c.provenance.version, "");
  list(csv, "mesh_hash", c.provenance.meshHash, "");
  list(csv, "settings", c.provenance.settings, "");
  list(csv, "verdict", verdict(c), "");
  csv.write(out);
}

}  // namespace cutwater::command
