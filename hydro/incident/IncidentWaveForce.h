#pragma once
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/waves/Wave.h"

namespace cutwater {

/// Force of the undisturbed wave on the hull held at rest, and moment about G, per metre of
/// amplitude, crest over G at t = 0; modes, axes and signs of Conventions.h:
///     F_I,j = iρω_I ∫ φ_I n_j dS = −ρg ∫ e^{kz − ik((x − x_G) cos β − (y − y_G) sin β)} n_j dS
///                                                                        [M03] (64)-(68), 5.8
/// Exact on flat panels (PanelWave.h), relative error of each panel's share below 1e-9. A symmetric
/// mesh counts its starboard image.
/// @param cog G in hull axes [m].  @param density ρ [kg/m³].
/// @return [N/m] and [N·m/m].  Cost: four exponentials a panel and side.
CVec6 froudeKrylovForce(const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog,
                        double density);

/// v = −∂φ_I/∂n, its mean over each panel [m/s per m], the normal velocity of the diffracted wave,
/// crest over G. Of a symmetric mesh the even and the odd part at its port panels, v_port = even + odd,
/// v_starboard = even − odd ([M03] (69)-(79), with the factor e^{kz} missing in (76)); else `even`
/// is v, `odd` empty.
struct IncidentVelocity {
  Eigen::VectorXcd even, odd;
};
IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog);

/// e^{κ·x} on one panel, n_1..6 times it: `sum` its integral (or mean), `arm` that of (x − G) e^{κ·x}.
CVec6 timesNormal(Complex sum, const Eigen::Vector3cd& arm, const Vec3& normal);

/// Both parts of v from its means mean(i, starboard) over panel i and over its mirror image.
template <class Mean>
IncidentVelocity evenAndOdd(std::size_t panels, bool symmetric, const Mean& mean) {
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

/// Σ_i b_j,i v_i from the adjoint vectors of one frequency (6 × panels, Coefficients::adjoint):
/// F^ω_j of `adjoint`, F^U_j of `adjointX`; F_D = ω_e F^ω + U F^U, phase and units as
/// froudeKrylovForce. Exactly what solving the diffraction problem anew would give.
CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const IncidentVelocity& velocity);
/// The same for v of a wave.
CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog);

}  // namespace cutwater
