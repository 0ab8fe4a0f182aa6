#pragma once
#include "hydro/incident/IncidentVelocity.h"

/// Sums over the panels of a hull and, if it is symmetric, their mirror images: what the two ways
/// to integrate a wave over a panel have in common. IncidentWaveForce.cpp integrates exactly.
/// SmallPanels.cpp, for tables of thousands of waves, takes an expansion about the centre of the
/// panel: one exponential instead of one a corner.
namespace cutwater {

/// n_1..6 times a function on one panel.
/// @param sum  its integral (or mean).  @param arm  that of (x − G) times it.
inline CVec6 timesNormal(Complex sum, const Eigen::Vector3cd& arm, const Vec3& n) {
  CVec6 result;
  result.head<3>() = sum * n;
  result.tail<3>().real() = arm.real().cross(n);  // Eigen's cross of complex vectors is conjugated
  result.tail<3>().imag() = arm.imag().cross(n);
  return result;
}

/// F_I = −ρg Σ ∫ e^{κ·x} n_j dS.
/// @param integral  integral(i, starboard): ∫ e^{κ·x} n_j dS over panel i or its mirror image.
template <class Integral>
CVec6 froudeKrylovSum(std::size_t panels, bool symmetric, double density, double gravity,
                      const Integral& integral) {
  CVec6 sum = CVec6::Zero();
  for (std::size_t i = 0; i < panels; ++i) {
    sum += integral(i, false);
    if (symmetric) sum += integral(i, true);
  }
  return -density * gravity * sum;
}

/// Even and odd part of v from its means on both sides.
/// @param mean  mean(i, starboard): −∂φ_I/∂n, its mean over panel i or its mirror image.
template <class Mean>
IncidentVelocity normalVelocities(std::size_t panels, bool symmetric, const Mean& mean) {
  const auto count = static_cast<Eigen::Index>(panels);
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(symmetric ? count : 0)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    v.even[i] = mean(at, false);
    if (!symmetric) continue;
    const Complex port = v.even[i], starboard = mean(at, true);
    v.even[i] = 0.5 * (port + starboard);
    v.odd[i] = 0.5 * (port - starboard);
  }
  return v;
}

}  // namespace cutwater
