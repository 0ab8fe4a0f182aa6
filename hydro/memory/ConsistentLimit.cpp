#include "hydro/memory/ConsistentLimit.h"

#include <algorithm>
#include <vector>

namespace cutwater {

namespace {

constexpr double kBandStart = 0.3, kBandEnd = 0.6;  // of the last frequency used
constexpr double kLargestScatter = 0.02, kLargestDistance = 0.1;

double largest(const Mat6& difference, const Vec6& size) {
  return difference.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff();
}

}  // namespace

ConsistentLimit consistentLimit(const Coefficients& c) {
  const RetardationMatrix memory(c);
  double last = c.omega.back();
  if (c.resolvedOmega > 0.0) last = std::min(last, c.resolvedOmega);
  std::vector<Mat6> values;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (c.omega[i] < kBandStart * last || c.omega[i] > kBandEnd * last) continue;
    values.push_back(memory.addedMassInf(c.omega[i], c.addedMass[i]));
  }
  ConsistentLimit limit;
  const Mat6 direct = 0.5 * (c.addedMassInf + c.addedMassInf.transpose());
  if (values.empty() || !(direct.diagonal().minCoeff() > 0.0)) return limit;
  for (const Mat6& value : values) limit.addedMassInf += value / static_cast<double>(values.size());
  const Vec6 size = direct.diagonal().cwiseSqrt();
  for (const Mat6& value : values) {
    limit.scatter = std::max(limit.scatter, largest(value - limit.addedMassInf, size));
  }
  limit.distance = largest(direct - limit.addedMassInf, size);
  limit.trusted = limit.scatter < kLargestScatter && limit.distance < kLargestDistance;
  return limit;
}

Coefficients withConsistentLimit(Coefficients coefficients) {
  const ConsistentLimit limit = consistentLimit(coefficients);
  if (!limit.trusted) return coefficients;
  coefficients.addedMassInfDirect = coefficients.addedMassInf;
  coefficients.addedMassInf = limit.addedMassInf;
  if (coefficients.resolvedOmega <= 0.0) return coefficients;
  const RetardationMatrix memory(coefficients);
  for (std::size_t i = 0; i < coefficients.omega.size(); ++i) {
    const double omega = coefficients.omega[i];
    if (omega <= coefficients.resolvedOmega) continue;
    coefficients.damping[i] = memory.damping(omega);
    coefficients.addedMass[i] = limit.addedMassInf - memory.sineTransform(omega) / omega;
  }
  return coefficients;
}

}  // namespace cutwater
