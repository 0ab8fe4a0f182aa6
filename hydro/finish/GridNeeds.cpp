#include "hydro/finish/GridNeeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/database/Interpolation.h"

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

std::optional<NegativeDamping> negativeDamping(const CoefficientTables& c) {
  constexpr double kRoundOff = -0.01;
  std::optional<NegativeDamping> worst;
  for (int j = 0; j < 6; ++j) {
    double largest = 0.0;
    for (std::size_t i = 0; i < resolvedCount(c); ++i)
      largest = std::max(largest, std::abs(c.damping[i](j, j)));
    for (std::size_t i = 0; i < resolvedCount(c); ++i) {
      const double share = largest > 0.0 ? c.damping[i](j, j) / largest : 0.0;
      if (share < (worst ? worst->share : kRoundOff))
        worst = NegativeDamping{static_cast<Mode>(j), c.omega[i], share};
    }
  }
  return worst;
}

std::string unfinishedReason(const GridNeeds& grid, const ConsistentLimit& limit,
                             const std::optional<NegativeDamping>& negative) {
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
  if (negative) {
    lines.push_back(
        fmt::format("damping in {} is {:.2g} % of its largest at {:.3g} rad/s, though "
                    "no ship's is negative: use a finer mesh, or a mask",
                    kModeNames[negative->mode], 100.0 * negative->share, negative->omega));
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
