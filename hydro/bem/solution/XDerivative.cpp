#include "hydro/bem/solution/XDerivative.h"

#include "hydro/bem/solution/PanelGradients.h"

namespace cutwater {
namespace {

/// φ on an edge is a sum over panels: share × φ of the panel.
struct PanelShare {
  int panel;
  double share;
};

/// weight × the linear φ of a panel at its centroid + away.
void addLinear(const PanelGradients::Gradient& gradient, int panel, const Vec3& away, double weight,
               Parity parity, std::vector<PanelShare>& shares) {
  const Eigen::RowVectorXd steps = away.transpose() * gradient.columns;
  shares.push_back({panel, weight * (1.0 - steps.sum())});
  for (Eigen::Index k = 0; k < steps.size(); ++k) {
    const PanelGradients::Neighbour& other = gradient.neighbours[static_cast<std::size_t>(k)];
    const double sign = other.isImage && parity == Parity::Odd ? -1.0 : 1.0;
    shares.push_back({other.panel, sign * weight * steps[k]});
  }
}

/// φ at the middle of edge i of a panel: the mean over the panels that share it.
std::vector<PanelShare> edgePotential(const PanelGradients& gradients, const PanelMesh& mesh,
                                      int panel, int i, Parity parity) {
  const std::vector<int>& sharing = gradients.sharing(panel, i);
  std::vector<PanelShare> shares;
  if (sharing.size() == 1 && parity == Parity::Odd && gradients.onCentreline(panel, i))
    return shares;
  const Vec3 middle = gradients.middle(panel, i);
  for (const int one : sharing)
    addLinear(gradients.of(one), one, middle - mesh.panels[static_cast<std::size_t>(one)].centroid,
              1.0 / static_cast<double>(sharing.size()), parity, shares);
  return shares;
}

}  // namespace

XDerivative::XDerivative(const SurfaceMesh& wet, const PanelMesh& mesh) {
  const PanelGradients gradients(wet, mesh);
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  for (const Parity parity : {Parity::Even, Parity::Odd}) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < static_cast<int>(count); ++row) {
      const Panel& panel = mesh.panels[static_cast<std::size_t>(row)];
      for (int i = 0; i < panel.corners; ++i) {
        const Vec3 edge = panel.corner[static_cast<std::size_t>((i + 1) % panel.corners)] -
                          panel.corner[static_cast<std::size_t>(i)];
        const double along = edge.cross(panel.normal).x();
        for (const auto& [other, share] : edgePotential(gradients, mesh, row, i, parity))
          entries.emplace_back(row, other, share * along);
      }
    }
    auto& matrix = stokes_[static_cast<std::size_t>(parity)];
    matrix.resize(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
  }
}

template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> xIntegrals(
    const SymmetricSystem<Scalar>& system, const ModeNormals& normals, const XDerivative& stokes,
    Parity parity, const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& v,
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& phi) {
  if (system.hasXDerivative()) return normals.area.asDiagonal() * system.xDerivatives(parity, v);
  const Eigen::VectorXd projected = normals.area.cwiseProduct(normals.n.col(Surge));
  return projected.asDiagonal() * v + stokes.stokes(parity).cast<Scalar>() * phi;
}

template <typename Scalar>
Eigen::Matrix<Scalar, 6, 6> impulseMatrixX(const SymmetricSystem<Scalar>& system,
                                           const ModePotentials<Scalar>& potentials,
                                           const ModeNormals& normals, const XDerivative& stokes,
                                           double density) {
  Eigen::Matrix<Scalar, 6, 6> Z = Eigen::Matrix<Scalar, 6, 6>::Zero();
  const double sides = normals.symmetric ? 2.0 : 1.0;
  for (const Parity parity : normals.parities()) {
    const std::vector<int> modes = normals.modes(parity);
    const Eigen::MatrixXd n = normals.of(parity), v = normals.velocities(parity);
    Z(modes, modes) = -density * sides * n.transpose() *
                      xIntegrals<Scalar>(system, normals, stokes, parity, v.template cast<Scalar>(),
                                         potentials[static_cast<std::size_t>(parity)]);
  }
  return Z;
}

template Eigen::MatrixXd xIntegrals(const SymmetricSystem<double>&, const ModeNormals&,
                                    const XDerivative&, Parity, const Eigen::MatrixXd&,
                                    const Eigen::MatrixXd&);
template Eigen::Matrix<double, 6, 6> impulseMatrixX(const SymmetricSystem<double>&,
                                                    const ModePotentials<double>&,
                                                    const ModeNormals&, const XDerivative&, double);
template Eigen::MatrixXcd xIntegrals(const SymmetricSystem<Complex>&, const ModeNormals&,
                                     const XDerivative&, Parity, const Eigen::MatrixXcd&,
                                     const Eigen::MatrixXcd&);
template Eigen::Matrix<Complex, 6, 6> impulseMatrixX(const SymmetricSystem<Complex>&,
                                                     const ModePotentials<Complex>&,
                                                     const ModeNormals&, const XDerivative&,
                                                     double);

}  // namespace cutwater
