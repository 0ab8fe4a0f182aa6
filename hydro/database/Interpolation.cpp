#include "hydro/database/Interpolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

using Adjoint = Coefficients::AdjointVectors;

void checkOmega(const char* function, const Coefficients& c, double omega) {
  if (c.omega.empty()) {
    throw HydroError(Fault::DatabaseIncomplete, fmt::format("{}: no frequencies", function));
  }
  if (!(omega >= 0.0)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, must be >= 0", function, omega));
  }
}

void requireData(const char* function, const Coefficients& c, std::size_t count, const char* what) {
  if (count == c.omega.size()) return;
  throw HydroError(Fault::DatabaseIncomplete,
                   fmt::format("{}: the database holds no {}", function, what));
}

std::vector<double> nodesFromZero(const Coefficients& c, std::size_t count) {
  std::vector<double> nodes(1, 0.0);
  nodes.insert(nodes.end(), c.omega.begin(), c.omega.begin() + static_cast<std::ptrdiff_t>(count));
  return nodes;
}

/// Local cubic through `zero` at ω = 0 and the first `count` data.
template <class Matrix>
Matrix fromZero(const Coefficients& c, const Matrix& zero, const std::vector<Matrix>& data,
                std::size_t count, double omega) {
  const LocalCubic local = localCubic(nodesFromZero(c, count), omega);
  Matrix sum = Matrix::Zero(zero.rows(), zero.cols());
  for (std::size_t i = 0; i < local.count; ++i) {
    const std::size_t node = local.first + i;
    sum += local.weight[i] * (node == 0 ? zero : data[node - 1]);
  }
  return sum;
}

/// The same with the approach to `inf` beyond the last of `count` frequencies.
template <class Matrix>
Matrix toInfinity(const Coefficients& c, const Matrix& zero, const std::vector<Matrix>& data,
                  const Matrix& inf, std::size_t count, double omega) {
  const double last = c.omega[count - 1], u = last / omega;
  if (omega <= last) return fromZero(c, zero, data, count, omega);
  return inf + u * u * (data[count - 1] - inf);
}

/// ω times a local cubic of data/ω through 0 at ω = 0; (Ω/ω)³ beyond the last of `count` frequencies.
Mat6 vanishing(const Coefficients& c, const std::vector<Mat6>& data, std::size_t count,
               double omega) {
  const double last = c.omega[count - 1], u = last / omega;
  if (omega > last) return u * u * u * data[count - 1];
  const std::vector<double> nodes = nodesFromZero(c, count);
  const LocalCubic local = localCubic(nodes, omega);
  Mat6 sum = Mat6::Zero();
  for (std::size_t i = 0; i < local.count; ++i) {
    const std::size_t node = local.first + i;
    if (node > 0) sum += local.weight[i] * (omega / nodes[node]) * data[node - 1];
  }
  return sum;
}

/// How many of ∂A, ∂B are good: all once they are continued, which goes with a consistent A(∞).
std::size_t goodCountX(const Coefficients& c) {
  return c.hasConsistentLimit() ? c.omega.size() : resolvedCount(c);
}

Adjoint vectorsAt(const char* function, const Coefficients& c, const std::vector<Adjoint>& data,
                  const Adjoint& zero, const Adjoint& inf, double omega) {
  const std::size_t count = inf.cols() > 0 ? resolvedCount(c) : c.omega.size();
  const double last = c.omega[count - 1];
  if (inf.cols() == 0 && omega > last * (1.0 + 1e-9)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, the database ends at {} and holds no "
                                 "vectors of omega = inf",
                                 function, omega, last));
  }
  const double within = inf.cols() == 0 ? std::min(omega, last) : omega;
  if (zero.cols() > 0) {
    if (inf.cols() == 0) return fromZero(c, zero, data, count, within);
    return toInfinity(c, zero, data, inf, count, within);
  }
  if (within > last) return inf + last / within * (last / within) * (data[count - 1] - inf);
  const std::span<const double> nodes(c.omega.data(), count);
  const LocalCubic local = localCubic(nodes, std::max(within, nodes.front()));
  Adjoint sum = local.weight[0] * data[local.first];
  for (std::size_t i = 1; i < local.count; ++i) sum += local.weight[i] * data[local.first + i];
  return sum;
}

}  // namespace

std::size_t resolvedCount(const Coefficients& c) {
  if (!(c.resolvedOmega > 0.0)) return c.omega.size();
  constexpr std::ptrdiff_t kLeast = 8;
  const auto end = std::upper_bound(c.omega.begin(), c.omega.end(), c.resolvedOmega * (1.0 + 1e-9));
  const auto count = end - c.omega.begin();
  return count >= kLeast ? static_cast<std::size_t>(count) : c.omega.size();
}

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
  return toInfinity(c, c.addedMassZero, c.addedMass, c.addedMassInf, c.omega.size(), omega);
}

Mat6 dampingAt(const Coefficients& c, double omega) {
  checkOmega("dampingAt", c, omega);
  return vanishing(c, c.damping, c.omega.size(), omega);
}

Mat6 addedMassXAt(const Coefficients& c, double omega) {
  checkOmega("addedMassXAt", c, omega);
  requireData("addedMassXAt", c, c.addedMassX.size(), "x-derivatives (added_mass_x)");
  return toInfinity(c, c.addedMassXZero, c.addedMassX, c.addedMassXInf, goodCountX(c), omega);
}

Mat6 dampingXAt(const Coefficients& c, double omega) {
  checkOmega("dampingXAt", c, omega);
  requireData("dampingXAt", c, c.dampingX.size(), "x-derivatives (damping_x)");
  return vanishing(c, c.dampingX, goodCountX(c), omega);
}

Coefficients::AdjointVectors adjointAt(const Coefficients& c, double omega) {
  checkOmega("adjointAt", c, omega);
  requireData("adjointAt", c, c.adjoint.size(), "adjoint vectors (adjoint)");
  return vectorsAt("adjointAt", c, c.adjoint, c.adjointZero, c.adjointInf, omega);
}

Coefficients::AdjointVectors adjointXAt(const Coefficients& c, double omega) {
  checkOmega("adjointXAt", c, omega);
  requireData("adjointXAt", c, c.adjointX.size(), "adjoint vectors of d/dx (adjoint_x)");
  return vectorsAt("adjointXAt", c, c.adjointX, c.adjointXZero, c.adjointXInf, omega);
}

}  // namespace cutwater
