#include "hydro/database/BemioContradictions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/database/BemioLayout.h"
#include "hydro/database/NegativeDamping.h"

namespace cutwater {

namespace {

/// What added mass of a mode is measured by: ρV, and ρV^{5/3} of a rotation.
double massOf(const ShipParticulars& ship, int mode) {
  return ship.density * ship.volume * (mode < 3 ? 1.0 : std::pow(ship.volume, 2.0 / 3.0));
}

/// Some programs write 0 for an A(∞) that they have not computed. A body without added mass in a
/// mode, such as the yaw of a body of revolution, has none at the frequencies either.
std::string missingLimits(const Coefficients& c) {
  std::string modes;
  for (int j = 0; j < 6; ++j) {
    const double last = c.addedMass.values.back()(j, j);
    if (c.addedMass.atInfinity(j, j) != 0.0 || std::abs(last) < 1e-3 * massOf(c.ship, j)) continue;
    modes += fmt::format("{}A_{}{}", modes.empty() ? "" : ", ", j + 1, j + 1);
  }
  if (modes.empty()) return {};
  return fmt::format(
      "{}added_mass/inf_freq is 0 for {}, but added_mass/all is not: A(inf) was not "
      "computed",
      kBemioCoefficients, modes);
}

/// Damping below zero by more than kNegativeDampingShare, and by more than next to nothing.
std::string negativeDamping(const Coefficients& c, int j) {
  double most = 0.0;
  for (const Mat6& b : c.damping) most = std::max(most, b(j, j));
  const double trifle =
      1e-6 * massOf(c.ship, j) * std::sqrt(c.ship.gravity / std::cbrt(c.ship.volume));
  std::string at;
  int count = 0;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (c.damping[i](j, j) >= -std::max(kNegativeDampingShare * most, trifle)) continue;
    if (++count <= 4) at += fmt::format("{}{:.6g}", count > 1 ? ", " : "", c.omega[i]);
  }
  if (count == 0) return {};
  return fmt::format("{}radiation_damping/all: B_{}{} < 0 at omega = {}{} rad/s",
                     kBemioCoefficients, j + 1, j + 1, at,
                     count > 4 ? fmt::format(" and {} more", count - 4) : "");
}

}  // namespace

std::vector<std::string> bemioContradictions(const Coefficients& c) {
  std::vector<std::string> lines{missingLimits(c)};
  for (int j = 0; j < 6; ++j) lines.push_back(negativeDamping(c, j));
  std::erase(lines, "");
  return lines;
}

}  // namespace cutwater
