#pragma once
#include <array>
#include <span>

#include "hydro/database/Coefficients.h"

namespace cutwater {

/// Cubic Lagrange interpolation through the four nodes around a point (fewer if there are fewer):
/// exact for cubics, error O(Δω⁴), continuous, and equal to the data at the nodes.
struct LocalCubic {
  std::size_t first = 0;           ///< index of the first node used
  std::size_t count = 0;           ///< 1..4
  std::array<double, 4> weight{};  ///< value = Σ weight[i] data[first + i]
};
/// @param nodes strictly increasing, not empty.  @param x within [nodes.front(), nodes.back()].
LocalCubic localCubic(std::span<const double> nodes, double x);

/// A(ω) at any ω ≥ 0 [rad/s], ω = ∞ included: local cubic through A(0) and the data; beyond the
/// last frequency Ω the limit is approached as A(∞) + (A(Ω) − A(∞))(Ω/ω)², since A(ω) −
/// A(∞) falls as −K(0)/ω².
/// @throws HydroError ValueOutOfRange (ω < 0 or NaN), DatabaseIncomplete (no frequencies).
Mat6 addedMassAt(const Coefficients& coefficients, double omega);

/// B(ω) at any ω ≥ 0: local cubic through B(0) = 0 and the data; beyond Ω it falls as (Ω/ω)³.
/// @throws as addedMassAt.
Mat6 dampingAt(const Coefficients& coefficients, double omega);

/// Adjoint vectors b_j at ω, 6 × panels (Coefficients::adjoint), by local cubic in ω.
/// @param omega within the range of the data: b_j is not extrapolated.
/// @throws HydroError ValueOutOfRange, DatabaseIncomplete (none in the database).
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointAt(const Coefficients& coefficients, double omega);

}  // namespace cutwater
