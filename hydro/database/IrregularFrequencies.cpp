#include "hydro/database/IrregularFrequencies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

using Envelope = std::vector<std::pair<double, double>>;

void checkEnvelope(const char* name, const Envelope& envelope) {
  for (std::size_t i = 0; i < envelope.size(); ++i) {
    const auto [omega, limit] = envelope[i];
    if (!(omega >= 0.0) || !std::isfinite(omega) || !(limit > 0.0)) {
      throw HydroError(
          Fault::ValueOutOfRange,
          fmt::format(
              "irregularFrequencies: {}[{}] = [{}, {}]: omega >= 0 and a limit > 0 are needed",
              name, i, omega, limit));
    }
    if (i > 0 && omega <= envelope[i - 1].first) {
      throw HydroError(Fault::FrequenciesNotIncreasing,
                       fmt::format("irregularFrequencies: {}[{}]: omega = {} rad/s after {}", name,
                                   i, omega, envelope[i - 1].first));
    }
  }
}

}  // namespace

double conditionLimitAt(const Envelope& envelope, double omega) {
  if (envelope.empty()) return std::numeric_limits<double>::infinity();
  const auto above = std::upper_bound(envelope.begin(), envelope.end(), omega,
                                      [](double x, const auto& point) { return x < point.first; });
  if (above == envelope.begin()) return envelope.front().second;
  if (above == envelope.end()) return envelope.back().second;
  const auto &left = *(above - 1), &right = *above;
  const double share = (omega - left.first) / (right.first - left.first);
  return left.second + share * (right.second - left.second);
}

std::vector<int> irregularFrequencies(const CoefficientTables& c) {
  checkEnvelope("condition_limit_even", c.conditionLimitEven);
  checkEnvelope("condition_limit_odd", c.conditionLimitOdd);
  if (c.conditionLimitEven.empty() && c.conditionLimitOdd.empty()) return c.masked;
  std::vector<int> masked(c.omega.size(), 0);
  const auto mark = [&](const std::vector<double>& condition, const Envelope& envelope) {
    for (std::size_t i = 0; i < condition.size(); ++i) {
      if (!(condition[i] <= conditionLimitAt(envelope, c.omega[i]))) masked[i] = 1;
    }
  };
  mark(c.conditionEven, c.conditionLimitEven);
  mark(c.conditionOdd, c.conditionLimitOdd);
  return masked;
}

}  // namespace cutwater
