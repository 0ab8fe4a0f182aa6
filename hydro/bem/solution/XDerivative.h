#pragma once
#include <Eigen/SparseCore>

#include "hydro/bem/solution/Radiation.h"

namespace cutwater {

/// ∫ ∂φ/∂x dS of every panel from its potential and normal velocity alone: by Stokes' theorem
///     (∂φ/∂x) dS = n_x v dS + (Tφ),   (Tφ)_i = Σ_edges φ_edge (e × n_i)_x
/// e the edge counter-clockwise about n. φ_edge is the mean at the edge's middle of the linear φ of
/// the panels that share it, φ + g·(x − centroid), g the gradient along the panel by least squares
/// through its neighbours (none beyond a crease of 60°): second order on panels of any shape, at
/// the waterline and at other loose edges too, where it extrapolates. On y = 0 of a half hull
/// φ_edge is 0 for odd potentials, and a panel there has its mirror image for a neighbour.
/// THEORY.md, chapter 5.
class XDerivative {
 public:
  /// @param wet the mesh `mesh` was made from: its shared vertices say which panels are neighbours.
  XDerivative(const SurfaceMesh& wet, const PanelMesh& mesh);

  /// T of one parity, panels × panels.
  const Eigen::SparseMatrix<double>& stokes(Parity parity) const {
    return stokes_[static_cast<std::size_t>(parity)];
  }

 private:
  std::array<Eigen::SparseMatrix<double>, 2> stokes_;
};

/// ∫ ∂φ/∂x dS of every panel for normal velocities v and their potentials φ, column by column: by H
/// if the system has it, else by Stokes' theorem.
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> xIntegrals(
    const SymmetricSystem<Scalar>& system, const ModeNormals& normals, const XDerivative& stokes,
    Parity parity, const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& v,
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& phi);

/// ∂Z_jk = −ρ ∫ ∂φ̂_k/∂x n_j dS, ∂B + iω∂A = iω∂Z; at ω → 0 and ∞ it is ∂A.  [M03] (12), (13), (25)
template <typename Scalar>
Eigen::Matrix<Scalar, 6, 6> impulseMatrixX(const SymmetricSystem<Scalar>& system,
                                           const ModePotentials<Scalar>& potentials,
                                           const ModeNormals& normals, const XDerivative& stokes,
                                           double density);

}  // namespace cutwater
