#include "hydro/bem/XDerivative.h"

#include <algorithm>
#include <map>

namespace cutwater {
namespace {

/// Faces on each edge, by its two vertices in rising order.
std::map<std::pair<int, int>, std::vector<int>> facesOfEdges(const SurfaceMesh& wet) {
  std::map<std::pair<int, int>, std::vector<int>> faces;
  for (std::size_t f = 0; f < wet.faces.size(); ++f)
    for (int i = 0; i < wet.faces[f].size(); ++i) {
      const int a = wet.faces[f][i], b = wet.faces[f][(i + 1) % wet.faces[f].size()];
      faces[std::minmax(a, b)].push_back(static_cast<int>(f));
    }
  return faces;
}

/// The share of each panel in φ on an edge.
std::vector<std::pair<int, double>> edgeMean(const std::vector<int>& faces, bool onCentreline,
                                             Parity parity) {
  if (faces.size() == 1 && onCentreline && parity == Parity::Odd) return {};
  std::vector<std::pair<int, double>> mean;
  for (const int face : faces) mean.emplace_back(face, 1.0 / static_cast<double>(faces.size()));
  return mean;
}

}  // namespace

XDerivative::XDerivative(const SurfaceMesh& wet, const PanelMesh& mesh) {
  const auto facesOf = facesOfEdges(wet);
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  const double tolerance = 1e-9 * bounds(wet).diagonal();
  for (const Parity parity : {Parity::Even, Parity::Odd}) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < static_cast<int>(count); ++row) {
      const Face& face = wet.faces[static_cast<std::size_t>(row)];
      const Panel& panel = mesh.panels[static_cast<std::size_t>(row)];
      for (int i = 0; i < panel.corners; ++i) {
        const int next = (i + 1) % panel.corners, a = face[i], b = face[next];
        const Vec3 edge = panel.corner[static_cast<std::size_t>(next)] -
                          panel.corner[static_cast<std::size_t>(i)];
        const double along = edge.cross(panel.normal).x();
        const bool onCentreline = mesh.symmetric && std::abs(wet.corner(face, i).y()) < tolerance &&
                                  std::abs(wet.corner(face, next).y()) < tolerance;
        for (const auto& [neighbour, share] :
             edgeMean(facesOf.at(std::minmax(a, b)), onCentreline, parity))
          entries.emplace_back(row, neighbour, share * along);
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
    const Eigen::MatrixXd n = normals.of(parity);
    Z(modes, modes) = -density * sides * n.transpose() *
                      xIntegrals<Scalar>(system, normals, stokes, parity, n.template cast<Scalar>(),
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
