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

/// How many of the frequencies the panels resolve (Coefficients::resolvedOmega); those above are
/// neither interpolated nor transformed. All of them if that is not known or would leave fewer than
/// eight.
std::size_t resolvedCount(const CoefficientTables& coefficients);

/// A(ω) at any ω ≥ 0 [rad/s], ω = ∞ included: local cubic through A(0) and the data; beyond the
/// last frequency Ω the limit is approached as A(∞) + (A(Ω) − A(∞))(Ω/ω)², since A(ω) − A(∞) falls
/// as −K(0)/ω².
/// @throws HydroError ValueOutOfRange (ω < 0 or NaN; of a database with one frequency any ω but
///         that, 0 and ∞), DatabaseIncomplete (no frequencies).
Mat6 addedMassAt(const CoefficientTables& coefficients, double omega);

/// B(ω) at any ω ≥ 0: ω times a local cubic of B/ω through 0 at ω = 0, as B vanishes faster than ω
/// and forward speed divides it by ω; beyond Ω it falls as (Ω/ω)³.
/// @throws as addedMassAt.
Mat6 dampingAt(const CoefficientTables& coefficients, double omega);

/// ∂A(ω) and ∂B(ω) at any ω ≥ 0, as A and B: ∂A through ∂A(0), ∂B as B. Unless `finish`
/// (finish/Finish.h) has continued them, Ω is here the last frequency that the panels resolve:
/// beyond it the solver's values oscillate from one frequency to the next.
/// @throws as addedMassAt; DatabaseIncomplete if the database holds no x-derivatives.
Mat6 addedMassXAt(const CoefficientTables& coefficients, double omega);
Mat6 dampingXAt(const CoefficientTables& coefficients, double omega);

/// Adjoint vectors b_j of F^ω at ω ≥ 0, 6 × panels (Coefficients::adjoint): local cubic through
/// b(0) and the data up to Ω, the last frequency that the panels resolve; beyond it
/// b(∞) + (b(Ω) − b(∞))(Ω/ω)². Without b(0) the first vectors are held below their frequency.
/// @throws HydroError ValueOutOfRange (ω < 0, NaN; beyond the last frequency without b(∞)),
///         DatabaseIncomplete (none in the database).
CoefficientTables::AdjointVectors adjointAt(const CoefficientTables& coefficients, double omega);

/// b^x_j of F^U, likewise (Coefficients::adjointX).
CoefficientTables::AdjointVectors adjointXAt(const CoefficientTables& coefficients, double omega);

}  // namespace cutwater
