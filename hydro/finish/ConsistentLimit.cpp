#include "hydro/finish/ConsistentLimit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/database/Interpolation.h"
#include "hydro/database/IrregularFrequencies.h"

namespace cutwater {

namespace {

constexpr double kBandStart = 0.3, kBandEnd = 0.6;        // of the last frequency used
constexpr double kToDampingX = 0.5, kFromDampingX = 0.8;  // of the same: ∂A becomes ∂B's
constexpr double kLargestScatter = 0.02, kLargestDistance = 0.1;

double largest(const Mat6& difference, const Vec6& size) {
  return difference.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff();
}

/// √A_jj, but not less than a trifle of the translations', so that a mode without added mass (the yaw
/// of a body of revolution) does not make round-off look significant.
Vec6 sizeOf(const Mat6& addedMass, double volume) {
  const double length = std::cbrt(std::max(volume, 1e-12));
  const double least = 1e-6 * addedMass.diagonal().head<3>().maxCoeff();
  Vec6 size = addedMass.diagonal();
  size.head<3>() = size.head<3>().cwiseMax(least);
  size.tail<3>() = size.tail<3>().cwiseMax(least * length * length);
  return size.cwiseSqrt();
}

/// The ω = ∞ solution itself, whether or not the consistent value has taken its place.
Mat6 directLimit(const Coefficients& c) {
  const Mat6& direct = c.hasConsistentLimit() ? c.addedMassInfDirect : c.addedMass.atInfinity;
  return 0.5 * (direct + direct.transpose());
}

std::vector<Mat6> overBand(const Coefficients& c,
                           const std::function<Mat6(std::size_t frequency)>& value) {
  const double last = c.omega[resolvedCount(c) - 1];
  std::vector<Mat6> values;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (c.omega[i] < kBandStart * last || c.omega[i] > kBandEnd * last) continue;
    values.push_back(value(i));
  }
  return values;
}

/// @param memory  of `c`.
ConsistentLimit limitOf(const Coefficients& c, const RetardationMatrix& memory) {
  const std::vector<Mat6> values =
      overBand(c, [&](std::size_t i) { return memory.addedMassInf(c.omega[i], c.addedMass[i]); });
  ConsistentLimit limit;
  const Mat6 direct = directLimit(c);
  if (values.empty() || !(direct.diagonal().head<3>().maxCoeff() > 0.0)) return limit;
  for (const Mat6& value : values) limit.addedMassInf += value / static_cast<double>(values.size());
  const Vec6 size = sizeOf(direct, c.ship.volume);
  for (const Mat6& value : values) {
    limit.scatter = std::max(limit.scatter, largest(value - limit.addedMassInf, size));
  }
  limit.distance = largest(direct - limit.addedMassInf, size);
  limit.trusted = limit.scatter < kLargestScatter && limit.distance < kLargestDistance;
  return limit;
}

}  // namespace

std::optional<Mat6> meanOverBand(const Coefficients& c,
                                 const std::function<Mat6(std::size_t frequency)>& value) {
  const std::vector<Mat6> values = overBand(c, value);
  if (values.empty()) return {};
  Mat6 sum = Mat6::Zero();
  for (const Mat6& one : values) sum += one;
  return sum / static_cast<double>(values.size());
}

ConsistentLimit consistentLimit(const Coefficients& c) { return limitOf(c, RetardationMatrix(c)); }

namespace {

/// B, A, ∂B above the last frequency that the panels resolve, and ∂A from 0.5 of it on, become the memory's.
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

Coefficients withConsistentLimit(Coefficients coefficients) {
  // K, D and ∂A(∞) come from B, ∂A and ∂B alone: the new A(∞) does not change them.
  const RetardationMatrix memory(coefficients, ForwardSpeedForm::Report);
  const ConsistentLimit limit = limitOf(coefficients, memory);
  if (!limit.trusted) return coefficients;
  if (!coefficients.hasConsistentLimit())
    coefficients.addedMassInfDirect = coefficients.addedMass.atInfinity;
  coefficients.addedMass.atInfinity = limit.addedMassInf;
  continueAbove(coefficients, memory);
  if (memory.hasSpeedTerms()) coefficients.addedMassX.atInfinity = memory.addedMassXInf();
  return coefficients;
}

double asymmetry(const OverFrequency<Mat6>& table) {
  Mat6 scale = Mat6::Zero(), worst = Mat6::Zero();
  for (const Mat6& m : table) {
    const Vec6 size = m.diagonal().cwiseAbs().cwiseSqrt();
    scale = scale.cwiseMax(size * size.transpose());
    worst = worst.cwiseMax((m - m.transpose()).cwiseAbs());
  }
  return (scale.array() > 0.0).select(worst.cwiseQuotient(scale), Mat6::Zero()).maxCoeff();
}

Coefficients readyForUse(Coefficients solved) {
  solved.provenance.settings +=
      fmt::format("added_mass_asymmetry = {:.3g}\ndamping_asymmetry = {:.3g}\n",
                  asymmetry(solved.addedMass), asymmetry(solved.damping));
  for (auto* matrices : {&solved.addedMass, &solved.damping}) {
    for (Mat6& m : *matrices) m = (0.5 * (m + m.transpose())).eval();
  }
  return withConsistentLimit(applyMask(std::move(solved)));
}

}  // namespace cutwater
