#include "hydro/bem/solution/Radiation.h"

#include "hydro/bem/solution/PanelGradients.h"

namespace cutwater {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// ∫ (x − centroid)(x − centroid)ᵀ dS [m⁴].
Eigen::Matrix3d spread(const Panel& panel) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const QuadraturePoint& point : panelQuadrature(panel, 2)) {
    const Vec3 s = point.x - panel.centroid;
    sum += point.weight * s * s.transpose();
  }
  return sum;
}

/// ∫ n_j dS over a curved patch: of r × n its part from the bend, −∫ s × (bend s) dS, too.
Vec6 areas(const CurvedPatch& patch, const Vec3& arm, const Eigen::Matrix3d& moment) {
  const Eigen::Matrix3d twist = moment * patch.bend;
  Vec6 area;
  area << patch.vectorArea,
      arm.cross(patch.vectorArea) -
          Vec3(twist(1, 2) - twist(2, 1), twist(2, 0) - twist(0, 2), twist(0, 1) - twist(1, 0));
  return area;
}

/// Gradients of n_1..n_6 along the panel, one column each.
Eigen::Matrix<double, 3, 6> slopes(const Panel& panel, const CurvedPatch& patch, const Vec3& arm) {
  Eigen::Matrix<double, 3, 6> slope;
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis = Vec3::Unit(k);
    slope.col(k) = -patch.bend * axis;
    slope.col(3 + k) = panel.normal.cross(axis) - patch.bend * axis.cross(arm);
  }
  return slope;
}

/// Weights w_j with w_jᵀφ = ∫φ n_j dS over the curved patches, φ linear on each: φ ∫n_j dS + ∇φ·∫s
/// n_j dS.
Rows curvedWeights(const PanelMesh& mesh, const Vec3& cog, const PanelGradients& gradients) {
  Rows weights = Rows::Zero(static_cast<Eigen::Index>(mesh.panels.size()), 6);
  const Eigen::RowVectorXd image = (Eigen::RowVectorXd(6) << 1, -1, 1, -1, 1, -1).finished();
  for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    const CurvedPatch& patch = mesh.patches[static_cast<std::size_t>(i)];
    const Vec3 arm = panel.centroid - cog;
    const Eigen::Matrix3d moment = spread(panel);
    weights.row(i) += areas(patch, arm, moment).transpose();
    const PanelGradients::Gradient& gradient = gradients.of(i);
    const Rows steps = gradient.columns.transpose() * moment * slopes(panel, patch, arm);
    weights.row(i) -= steps.colwise().sum();
    for (Eigen::Index k = 0; k < steps.rows(); ++k) {
      const PanelGradients::Neighbour& other = gradient.neighbours[static_cast<std::size_t>(k)];
      if (other.isImage)
        weights.row(other.panel) += steps.row(k).cwiseProduct(image);
      else
        weights.row(other.panel) += steps.row(k);
    }
  }
  return weights;
}

}  // namespace

ModeNormals::ModeNormals(const PanelMesh& mesh, const Vec3& cog)
    : n(mesh.panels.size(), 6), area(mesh.panels.size()), symmetric(mesh.symmetric) {
  for (Eigen::Index i = 0; i < n.rows(); ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    n.row(i).head<3>() = panel.normal;
    n.row(i).tail<3>() = (panel.centroid - cog).cross(panel.normal);
    area[i] = panel.area;
  }
  velocity = n;
}

ModeNormals::ModeNormals(const PanelMesh& mesh, const Vec3& cog, const SurfaceMesh& wet)
    : ModeNormals(mesh, cog) {
  if (mesh.patches.empty()) return;
  velocity = area.cwiseInverse().asDiagonal() * curvedWeights(mesh, cog, PanelGradients(wet, mesh));
}

std::vector<Parity> ModeNormals::parities() const {
  if (!symmetric) return {Parity::Even};
  return {Parity::Even, Parity::Odd};
}

std::vector<int> ModeNormals::modes(Parity parity) const {
  if (!symmetric) return {0, 1, 2, 3, 4, 5};
  return parity == Parity::Even ? std::vector{0, 2, 4} : std::vector{1, 3, 5};
}

Eigen::MatrixXd ModeNormals::of(Parity parity) const { return n(Eigen::all, modes(parity)); }

Eigen::MatrixXd ModeNormals::weights(Parity parity) const {
  return (symmetric ? 2.0 : 1.0) * area.asDiagonal() * velocities(parity);
}

Eigen::MatrixXd ModeNormals::velocities(Parity parity) const {
  return velocity(Eigen::all, modes(parity));
}

template <typename Scalar>
ModePotentials<Scalar> radiationPotentials(const SymmetricSystem<Scalar>& system,
                                           const ModeNormals& normals) {
  ModePotentials<Scalar> potentials;
  for (int p = 0; p < system.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    potentials[static_cast<std::size_t>(p)] =
        system.potentials(parity, normals.velocities(parity).template cast<Scalar>());
  }
  return potentials;
}

template <typename Scalar>
Eigen::Matrix<Scalar, 6, 6> impulseMatrix(const ModePotentials<Scalar>& potentials,
                                          const ModeNormals& normals, double density) {
  Eigen::Matrix<Scalar, 6, 6> Z = Eigen::Matrix<Scalar, 6, 6>::Zero();
  for (const Parity parity : normals.parities()) {
    const std::vector<int> modes = normals.modes(parity);
    Z(modes, modes) = -density * (normals.weights(parity).transpose() *
                                  potentials[static_cast<std::size_t>(parity)]);
  }
  return Z;
}

template ModePotentials<double> radiationPotentials(const SymmetricSystem<double>&,
                                                    const ModeNormals&);
template ModePotentials<Complex> radiationPotentials(const SymmetricSystem<Complex>&,
                                                     const ModeNormals&);
template Mat6 impulseMatrix(const ModePotentials<double>&, const ModeNormals&, double);
template CMat6 impulseMatrix(const ModePotentials<Complex>&, const ModeNormals&, double);

}  // namespace cutwater
