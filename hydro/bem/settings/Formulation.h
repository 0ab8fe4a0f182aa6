#pragma once
#include <array>

namespace cutwater {

/// Which integral equation gives the potentials.
enum class Formulation {
  Potential,  ///< ½φ + ∫φ ∂G/∂n_ξ = ∫G v, Green's identity on the hull
  Source  ///< Dσ = v, φ = Eσ, as in the report                                 [M03] (49)-(51)
};
inline constexpr std::array kFormulationNames{"potential", "source"};

/// How ∂φ/∂x comes from the solution.
enum class Derivatives {
  Stokes,  ///< Stokes' theorem on each panel (bem/solution/XDerivative.h)
  Source  ///< ∂φ/∂x = Hσ, as in the report; with Formulation::Source only         [M03] (51)-(54)
};
inline constexpr std::array kDerivativesNames{"stokes", "source"};

/// How diffraction forces are obtained between the frequencies of the grid.
enum class Influence {
  Adjoint,  ///< vectors b_j with F_D,j = b_jᵀ v, interpolated in ω_e when read; any U, β, ω_I
  Direct,   ///< each condition has a system of its own, assembled and solved
  Matrix,   ///< influence matrices interpolated between grid frequencies        [M03] (80)-(83)
  Inverse   ///< their inverses interpolated; wrong near irregular frequencies   [M03] (84)-(87)
};
inline constexpr std::array kInfluenceNames{"adjoint", "direct", "interpolated", "inverse"};

}  // namespace cutwater
