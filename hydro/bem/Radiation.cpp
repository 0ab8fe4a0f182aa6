#include "hydro/bem/Radiation.h"

namespace cutwater {
ModeNormals::ModeNormals(const PanelMesh& mesh, const Vec3& cog)
    : n(mesh.panels.size(), 6), area(mesh.panels.size()), symmetric(mesh.symmetric) {
  for (Eigen::Index i = 0; i < n.rows(); ++i) {
    const Panel& panel = mesh.panels[static_cast<std::size_t>(i)];
    n.row(i).head<3>() = panel.normal;
    n.row(i).tail<3>() = (panel.centroid - cog).cross(panel.normal);
    area[i] = panel.area;
  }
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
  return (symmetric ? 2.0 : 1.0) * area.asDiagonal() * of(parity);
}

template <typename Scalar>
ModePotentials<Scalar> radiationPotentials(const SymmetricSystem<Scalar>& system,
                                           const ModeNormals& normals) {
  ModePotentials<Scalar> potentials;
  for (int p = 0; p < system.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    potentials[static_cast<std::size_t>(p)] =
        system.potentials(parity, normals.of(parity).template cast<Scalar>());
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
