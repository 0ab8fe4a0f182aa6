#include "hydro/finish/ConsistentLimit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/database/Interpolation.h"
#include "hydro/memory/MiddleBand.h"

namespace cutwater {

namespace {

constexpr double kToDampingX = 0.5,
                 kFromDampingX = 0.8;  // of the last frequency used: ∂A becomes ∂B's

double largest(const Mat6& difference, const Vec6& size) {
  return difference.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff();
}

/// √A_jj, but not less than a trifle of the translations', so that a mode without added mass (the
/// yaw of a body of revolution) does not make round-off look significant.
Vec6 sizeOf(const Mat6& addedMass, double volume) {
  const double length = std::cbrt(std::max(volume, 1e-12));
  const double least = 1e-6 * addedMass.diagonal().head<3>().maxCoeff();
  Vec6 size = addedMass.diagonal();
  size.head<3>() = size.head<3>().cwiseMax(least);
  size.tail<3>() = size.tail<3>().cwiseMax(least * length * length);
  return size.cwiseSqrt();
}

/// Of each entry by itself.
Mat6 medianOf(const std::vector<Mat6>& values) {
  Mat6 median = Mat6::Zero();
  std::vector<double> sorted(values.size());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  for (int n = 0; n < 36; ++n) {
    std::transform(values.begin(), values.end(), sorted.begin(),
                   [n](const Mat6& value) { return value(n / 6, n % 6); });
    std::nth_element(sorted.begin(), middle, sorted.end());
    median(n / 6, n % 6) = *middle;
  }
  return median;
}

/// A(∞) from each of the frequencies that the memory uses.
std::vector<Mat6> limitsOf(const Coefficients& c, const RetardationMatrix& memory) {
  std::vector<Mat6> values;
  for (std::size_t i = 0; i < resolvedCount(c); ++i)
    values.push_back(memory.addedMassInf(c.omega[i], c.addedMass[i]));
  return values;
}

/// B, A, ∂B above the last frequency that the panels resolve, and ∂A from 0.5 of it on, become the
/// memory's.
void continueAbove(Coefficients& c, const RetardationMatrix& memory) {
  const std::size_t resolved = resolvedCount(c);
  const double last = c.omega[resolved - 1];
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    const double omega = c.omega[i];
    if (memory.hasSpeedTerms() && omega > kToDampingX * last) {
      const double share =
          std::min(1.0, (omega / last - kToDampingX) / (kFromDampingX - kToDampingX));
      c.addedMassX[i] += share * (memory.addedMassX(omega) - c.addedMassX[i]);
    }
    if (i < resolved) continue;
    c.damping[i] = memory.damping(omega);
    c.addedMass[i] = c.addedMass.atInfinity - memory.sineTransform(omega) / omega;
    if (memory.hasSpeedTerms()) c.dampingX[i] = memory.dampingX(omega);
  }
}

}  // namespace

ConsistentLimit consistentLimit(const Coefficients& c, const RetardationMatrix& memory) {
  const std::vector<Mat6> values = overMiddleBand(
      c, [&](std::size_t i) { return memory.addedMassInf(c.omega[i], c.addedMass[i]); });
  ConsistentLimit limit;
  const Mat6 direct = 0.5 * (c.addedMass.atInfinity + c.addedMass.atInfinity.transpose());
  if (values.empty() || !(direct.diagonal().head<3>().maxCoeff() > 0.0)) return limit;
  for (const Mat6& value : values) limit.addedMassInf += value / static_cast<double>(values.size());
  const Vec6 size = sizeOf(direct, c.ship.volume);
  for (const Mat6& value : values) {
    limit.scatter = std::max(limit.scatter, largest(value - limit.addedMassInf, size));
  }
  limit.distance = largest(direct - limit.addedMassInf, size);
  limit.trusted = limit.scatter < kLargestScatter && limit.distance < kLargestDistance;
  if (limit.trusted) return limit;
  limit.median = medianOf(limitsOf(c, memory));
  limit.medianDistance = largest(direct - limit.median, size);
  return limit;
}

void continueConsistently(Coefficients& c, const RetardationMatrix& memory,
                          const Mat6& addedMassInf) {
  c.addedMassInfDirect = c.addedMass.atInfinity;
  c.addedMass.atInfinity = addedMassInf;
  continueAbove(c, memory);
  if (memory.hasSpeedTerms()) c.addedMassX.atInfinity = memory.addedMassXInf();
}

}  // namespace cutwater
