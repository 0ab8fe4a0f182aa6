#pragma once
#include "hydro/bem/XDerivative.h"
#include "hydro/waves/IncidentWaveForce.h"

namespace cutwater {

/// Force of a diffracted wave, per metre of amplitude, crest over G, on a ship at speed U:
///     F_D = ω_e F^ω + U F^U,   F^ω = ρ∫ iφ_D n_j dS,   F^U = −ρ∫ ∂φ_D/∂x n_j dS      [M03] (88)-(91)
struct DiffractionParts {
  CVec6 omega = CVec6::Zero();  ///< F^ω
  CVec6 speed = CVec6::Zero();  ///< F^U; zero if not asked for
};

/// F^ω and F^U for ∂φ_D/∂n = v, solved directly for even and odd parts, many waves of one system at
/// once.                                                                  [M03] (63), (69)-(79)
/// @param stokes  nullptr: F^ω alone.
std::vector<DiffractionParts> diffraction(const SymmetricSystem<Complex>& system,
                                          const ModeNormals& normals,
                                          const std::vector<IncidentVelocity>& waves,
                                          double density, const XDerivative* stokes = nullptr);

/// b_j of F^ω (Coefficients::adjoint says how to use them): the same number as `diffraction`, for
/// every wave, for six back-substitutions. 6 × panels.
template <typename Scalar>
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Scalar>& system,
                                                         const ModeNormals& normals,
                                                         double density);

/// b^x_j of F^U (Coefficients::adjointX), six more.
template <typename Scalar>
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectorsX(const SymmetricSystem<Scalar>& system,
                                                          const ModeNormals& normals,
                                                          const XDerivative& stokes,
                                                          double density);

}  // namespace cutwater
