#include "hydro/memory/MiddleBand.h"

#include "hydro/database/Interpolation.h"

namespace cutwater {

namespace {

constexpr double kBandStart = 0.3, kBandEnd = 0.6;  // of the last frequency used

}  // namespace

std::vector<Mat6> overMiddleBand(const CoefficientTables& c,
                                 const std::function<Mat6(std::size_t frequency)>& value) {
  const double last = c.omega[resolvedCount(c) - 1];
  std::vector<Mat6> values;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (c.omega[i] < kBandStart * last || c.omega[i] > kBandEnd * last) continue;
    values.push_back(value(i));
  }
  return values;
}

}  // namespace cutwater
