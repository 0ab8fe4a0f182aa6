#include "hydro/bem/solution/PanelGradients.h"

#include <Eigen/Dense>
#include <algorithm>

#include "hydro/bem/matrices/PanelPairs.h"

namespace cutwater {
namespace {

/// Neighbours that turn by more than 60° lie beyond an edge of the hull, where ∇φ jumps. A round
/// bilge of few panels turns by up to 45° from one to the next.
constexpr double kCrease = 0.5;

}  // namespace

PanelGradients::PanelGradients(const SurfaceMesh& wet, const PanelMesh& mesh)
    : wet_(wet), mesh_(mesh), tolerance_(1e-9 * bounds(wet).diagonal()) {
  const int count = static_cast<int>(wet.faces.size());
  for (int f = 0; f < count; ++f)
    for (int i = 0; i < face(f).size(); ++i) facesOf_[edge(f, i)].push_back(f);
  for (int f = 0; f < count; ++f) gradients_.push_back(gradientOf(f));
}

/// Its two vertices in rising order.
std::pair<int, int> PanelGradients::edge(int panel, int i) const {
  const Face& corners = face(panel);
  return std::minmax(corners[i], corners[(i + 1) % corners.size()]);
}

bool PanelGradients::onCentreline(int panel, int i) const {
  const auto onPlane = [this](int vertex) {
    return std::abs(wet_.vertices[static_cast<std::size_t>(vertex)].y()) < tolerance_;
  };
  const auto [a, b] = edge(panel, i);
  return mesh_.symmetric && onPlane(a) && onPlane(b);
}

Vec3 PanelGradients::middle(int panel, int i) const {
  const auto [a, b] = edge(panel, i);
  return 0.5 *
         (wet_.vertices[static_cast<std::size_t>(a)] + wet_.vertices[static_cast<std::size_t>(b)]);
}

/// Those across the edges of panel `at` that go on where panel `one` lies, seen from there.
void PanelGradients::addAround(int at, int one, std::vector<Neighbour>& found) const {
  const Panel& own = panel(one);
  const auto add = [&](int other, bool image) {
    if (imageInY(panel(other).normal, image).dot(own.normal) > kCrease)
      found.push_back({other, image, imageInY(panel(other).centroid, image) - own.centroid});
  };
  for (int i = 0; i < face(at).size(); ++i) {
    const std::vector<int>& faces = sharing(at, i);
    for (const int other : faces)
      if (other != at && other != one) add(other, false);
    if (faces.size() == 1 && onCentreline(at, i)) add(at, true);
  }
}

/// With one neighbour alone (a triangle in a corner) also that one's.
std::vector<PanelGradients::Neighbour> PanelGradients::neighboursOf(int one) const {
  std::vector<Neighbour> found;
  addAround(one, one, found);
  if (found.size() == 1 && !found.front().isImage) addAround(found.front().panel, one, found);
  return found;
}

/// Least squares over slopes: the direction to each neighbour is turned into the panel's plane, its
/// distance kept, and each counts alike. Directions nearly in one line give the slope along that
/// line.
PanelGradients::Gradient PanelGradients::gradientOf(int one) const {
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

}  // namespace cutwater
