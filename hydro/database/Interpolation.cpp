#include "hydro/database/Interpolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

void checkOmega(const char* function, const Coefficients& c, double omega) {
  if (c.omega.empty()) {
    throw HydroError(Fault::DatabaseIncomplete, fmt::format("{}: no frequencies", function));
  }
  if (!(omega >= 0.0)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, must be >= 0", function, omega));
  }
}

/// Local cubic through `zero` at ω = 0 and the data.
Mat6 fromZero(const Coefficients& c, const Mat6& zero, const std::vector<Mat6>& data,
              double omega) {
  std::vector<double> nodes(1, 0.0);
  nodes.insert(nodes.end(), c.omega.begin(), c.omega.end());
  const LocalCubic local = localCubic(nodes, omega);
  Mat6 sum = Mat6::Zero();
  for (std::size_t i = 0; i < local.count; ++i) {
    const std::size_t node = local.first + i;
    sum += local.weight[i] * (node == 0 ? zero : data[node - 1]);
  }
  return sum;
}

}  // namespace

LocalCubic localCubic(std::span<const double> nodes, double x) {
  LocalCubic local;
  local.count = std::min<std::size_t>(4, nodes.size());
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  const auto right = static_cast<std::size_t>(above - nodes.begin());  // nodes ≤ x
  const std::size_t latest = nodes.size() - local.count;
  local.first = std::min(latest, right < 2 ? 0 : right - 2);
  for (std::size_t i = 0; i < local.count; ++i) {
    const double node = nodes[local.first + i];
    double weight = 1.0;
    for (std::size_t j = 0; j < local.count; ++j) {
      const double other = nodes[local.first + j];
      if (j != i) weight *= (x - other) / (node - other);
    }
    local.weight[i] = weight;
  }
  return local;
}

Mat6 addedMassAt(const Coefficients& c, double omega) {
  checkOmega("addedMassAt", c, omega);
  const double last = c.omega.back(), u = last / omega;
  if (omega <= last) return fromZero(c, c.addedMassZero, c.addedMass, omega);
  return c.addedMassInf + u * u * (c.addedMass.back() - c.addedMassInf);
}

Mat6 dampingAt(const Coefficients& c, double omega) {
  checkOmega("dampingAt", c, omega);
  const double last = c.omega.back(), u = last / omega;
  if (omega <= last) return fromZero(c, Mat6::Zero(), c.damping, omega);
  return u * u * u * c.damping.back();
}

Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointAt(const Coefficients& c, double omega) {
  checkOmega("adjointAt", c, omega);
  if (c.adjoint.empty()) {
    throw HydroError(Fault::DatabaseIncomplete, "adjointAt: the database holds no adjoint vectors");
  }
  if (omega < c.omega.front() || omega > c.omega.back()) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("adjointAt: omega = {} rad/s, the database holds {} to {}", omega,
                                 c.omega.front(), c.omega.back()));
  }
  const LocalCubic local = localCubic(c.omega, omega);
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> sum = local.weight[0] * c.adjoint[local.first];
  for (std::size_t i = 1; i < local.count; ++i) {
    sum += local.weight[i] * c.adjoint[local.first + i];
  }
  return sum;
}

}  // namespace cutwater
