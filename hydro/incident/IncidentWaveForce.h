#pragma once
#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/incident/IncidentVelocity.h"

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

/// v of a wave: its flux through the surface for which each panel stands (PanelMesh::patches), over
/// the panel's area.
IncidentVelocity incidentNormalVelocity(const PanelMesh& mesh, const AiryWave& wave,
                                        const Vec3& cog);

/// Σ_i b_j,i v_i from the adjoint vectors of one frequency (6 × panels, Coefficients::adjoint):
/// F^ω_j of `adjoint`, F^U_j of `adjointX`; F_D = ω_e F^ω + U F^U, phase and units as
/// froudeKrylovForce. Exactly what solving the diffraction problem anew would give.
CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const IncidentVelocity& velocity);
/// The same for v of a wave.
CVec6 diffractionForce(const Eigen::Matrix<Complex, 6, Eigen::Dynamic>& adjoint,
                       const PanelMesh& mesh, const AiryWave& wave, const Vec3& cog);

}  // namespace cutwater
