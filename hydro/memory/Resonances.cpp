#include "hydro/memory/Resonances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/database/Interpolation.h"

namespace cutwater {

namespace {

constexpr double kFarOff = 0.2;  // of A(∞)
constexpr double kPeak = 2.0;    // of B two steps away

/// Where B_jj is a peak of one or two steps, among the first `count` frequencies.
std::vector<std::size_t> narrowPeaks(const CoefficientTables& c, std::size_t count, int j) {
  const auto B = [&](std::size_t n) { return c.damping[n](j, j); };
  std::vector<std::size_t> peaks;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const std::size_t low = std::max<std::size_t>(i, 2) - 2, high = std::min(i + 2, count - 1);
    if (B(i) >= B(i - 1) && B(i) > B(i + 1) && B(i) > kPeak * std::max({B(low), B(high), 0.0}))
      peaks.push_back(i);
  }
  return peaks;
}

}  // namespace

std::vector<Resonance> resonances(const CoefficientTables& c, const RetardationMatrix& memory,
                                  const Mat6& addedMassInf) {
  const std::size_t count = std::min(resolvedCount(c), c.damping.size());
  std::vector<Vec6> off;
  for (std::size_t i = 0; i < count; ++i) {
    const Mat6 limit = memory.addedMassInf(c.omega[i], c.addedMass[i]);
    off.push_back((limit - addedMassInf).diagonal().cwiseAbs());
  }
  std::vector<Resonance> found;
  for (int j = 0; j < 6; ++j) {
    for (const std::size_t i : narrowPeaks(c, count, j)) {
      const double largest = std::max({off[i - 1][j], off[i][j], off[i + 1][j]});
      if (largest > kFarOff * addedMassInf(j, j) && addedMassInf(j, j) > 0.0)
        found.push_back({static_cast<Mode>(j), c.omega[i]});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Resonance& a, const Resonance& b) { return a.omega < b.omega; });
  return found;
}

std::string listed(const std::vector<Resonance>& resonances) {
  std::string text;
  for (std::size_t i = 0; i < resonances.size(); ++i) {
    const bool same = i > 0 && resonances[i].omega == resonances[i - 1].omega;
    if (!same) text += fmt::format("{}{:.3g} (", i > 0 ? "), " : "", resonances[i].omega);
    text += fmt::format("{}{}", same ? ", " : "", kModeNames[resonances[i].mode]);
  }
  return text.empty() ? "" : text + ")";
}

std::string resonanceWarning(const Coefficients& c) {
  if (c.status != CoefficientStatus::Finished) return {};
  const std::string places = listed(resonances(c, RetardationMatrix(c), c.addedMass.atInfinity));
  if (places.empty()) return {};
  return fmt::format(
      "the water resonates in peaks narrower than the steps of the frequency grid, at {} rad/s; "
      "near these frequencies motions in the time domain are not right",
      places);
}

}  // namespace cutwater
