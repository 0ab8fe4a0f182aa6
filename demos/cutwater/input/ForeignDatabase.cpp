#include "demos/cutwater/input/ForeignDatabase.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/database/BemioContradictions.h"
#include "hydro/database/Interpolation.h"
#include "hydro/finish/ConsistentLimit.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater::command {

namespace {

constexpr const char* kLimit = "body1/hydro_coeffs/added_mass/inf_freq";
constexpr const char* kBoth = "body1/hydro_coeffs/added_mass/all and radiation_damping/all";

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw HydroError(Fault::DatabaseIncomplete,
                   fmt::format("{}: not for the time domain: {}", file, what));
}

/// The pair of modes in which two matrices differ most, of √(A_jj A_kk) of the second.
struct Worst {
  Eigen::Index j = 0, k = 0;
  double share = 0.0;
  Worst(const Mat6& a, const Mat6& b) {
    const Vec6 size = b.diagonal().cwiseAbs().cwiseSqrt();
    const Vec6 least = Vec6::Constant(1e-6 * size.maxCoeff());
    const Vec6 scale = size.cwiseMax(least);
    share = (a - b).cwiseQuotient(scale * scale.transpose()).cwiseAbs().maxCoeff(&j, &k);
  }
  std::string name() const { return fmt::format("A_{}{}", j + 1, k + 1); }
};

/// A(∞) of a file that holds 0 for it. The start, A at the last frequency, only says how large
/// added mass is.
void fillLimit(Coefficients& c, const std::string& file) {
  Coefficients filled = c;
  filled.addedMass.atInfinity = c.addedMass.values.back();
  filled.status = CoefficientStatus::Given;
  filled.unfinishedBecause.clear();
  if (!bemioContradictions(filled).empty()) refuse(file, c.unfinishedBecause);
  const ConsistentLimit limit = consistentLimit(filled, RetardationMatrix(filled));
  if (!(limit.scatter > 0.0 && limit.scatter < kLargestScatter)) refuse(file, c.unfinishedBecause);
  filled.addedMass.atInfinity = limit.addedMassInf;
  c = filled;
  warn(fmt::format("{}: {} is 0: A(inf) is taken from {}, A_33(inf) = {:.4g} kg", file, kLimit,
                   kBoth, c.addedMass.atInfinity(Heave, Heave)));
}

/// Where the limit from A and B differs most from their mean.
std::string scatterOf(const Coefficients& c, const RetardationMatrix& memory,
                      const ConsistentLimit& limit) {
  Worst worst(limit.addedMassInf, limit.addedMassInf);
  double omega = 0.0;
  for (std::size_t i = 0; i < resolvedCount(c); ++i) {
    const Worst here(memory.addedMassInf(c.omega[i], c.addedMass[i]), limit.addedMassInf);
    if (!(here.share > worst.share)) continue;
    worst = here;
    omega = c.omega[i];
  }
  return fmt::format(
      "{} contradict each other: {}(inf) from omega = {:.6g} rad/s is {:.3g} % off the mean", kBoth,
      worst.name(), omega, 100.0 * worst.share);
}

std::string distanceOf(const Coefficients& c, const ConsistentLimit& limit) {
  const Worst worst(c.addedMass.atInfinity, limit.addedMassInf);
  return fmt::format("{}: {}(inf) = {:.4g}, but {} give {:.4g}", kLimit, worst.name(),
                     c.addedMass.atInfinity(worst.j, worst.k), kBoth,
                     limit.addedMassInf(worst.j, worst.k));
}

}  // namespace

bool isForeign(const Coefficients& c) {
  return c.ship.wetSurface.faces.empty() && c.ship.hull.faces.empty() && c.ship.gyradii.isZero();
}

void giveBody(Coefficients& c, const ForeignBody& body) {
  ShipParticulars& ship = c.ship;
  ship.gyradii = body.gyradii;
  const double draught = -2.0 * ship.centreOfBuoyancy.z();
  ship.hull = closedBox({body.size.x(), body.size.y(), draught, body.size.z() - draught}, 1, 1, 1);
  const Vec3 place(ship.centreOfBuoyancy.x(), ship.centreOfBuoyancy.y(), 0.0);
  for (Vec3& vertex : ship.hull.vertices) vertex += place;
}

void makeConsistent(Coefficients& c, const std::string& file) {
  if (c.status == CoefficientStatus::Unfinished) {
    if (!c.addedMass.atInfinity.isZero(0.0)) refuse(file, c.unfinishedBecause);
    fillLimit(c, file);
  }
  const RetardationMatrix memory(c);
  const ConsistentLimit limit = consistentLimit(c, memory);
  const GridNeeds grid(c);
  const std::vector<std::string> advice = grid.advice();
  if (const std::string places = listed(hinderingResonances(c, memory, limit, grid));
      !places.empty()) {
    warn(
        fmt::format("{}: {}: resonances narrower than the steps of simulation_parameters/w, at {} "
                    "rad/s. There motions in the time domain are not right",
                    file, kBoth, places));
  } else {
    if (limit.scatter >= kLargestScatter)
      refuse(file, fmt::format("{}{}{}", scatterOf(c, memory, limit), advice.empty() ? "" : "; ",
                               fmt::join(advice, "; ")));
    if (limit.distance >= kLargestDistance) refuse(file, distanceOf(c, limit));
  }
  for (const std::string& line : advice) warn(file + ": simulation_parameters/w: " + line);
}

}  // namespace cutwater::command
