#pragma once
#include "hydro/bem/Radiation.h"
#include "hydro/waves/IncidentWaveForce.h"

namespace cutwater {

/// F_D,j = ρ ∫ iω φ_D n_j dS with ∂φ_D/∂n = −∂φ_I/∂n, solved directly for even and odd parts.
///                                                                       [M03] (63), (69)-(79),
///                                                                       (88)
/// Per metre of amplitude, crest over G [N/m, N·m/m].
CVec6 diffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                  const IncidentVelocity& v, double omega, double density);

/// The same for many waves of one frequency at once, which is several times faster.
std::vector<CVec6> diffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                               const std::vector<IncidentVelocity>& waves, double omega,
                               double density);

/// b_j = iρ Rᵀ L⁻ᵀ w_j, so that F_D,j = ω Σ b_j,i v_i (Coefficients::adjoint says how to use them):
/// the same number as `diffraction`, for every heading, for six back-substitutions. 6 × panels.
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Complex>& system,
                                                         const ModeNormals& normals,
                                                         double density);

}  // namespace cutwater
