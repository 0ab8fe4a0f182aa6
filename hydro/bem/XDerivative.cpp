#include "hydro/bem/XDerivative.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

namespace cutwater {
namespace {

/// Neighbours that turn by more than 60° lie beyond an edge of the hull, where ∇φ jumps. A round bilge
/// of few panels turns by up to 45° from one to the next.
constexpr double kCrease = 0.5;

/// φ on an edge is a sum over panels: share × φ of the panel.
struct PanelShare {
  int panel;
  double share;
};

/// φ on the edges of panels, out of the panels' values: each panel carries φ + g·(x − centroid), the
/// gradient g along its plane by least squares through its neighbours.
class EdgePotentials {
 public:
  EdgePotentials(const SurfaceMesh& wet, const PanelMesh& mesh);
  /// At the middle of edge i of a panel: the mean over the panels that share it.
  std::vector<PanelShare> at(int panel, int i, Parity parity) const;

 private:
  /// Another panel, or the panel's own mirror image across the centreline.
  struct Neighbour {
    int panel;
    bool isImage;
    Vec3 away;  ///< from the panel's centroid to its own
  };
  /// g = Σ column × (φ of that neighbour − φ of the panel).
  struct Gradient {
    std::vector<Neighbour> neighbours;
    Eigen::Matrix3Xd columns;
  };

  const Face& face(int i) const { return wet_.faces[static_cast<std::size_t>(i)]; }
  const Panel& panel(int i) const { return mesh_.panels[static_cast<std::size_t>(i)]; }
  std::pair<int, int> edge(int panel, int i) const;
  bool onCentreline(const std::pair<int, int>& edge) const;
  void addAround(int at, int one, std::vector<Neighbour>& found) const;
  std::vector<Neighbour> neighboursOf(int panel) const;
  Gradient gradientOf(int panel) const;
  void addLinear(int panel, const Vec3& x, double weight, Parity parity,
                 std::vector<PanelShare>& shares) const;

  const SurfaceMesh& wet_;
  const PanelMesh& mesh_;
  double tolerance_;
  std::map<std::pair<int, int>, std::vector<int>> facesOf_;  // of each edge
  std::vector<Gradient> gradients_;                          // of each panel
};

EdgePotentials::EdgePotentials(const SurfaceMesh& wet, const PanelMesh& mesh)
    : wet_(wet), mesh_(mesh), tolerance_(1e-9 * bounds(wet).diagonal()) {
  const int count = static_cast<int>(wet.faces.size());
  for (int f = 0; f < count; ++f)
    for (int i = 0; i < face(f).size(); ++i) facesOf_[edge(f, i)].push_back(f);
  for (int f = 0; f < count; ++f) gradients_.push_back(gradientOf(f));
}

/// Its two vertices in rising order.
std::pair<int, int> EdgePotentials::edge(int panel, int i) const {
  const Face& corners = face(panel);
  return std::minmax(corners[i], corners[(i + 1) % corners.size()]);
}

bool EdgePotentials::onCentreline(const std::pair<int, int>& edge) const {
  const auto onPlane = [this](int vertex) {
    return std::abs(wet_.vertices[static_cast<std::size_t>(vertex)].y()) < tolerance_;
  };
  return mesh_.symmetric && onPlane(edge.first) && onPlane(edge.second);
}

/// Those across the edges of panel `at` that go on where panel `one` lies, seen from there.
void EdgePotentials::addAround(int at, int one, std::vector<Neighbour>& found) const {
  const Panel& own = panel(one);
  const auto add = [&](int other, bool image) {
    if (imageInY(panel(other).normal, image).dot(own.normal) > kCrease)
      found.push_back({other, image, imageInY(panel(other).centroid, image) - own.centroid});
  };
  for (int i = 0; i < face(at).size(); ++i) {
    const std::vector<int>& faces = facesOf_.at(edge(at, i));
    for (const int other : faces)
      if (other != at && other != one) add(other, false);
    if (faces.size() == 1 && onCentreline(edge(at, i))) add(at, true);
  }
}

/// With one neighbour alone (a triangle in a corner) also that one's.
std::vector<EdgePotentials::Neighbour> EdgePotentials::neighboursOf(int one) const {
  std::vector<Neighbour> found;
  addAround(one, one, found);
  if (found.size() == 1 && !found.front().isImage) addAround(found.front().panel, one, found);
  return found;
}

/// Least squares over slopes: the direction to each neighbour is turned into the panel's plane, its
/// distance kept, and each counts alike. Directions nearly in one line give the slope along that line.
EdgePotentials::Gradient EdgePotentials::gradientOf(int one) const {
  constexpr double kOneLine = 0.05;  // [rad]
  Gradient gradient{neighboursOf(one), {}};
  const auto count = static_cast<Eigen::Index>(gradient.neighbours.size());
  gradient.columns = Eigen::Matrix3Xd::Zero(3, count);
  if (count == 0) return gradient;
  const Vec3& n = panel(one).normal;
  Eigen::MatrixXd directions(count, 3);
  Eigen::VectorXd distance(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec3& away = gradient.neighbours[static_cast<std::size_t>(k)].away;
    directions.row(k) = (away - away.dot(n) * n).normalized();
    distance[k] = away.norm();
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(kOneLine);
  fit.compute(directions);
  gradient.columns = fit.pseudoInverse() * distance.cwiseInverse().asDiagonal();
  return gradient;
}

/// weight × the panel's linear φ at x.
void EdgePotentials::addLinear(int one, const Vec3& x, double weight, Parity parity,
                               std::vector<PanelShare>& shares) const {
  const Gradient& gradient = gradients_[static_cast<std::size_t>(one)];
  const Eigen::RowVectorXd steps = (x - panel(one).centroid).transpose() * gradient.columns;
  shares.push_back({one, weight * (1.0 - steps.sum())});
  for (Eigen::Index k = 0; k < steps.size(); ++k) {
    const Neighbour& other = gradient.neighbours[static_cast<std::size_t>(k)];
    const double sign = other.isImage && parity == Parity::Odd ? -1.0 : 1.0;
    shares.push_back({other.panel, sign * weight * steps[k]});
  }
}

std::vector<PanelShare> EdgePotentials::at(int panel, int i, Parity parity) const {
  const auto ends = edge(panel, i);
  const std::vector<int>& faces = facesOf_.at(ends);
  std::vector<PanelShare> shares;
  if (faces.size() == 1 && parity == Parity::Odd && onCentreline(ends)) return shares;
  const Vec3 middle = 0.5 * (wet_.vertices[static_cast<std::size_t>(ends.first)] +
                             wet_.vertices[static_cast<std::size_t>(ends.second)]);
  for (const int one : faces)
    addLinear(one, middle, 1.0 / static_cast<double>(faces.size()), parity, shares);
  return shares;
}

}  // namespace

XDerivative::XDerivative(const SurfaceMesh& wet, const PanelMesh& mesh) {
  const EdgePotentials potentials(wet, mesh);
  const auto count = static_cast<Eigen::Index>(mesh.panels.size());
  for (const Parity parity : {Parity::Even, Parity::Odd}) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < static_cast<int>(count); ++row) {
      const Panel& panel = mesh.panels[static_cast<std::size_t>(row)];
      for (int i = 0; i < panel.corners; ++i) {
        const Vec3 edge = panel.corner[static_cast<std::size_t>((i + 1) % panel.corners)] -
                          panel.corner[static_cast<std::size_t>(i)];
        const double along = edge.cross(panel.normal).x();
        for (const auto& [other, share] : potentials.at(row, i, parity))
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
