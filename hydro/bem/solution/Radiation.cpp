#include "hydro/bem/solution/Radiation.h"

#include <algorithm>

#include "hydro/bem/solution/PanelGradients.h"
#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// ∫ n_j dS over a patch.
Vec6 areas(const PanelPatch& patch, const Vec3& arm) {
  Vec6 area;
  area << patch.vectorArea, arm.cross(patch.vectorArea) + patch.couple;
  return area;
}

/// Gradients of n_1..n_6 along the panel, one column each.
Eigen::Matrix<double, 3, 6> slopes(const Panel& panel, const PanelPatch& patch, const Vec3& arm) {
  Eigen::Matrix<double, 3, 6> slope;
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis = Vec3::Unit(k);
    slope.col(k) = -patch.bend * axis;
    slope.col(3 + k) = panel.normal.cross(axis) - patch.bend * axis.cross(arm);
  }
  return slope;
}

/// Adds ∇φ·∫s n_j dS of the curved patches, φ linear on each, to weights w_j.
void addSlopes(const PanelMesh& mesh, const Vec3& cog, const PanelGradients& gradients,
               Rows& weights) {
  const Eigen::RowVectorXd image = (Eigen::RowVectorXd(6) << 1, -1, 1, -1, 1, -1).finished();
  for (int i = 0; i < static_cast<int>(mesh.panels.size()); ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    const PanelPatch& patch = mesh.patches[static_cast<std::size_t>(i)];
    if (patch.curved == 0.0) continue;
    const PanelGradients::Gradient& gradient = gradients.of(i);
    const Rows steps = patch.curved * gradient.columns.transpose() * secondMoments(panel) *
                       slopes(panel, patch, panel.centroid - cog);
    weights.row(i) -= steps.colwise().sum();
    for (Eigen::Index k = 0; k < steps.rows(); ++k) {
      const PanelGradients::Neighbour& other = gradient.neighbours[static_cast<std::size_t>(k)];
      if (other.isImage)
        weights.row(other.panel) += steps.row(k).cwiseProduct(image);
      else
        weights.row(other.panel) += steps.row(k);
    }
  }
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
  for (std::size_t i = 0; i < mesh.patches.size(); ++i)
    velocity.row(static_cast<Eigen::Index>(i)) =
        areas(mesh.patches[i], mesh.panels[i].centroid - cog).transpose() / mesh.panels[i].area;
}

ModeNormals::ModeNormals(const PanelMesh& mesh, const Vec3& cog, const SurfaceMesh& wet)
    : ModeNormals(mesh, cog) {
  const auto isCurved = [](const PanelPatch& patch) { return patch.curved > 0.0; };
  if (std::none_of(mesh.patches.begin(), mesh.patches.end(), isCurved)) return;
  Rows weights = area.asDiagonal() * velocity;
  addSlopes(mesh, cog, PanelGradients(wet, mesh), weights);
  velocity = area.cwiseInverse().asDiagonal() * weights;
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
