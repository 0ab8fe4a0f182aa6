#pragma once
#include "hydro/Conventions.h"

namespace cutwater {

/// What the water adds to an ellipsoid that moves in it, far from any surface [Lamb32], §§ 114,
/// 115.
///     const EllipsoidMass water = ellipsoidMass({1.0, 1.0, 1.0}, 1025.0);  // linear: ½ρV
/// With α_i = abc ∫_0^∞ dλ/((a_i² + λ)Δ), Δ² = Π(a_j² + λ), so that Σα = 2, and V = 4πabc/3,
///     along i:   ρV α_i/(2 − α_i)
///     about i:   ⅕ρV (a_j² − a_k²)² (α_k − α_j)/(2(a_j² − a_k²) + (a_j² + a_k²)(α_j − α_k))
/// with i, j, k in cyclic order. Water that is strained, u = e (r_k, r_j) in the plane of j and k,
/// has the same normal velocity on the ellipsoid as a turning about i of −Ω_w,
///     Ω_w = e (a_j² + a_k²)/(a_j² − a_k²)
/// so that momentum about i is that of Ω − Ω_w: a flat body turns with the slope of the water.
struct EllipsoidMass {
  Vec3 linear = Vec3::Zero();     ///< [kg] along each axis
  Vec3 angular = Vec3::Zero();    ///< [kg·m²] about each axis
  Vec3 straining = Vec3::Zero();  ///< [kg·m²] the latter times Ω_w/e; finite for a sphere, too
};
/// @param semiAxes  a, b, c [m] > 0.  @param density  [kg/m³].
EllipsoidMass ellipsoidMass(const Vec3& semiAxes, double density) noexcept;

/// α of the three axes.
Vec3 ellipsoidIntegrals(const Vec3& semiAxes) noexcept;

}  // namespace cutwater
