#include "hydro/database/Interpolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

using Adjoint = CoefficientTables::AdjointVectors;

void checkOmega(const char* function, const CoefficientTables& c, double omega) {
  if (c.omega.empty()) {
    throw HydroError(Fault::DatabaseIncomplete, fmt::format("{}: no frequencies", function));
  }
  if (!(omega >= 0.0)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, must be >= 0", function, omega));
  }
  const bool limit = omega == 0.0 || std::isinf(omega);
  if (c.omega.size() == 1 && !limit && std::abs(omega - c.omega.front()) > 1e-9 * omega) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, the database holds one frequency, {}",
                                 function, omega, c.omega.front()));
  }
}

void requireData(const char* function, const CoefficientTables& c, std::size_t count,
                 const char* what) {
  if (count == c.omega.size()) return;
  throw HydroError(Fault::DatabaseIncomplete,
                   fmt::format("{}: the database holds no {}", function, what));
}

/// What a quantity does at both ends of the data.
enum class Ends {
  Limits,  ///< goes to its values at ω = 0 and ω = ∞, the latter as (Ω/ω)²
  Vanish   ///< vanishes at ω = 0 faster than ω, and beyond Ω as (Ω/ω)³
};

/// Beyond the last frequency Ω in use; u = Ω/ω < 1.
template <class T>
T beyond(const T& last, const OverFrequency<T>& quantity, double u, Ends ends) {
  if (ends == Ends::Vanish) return u * u * u * last;
  return quantity.atInfinity + u * u * (last - quantity.atInfinity);
}

/// The one interpolation: local cubic of the quantity (Ends::Vanish: of it over ω) through its
/// limit at ω = 0, if it is known, and its values at the first `count` frequencies.
template <class T>
T interpolated(const CoefficientTables& c, const OverFrequency<T>& quantity, Ends ends,
               std::size_t count, double omega) {
  const double last = c.omega[count - 1];
  if (omega > last) return beyond(quantity[count - 1], quantity, last / omega, ends);
  const std::size_t limits = quantity.atZero.size() > 0 ? 1 : 0;
  std::vector<double> nodes(limits, 0.0);
  nodes.insert(nodes.end(), c.omega.begin(), c.omega.begin() + static_cast<std::ptrdiff_t>(count));
  const LocalCubic local = localCubic(nodes, std::max(omega, nodes.front()));
  const T& any = quantity.values.front();
  T sum = T::Zero(any.rows(), any.cols());
  for (std::size_t i = 0; i < local.count; ++i) {
    const std::size_t node = local.first + i;
    const double weight = local.weight[i];
    if (node < limits) {
      if (ends == Ends::Limits) sum += weight * quantity.atZero;
    } else {
      const double share = ends == Ends::Vanish ? weight * (omega / nodes[node]) : weight;
      sum += share * quantity[node - limits];
    }
  }
  return sum;
}

/// How many of ∂A, ∂B are good: all once they are continued, which goes with a consistent A(∞).
std::size_t goodCountX(const CoefficientTables& c) {
  return c.hasConsistentLimit() ? c.omega.size() : resolvedCount(c);
}

Adjoint vectorsAt(const char* function, const CoefficientTables& c,
                  const OverFrequency<Adjoint>& vectors, double omega) {
  if (vectors.atInfinity.cols() > 0)
    return interpolated(c, vectors, Ends::Limits, resolvedCount(c), omega);
  const double last = c.omega.back();
  if (omega > last * (1.0 + 1e-9)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: omega = {} rad/s, the database ends at {} and holds no "
                                 "vectors of omega = inf",
                                 function, omega, last));
  }
  return interpolated(c, vectors, Ends::Limits, c.omega.size(), std::min(omega, last));
}

}  // namespace

std::size_t resolvedCount(const CoefficientTables& c) {
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

Mat6 addedMassAt(const CoefficientTables& c, double omega) {
  checkOmega("addedMassAt", c, omega);
  return interpolated(c, c.addedMass, Ends::Limits, c.omega.size(), omega);
}

Mat6 dampingAt(const CoefficientTables& c, double omega) {
  checkOmega("dampingAt", c, omega);
  return interpolated(c, c.damping, Ends::Vanish, c.omega.size(), omega);
}

Mat6 addedMassXAt(const CoefficientTables& c, double omega) {
  checkOmega("addedMassXAt", c, omega);
  requireData("addedMassXAt", c, c.addedMassX.size(), "x-derivatives (added_mass_x)");
  return interpolated(c, c.addedMassX, Ends::Limits, goodCountX(c), omega);
}

Mat6 dampingXAt(const CoefficientTables& c, double omega) {
  checkOmega("dampingXAt", c, omega);
  requireData("dampingXAt", c, c.dampingX.size(), "x-derivatives (damping_x)");
  return interpolated(c, c.dampingX, Ends::Vanish, goodCountX(c), omega);
}

CoefficientTables::AdjointVectors adjointAt(const CoefficientTables& c, double omega) {
  checkOmega("adjointAt", c, omega);
  requireData("adjointAt", c, c.adjoint.size(), "adjoint vectors (adjoint)");
  return vectorsAt("adjointAt", c, c.adjoint, omega);
}

CoefficientTables::AdjointVectors adjointXAt(const CoefficientTables& c, double omega) {
  checkOmega("adjointXAt", c, omega);
  requireData("adjointXAt", c, c.adjointX.size(), "adjoint vectors of d/dx (adjoint_x)");
  return vectorsAt("adjointXAt", c, c.adjointX, omega);
}

}  // namespace cutwater
