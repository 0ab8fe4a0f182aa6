#include "hydro/finish/GridNeeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hydro/database/Interpolation.h"
#include "hydro/database/NegativeDamping.h"

namespace cutwater {

namespace {

constexpr double kStep = 0.36;  // of √(g/L)
constexpr double kLast = 3.0;   // of √(g/B)

/// Two digits, downwards or upwards: what is said to do must do.
double rounded(double value, bool up) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0), n = value / unit;
  return unit * (up ? std::ceil(n - 1e-9) : std::floor(n + 1e-9));
}

std::string needed(double value, double factor, const char* unit, bool up) {
  return fmt::format("{:.2g} rad/s ({} {})", rounded(value, up), factor, unit);
}
std::string stepOf(const GridNeeds& grid) {
  return needed(grid.neededStep, kStep, "sqrt(g/L)", false);
}
std::string lastOf(const GridNeeds& grid) {
  return needed(grid.neededLast, kLast, "sqrt(g/beam)", true);
}

}  // namespace

GridNeeds::GridNeeds(const Coefficients& c) {
  const double g = c.ship.gravity;
  neededStep = kStep * std::sqrt(g / c.ship.length());
  neededLast = kLast * std::sqrt(g / c.ship.beam());
  const std::size_t used = resolvedCount(c);
  last = c.omega[used - 1];
  first = c.omega.front();
  double before = first;
  for (std::size_t i = 1; i < used; ++i) {
    if (!c.masked.empty() && c.masked[i] != 0) continue;
    step = std::max(step, c.omega[i] - before);
    before = c.omega[i];
  }
  const bool ends = c.resolvedOmega > 0.0 && c.omega.back() > c.resolvedOmega * (1.0 + 1e-9);
  leastCount = !ends || used < c.omega.size();
  endsAtPanels = ends;
  if (!leastCount) last = c.resolvedOmega;
}

std::vector<std::string> GridNeeds::advice() const {
  std::vector<std::string> lines;
  if (coarse())
    lines.push_back(
        fmt::format("steps of {:.3g} rad/s are too coarse, {} would do", step, stepOf(*this)));
  if (beginsHigh())
    lines.push_back(fmt::format("the first frequency is {:.3g} rad/s, {} would do", first,
                                needed(2.0 * neededStep, 2.0 * kStep, "sqrt(g/L)", false)));
  if (endsLow() && endsAtPanels)
    lines.push_back(
        fmt::format("the panels resolve waves up to {:.3g} rad/s, {} would do: use a finer mesh",
                    last, lastOf(*this)));
  if (endsLow() && !endsAtPanels)
    lines.push_back(
        fmt::format("the frequencies end at {:.3g} rad/s, {} would do", last, lastOf(*this)));
  return lines;
}

std::vector<Resonance> hinderingResonances(const CoefficientTables& c,
                                           const RetardationMatrix& memory,
                                           const ConsistentLimit& limit, const GridNeeds& grid) {
  if (limit.trusted || !grid.suffices() || !(limit.medianDistance < kLargestMedianDistance))
    return {};
  return resonances(c, memory, limit.median);
}

std::vector<NegativeDamping> negativeDampings(const CoefficientTables& c) {
  std::vector<NegativeDamping> found;
  const std::size_t count = std::min(resolvedCount(c), c.damping.size());
  for (int j = 0; j < 6; ++j) {
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      largest = std::max(largest, std::abs(c.damping[i](j, j)));
    NegativeDamping worst{static_cast<Mode>(j), 0.0, -kNegativeDampingShare};
    for (std::size_t i = 0; i < count && largest > 0.0; ++i)
      if (const double share = c.damping[i](j, j) / largest; share < worst.share)
        worst = {worst.mode, c.omega[i], share};
    if (worst.omega > 0.0) found.push_back(worst);
  }
  return found;
}

std::vector<std::string> dampingWarnings(const CoefficientTables& c) {
  std::vector<std::string> lines;
  for (const NegativeDamping& negative : negativeDampings(c))
    lines.push_back(
        fmt::format("the panels do not carry the damping in {} near {:.3g} rad/s, where it is "
                    "{:.2g} % of its largest: use a finer mesh, or end [solve] omega below that",
                    kModeNames[negative.mode], negative.omega, 100.0 * negative.share));
  return lines;
}

std::vector<std::string> panelWarnings(const Coefficients& c) {
  constexpr double kMostAsymmetry = 0.1;
  std::vector<std::string> lines = dampingWarnings(c);
  std::erase_if(lines, [&](const std::string& line) {
    return c.unfinishedBecause.find(line) != std::string::npos;
  });
  for (const auto& [key, what] :
       {std::pair{"added_mass_asymmetry_resolved", "A"}, {"damping_asymmetry_resolved", "B"}}) {
    // Masked frequencies are asymmetric for another reason.
    const double asymmetry = std::strtod(c.provenance.setting(key).c_str(), nullptr);
    if (asymmetry > kMostAsymmetry && c.masked.empty())
      lines.push_back(
          fmt::format("{} differs from its transpose by {:.2g} %: the panels do not "
                      "carry its couplings, use a finer mesh",
                      what, 100.0 * asymmetry));
  }
  return lines;
}

std::string unfinishedReason(const GridNeeds& grid, const ConsistentLimit& limit,
                             const std::vector<std::string>& damping) {
  std::vector<std::string> lines = grid.advice();
  if (!grid.leastCount) {
    lines.insert(lines.begin(), "the panels resolve fewer than 8 of the frequencies");
  } else if (limit.scatter > 0.0) {
    lines.insert(
        lines.begin(),
        fmt::format("A(inf) from A and B scatters by {:.2g} % (below {:.2g} % is needed) and lies "
                    "{:.2g} % from that of omega = inf (below {:.2g} %)",
                    100.0 * limit.scatter, 100.0 * kLargestScatter, 100.0 * limit.distance,
                    100.0 * kLargestDistance));
  }
  if (!damping.empty()) {
    lines.insert(lines.end(), damping.begin(), damping.end());
  } else if (lines.size() == 1 && grid.leastCount) {
    lines.push_back(
        fmt::format("damping has peaks narrower than the steps of {:.3g} rad/s: try smaller "
                    "ones, and a lid or a mask if the resonances are inside the hull",
                    grid.step));
  }
  return fmt::format("{}", fmt::join(lines, "; "));
}

std::string singleFrequencyReason(const GridNeeds& grid) {
  return fmt::format("one frequency makes no memory; steps of {} up to {} would do", stepOf(grid),
                     lastOf(grid));
}

}  // namespace cutwater
