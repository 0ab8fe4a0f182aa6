#pragma once
#include "hydro/bem/solution/SymmetricSystem.h"

namespace cutwater {

/// Generalised normals n_1..n_6 about G and areas of the hull panels, and the weights with which a
/// potential of one value a panel is integrated against them: one row a panel.
///     w_jᵀ φ = ∫ φ n_j dS
/// w_j = ∫n_j dS over the surface for which the panel stands (PanelMesh::patches), on a flat face
/// n_j ΔS. Where that is curved, n_j varies and so does φ, linear on each panel (PanelGradients.h):
/// w_j then has ∇φ times the first moment of n_j, carried to the neighbours, too. By reciprocity
/// the same w_j are the flux of a motion through the panels.
/// THEORY.md, chapter 5.
struct ModeNormals {
  /// n_{1..3} = n, n_{4..6} = (r − r_G) × n at the centroid. Without first moments.
  ModeNormals(const PanelMesh& mesh, const Vec3& cog);
  /// Curved where `mesh` says so.  @param wet the mesh `mesh` was made from.
  ModeNormals(const PanelMesh& mesh, const Vec3& cog, const SurfaceMesh& wet);

  std::vector<Parity> parities() const;
  /// Index of the modes that belong to a parity: {0, 2, 4} or {1, 3, 5}; of a hull solved whole
  /// all.
  std::vector<int> modes(Parity parity) const;
  /// Columns n_j of those modes.
  Eigen::MatrixXd of(Parity parity) const;
  /// Columns w_j, twice for a symmetric hull: ∫ over both sides.
  Eigen::MatrixXd weights(Parity parity) const;
  /// Columns w_j / ΔS: the normal velocities of unit motion, one value a panel; n_j on flat faces.
  Eigen::MatrixXd velocities(Parity parity) const;

  Eigen::Matrix<double, Eigen::Dynamic, 6> n;
  Eigen::Matrix<double, Eigen::Dynamic, 6> velocity;  ///< w_j / ΔS
  Eigen::VectorXd area;
  bool symmetric;
};

/// Potentials φ̂_k of unit velocity, ∂φ̂_k/∂n = n_k: per parity one column for each of its modes.
template <typename Scalar>
using ModePotentials = std::array<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>, 2>;

template <typename Scalar>
ModePotentials<Scalar> radiationPotentials(const SymmetricSystem<Scalar>& system,
                                           const ModeNormals& normals);

/// Z_jk = −ρ ∫ φ̂_k n_j dS: row j the force, column k the motion; 0 between modes of different
/// parity of a symmetric hull. At ω → 0 and ∞ it is the added mass [kg, kg m, kg m²].
///                                                                       [M03] (12), (13)
template <typename Scalar>
Eigen::Matrix<Scalar, 6, 6> impulseMatrix(const ModePotentials<Scalar>& potentials,
                                          const ModeNormals& normals, double density);

/// B + iωA = iωZ.                                                        [M03] (10), (11)
inline Mat6 addedMass(const CMat6& Z) { return Z.real(); }
inline Mat6 damping(const CMat6& Z, double omega) { return -omega * Z.imag(); }

}  // namespace cutwater
