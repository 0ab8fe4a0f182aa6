#pragma once
#include "hydro/bem/solution/XDerivative.h"
#include "hydro/incident/IncidentWaveForce.h"

namespace cutwater {

/// Force of a diffracted wave, per metre of amplitude, crest over G, on a ship at speed U:
///     F_D = ω_e F^ω + U F^U,   F^ω = ρ∫ iφ_D n_j dS,   F^U = −ρ∫ ∂φ_D/∂x n_j dS
///                                                                              [M03] (88)-(91)
/// THEORY.md, chapter 5.
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

using ModeVectors = Eigen::Matrix<Complex, 6, Eigen::Dynamic>;  // 6 × panels

/// b_j of F^ω and b^x_j of F^U (Coefficients::adjoint and adjointX say how to use them): the same
/// numbers as `diffraction`, for every wave, for six back-substitutions, with b^x twelve.
struct AdjointVectors {
  ModeVectors omega;
  ModeVectors speed;  ///< empty if not asked for
};

/// @param stokes  nullptr: no b^x.
template <typename Scalar>
AdjointVectors adjointVectors(const SymmetricSystem<Scalar>& system, const ModeNormals& normals,
                              double density, const XDerivative* stokes = nullptr);

/// Σ over both sides of b_jᵀ v for v = n_k, row j, column k, 0 between modes of different parity:
/// of b_j it is −iZ (impulseMatrix), of b^x_j ∂Z (impulseMatrixX), the same numbers without another
/// solution.
CMat6 forcesOnUnitMotions(const ModeVectors& b, const ModeNormals& normals);

}  // namespace cutwater
