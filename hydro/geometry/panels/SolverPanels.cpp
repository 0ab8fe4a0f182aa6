#include "hydro/geometry/panels/SolverPanels.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {
namespace {

constexpr double kCrease = 0.866;    // cos 30°
constexpr double kOwnWeight = 10.0;  // of the face's own corners in the fit
constexpr double kPoor = 0.7,
                 kGood = 0.9;  // share of the curvature explained: none of it used, all
constexpr double kFlat = 0.01,
                 kHardlyFlat = 0.05;  // [rad] that neighbours turn: up to it a plane, from it none
constexpr double kKnuckle = 0.5;      // cos 60°
constexpr double kAlike = 0.1,
                 kUnlike = 0.2;  // difference of neighbours' normals: curved up to, flat from
constexpr double kGentle = 0.25,
                 kSharp = 0.4;  // [rad] of a turn: what a paraboloid leaves out is of its square
constexpr double kMost = 0.1;   // of the diameter: a greater δ is not believed
constexpr double kSteepEnough = 0.25;  // n_h² of a panel at calm water that may be moved

/// Height over a panel's plane: c + g·s + ½ sᵀQs, s in the plane from the centroid [m].
struct Paraboloid {
  double c = 0.0;
  Eigen::Matrix2d Q = Eigen::Matrix2d::Zero();
  double trust = 0.0;  ///< 0 … 1
};

/// In the plane of a panel: u along its longest edge, v = n × u.
struct Frame {
  Vec3 origin, u, v, n;
  explicit Frame(const Panel& panel) : origin(panel.centroid), n(panel.normal) {
    double longest = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(panel.corners); ++i) {
      const Vec3 edge =
          panel.corner[(i + 1) % static_cast<std::size_t>(panel.corners)] - panel.corner[i];
      if (edge.norm() <= longest) continue;
      longest = edge.norm();
      u = edge / longest;
    }
    v = n.cross(u);
  }
  Eigen::Vector2d inPlane(const Vec3& x) const { return {u.dot(x - origin), v.dot(x - origin)}; }
  double height(const Vec3& x) const { return n.dot(x - origin); }
};

/// Vertices and faces around each vertex of a mesh.
class Neighbourhood {
 public:
  explicit Neighbourhood(const SurfaceMesh& mesh) : mesh_(mesh), around_(mesh.vertices.size()) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Face& face = mesh.faces[f];
      normal_.push_back(vectorArea(mesh, face).normalized());
      middle_.push_back(meanCorner(mesh, face));
      for (int i = 0; i < face.size(); ++i) around_[static_cast<std::size_t>(face[i])].push_back(f);
    }
  }
  /// The surface over face f as far as the normals across its edges bear it out: the paraboloid
  /// where they are its own, the plane where they are the face's; beyond a knuckle they say nothing
  /// of a plane.
  Paraboloid borneOut(std::size_t f, const Frame& frame, Paraboloid surface) const {
    double turn = 0.0, ofPlane = 0.0, difference = 0.0;
    for (const std::size_t g : acrossEdges(f)) {
      const Vec3 away = middle_[g] - frame.origin, turned = normal_[g] - normal_[f];
      const Eigen::Vector2d inPlane(frame.u.dot(away), frame.v.dot(away));
      const Eigen::Vector2d found(frame.u.dot(turned), frame.v.dot(turned));
      // The direction turned into the panel's plane, the distance kept.
      const Eigen::Vector2d expected = -surface.Q * inPlane.normalized() * away.norm();
      turn = std::max(turn, found.norm());
      difference = std::max(difference, (found - expected).norm());
      if (normal_[g].dot(normal_[f]) > kKnuckle) ofPlane = std::max(ofPlane, found.norm());
    }
    const double alike = turn > kFlat ? difference / turn : kUnlike;
    surface.trust *= std::clamp((kUnlike - alike) / (kUnlike - kAlike), 0.0, 1.0) *
                     std::clamp((kSharp - turn) / (kSharp - kGentle), 0.0, 1.0);
    Paraboloid plane;
    plane.trust = std::clamp((kHardlyFlat - ofPlane) / (kHardlyFlat - kFlat), 0.0, 1.0);
    return plane.trust > surface.trust ? plane : surface;
  }
  /// Vertices of the faces that touch face f and do not lie beyond a crease.
  std::set<int> of(std::size_t f) const {
    std::set<int> vertices;
    const Face& face = mesh_.faces[f];
    for (int i = 0; i < face.size(); ++i)
      for (const std::size_t g : around_[static_cast<std::size_t>(face[i])]) {
        if (normal_[g].dot(normal_[f]) < kCrease) continue;
        for (int k = 0; k < mesh_.faces[g].size(); ++k) vertices.insert(mesh_.faces[g][k]);
      }
    return vertices;
  }

 private:
  std::vector<std::size_t> acrossEdges(std::size_t f) const {
    std::vector<std::size_t> found;
    const Face& face = mesh_.faces[f];
    for (int i = 0; i < face.size(); ++i) {
      const int to = face[(i + 1) % face.size()];
      const std::vector<std::size_t>& there = around_[static_cast<std::size_t>(to)];
      for (const std::size_t g : around_[static_cast<std::size_t>(face[i])])
        if (g != f && std::find(there.begin(), there.end(), g) != there.end()) found.push_back(g);
    }
    return found;
  }

  const SurfaceMesh& mesh_;
  std::vector<std::vector<std::size_t>> around_;
  std::vector<Vec3> normal_, middle_;
};

/// Weighted squares that the first `terms` of 1, u, v, u², uv, v² leave, and their coefficients.
double fit(const Eigen::MatrixXd& terms, const Eigen::VectorXd& height,
           const Eigen::VectorXd& weight, Eigen::VectorXd& coefficients) {
  const Eigen::MatrixXd weighted = weight.asDiagonal() * terms;
  coefficients = (terms.transpose() * weighted).ldlt().solve(weighted.transpose() * height);
  const Eigen::VectorXd rest = height - terms * coefficients;
  return rest.dot(weight.asDiagonal() * rest);
}

Paraboloid paraboloid(const SurfaceMesh& mesh, const Face& face, const std::set<int>& vertices,
                      const Frame& frame) {
  Paraboloid result;
  const auto count = static_cast<Eigen::Index>(vertices.size());
  if (count < 7) return result;
  Eigen::Vector2d scale = Eigen::Vector2d::Zero();
  for (int i = 0; i < face.size(); ++i)
    scale = scale.cwiseMax(frame.inPlane(mesh.corner(face, i)).cwiseAbs());
  Eigen::MatrixXd terms(count, 6);
  Eigen::VectorXd height(count), weight(count);
  Eigen::Index row = 0;
  for (const int vertex : vertices) {
    const Vec3& x = mesh.vertices[static_cast<std::size_t>(vertex)];
    const Eigen::Vector2d s = frame.inPlane(x).cwiseQuotient(scale);
    terms.row(row) << 1.0, s.x(), s.y(), 0.5 * s.x() * s.x(), s.x() * s.y(), 0.5 * s.y() * s.y();
    height[row] = frame.height(x);
    bool own = false;
    for (int i = 0; i < face.size(); ++i) own = own || face[i] == vertex;
    weight[row++] = own ? kOwnWeight : 1.0 / (1.0 + s.squaredNorm());
  }
  Eigen::VectorXd flat, curved;
  const double linear = fit(terms.leftCols(3), height, weight, flat);
  const double quadratic = fit(terms, height, weight, curved);
  const double tiny = 1e-6 * scale.norm();
  if (!(linear > tiny * tiny * weight.sum()) || !curved.allFinite()) return result;
  result.trust = std::clamp((1.0 - quadratic / linear - kPoor) / (kGood - kPoor), 0.0, 1.0);
  result.c = curved[0];
  result.Q << curved[3] / (scale.x() * scale.x()), curved[4] / (scale.x() * scale.y()),
      curved[4] / (scale.x() * scale.y()), curved[5] / (scale.y() * scale.y());
  return result;
}

/// Mean height of the paraboloid over the panel.
double meanHeight(const Panel& panel, const Frame& frame, const Paraboloid& surface) {
  double sum = 0.0;
  for (const QuadraturePoint& point : panelQuadrature(panel, 2)) {
    const Eigen::Vector2d s = frame.inPlane(point.x);
    sum += point.weight * (surface.c + 0.5 * s.dot(surface.Q * s));
  }
  return sum / panel.area;
}

/// Every corner by δ along the surface's normal there, n − Qs.
void offset(std::vector<Vec3>& corners, const Frame& frame, const Paraboloid& surface,
            double delta) {
  for (Vec3& x : corners) {
    const Eigen::Vector2d tilt = surface.Q * frame.inPlane(x);
    x += delta * (frame.n - tilt.x() * frame.u - tilt.y() * frame.v);
  }
}

/// The same for a panel with corners on calm water, which stay on it: moved out horizontally,
/// stretched along the waterline about the centroid and downwards from the waterline.
void offsetAtWaterline(std::vector<Vec3>& corners, const Frame& frame, const Paraboloid& surface,
                       double delta) {
  const Vec3 outward(frame.n.x(), frame.n.y(), 0.0);
  const Vec3 along = outward.normalized().cross(Vec3::UnitZ()), down = frame.n.cross(along);
  const auto curvature = [&](const Vec3& t) {
    const Eigen::Vector2d s(frame.u.dot(t), frame.v.dot(t));
    return s.dot(surface.Q * s);
  };
  const double stretchAlong = -delta * curvature(along), stretchDown = -delta * curvature(down);
  for (Vec3& x : corners) {
    const double depth = x.z() / down.z();
    x += delta * outward / outward.squaredNorm() +
         stretchAlong * along.dot(x - frame.origin) * along + stretchDown * depth * down;
  }
}

Panel moved(const Panel& panel, const Frame& frame, const Paraboloid& surface) {
  const double delta = surface.trust * meanHeight(panel, frame, surface);
  if (delta == 0.0 || std::abs(delta) > kMost * diameter(panel)) return panel;
  std::vector<Vec3> corners(panel.corner.begin(), panel.corner.begin() + panel.corners);
  const bool atWaterline =
      std::any_of(corners.begin(), corners.end(), [](const Vec3& x) { return x.z() == 0.0; });
  if (!atWaterline)
    offset(corners, frame, surface, delta);
  else if (frame.n.head<2>().squaredNorm() > kSteepEnough)
    offsetAtWaterline(corners, frame, surface, delta);
  for (Vec3& x : corners) x.z() = std::min(x.z(), 0.0);
  return flatPanel(corners);
}

/// Bend of the surface over a panel, 0 where it is not believed.
Eigen::Matrix3d bendOf(const Frame& frame, const Paraboloid& surface) {
  Eigen::Matrix<double, 3, 2> plane;
  plane << frame.u, frame.v;
  return surface.trust * plane * surface.Q * plane.transpose();
}

/// ∫ s × n dS over a curved patch, n = n₀ − bend·s: −∫ s × (bend s) dS.
Vec3 coupleOf(const Panel& panel, const Eigen::Matrix3d& bend) {
  const Eigen::Matrix3d twist = secondMoments(panel) * bend;
  return -Vec3(twist(1, 2) - twist(2, 1), twist(2, 0) - twist(0, 2), twist(0, 1) - twist(1, 0));
}

/// Vector areas of the patches over the faces: those of the faces, and along each edge e the sliver
/// ⅔ s × e up to the arc of the surface above it, s the arc's height over the middle. What a face
/// gains its neighbour loses: the sum over all is that within the arcs of the waterline.
class PatchAreas {
 public:
  /// @param panels unmoved, with the bends of their patches.
  PatchAreas(const SurfaceMesh& wet, const PanelMesh& panels) : wet_(wet), panels_(panels) {
    for (std::size_t f = 0; f < wet.faces.size(); ++f)
      for (int i = 0; i < wet.faces[f].size(); ++i) facesOf_[edge(f, i)].push_back(f);
  }
  Vec3 of(std::size_t f) const {
    Vec3 area = vectorArea(wet_, wet_.faces[f]);
    for (int i = 0; i < wet_.faces[f].size(); ++i) {
      const Vec3 along = corner(f, i + 1) - corner(f, i);
      area += 2.0 / 3.0 * arcHeight(f, i, along).cross(along);
    }
    return area;
  }

 private:
  int vertex(std::size_t f, int i) const { return wet_.faces[f][i % wet_.faces[f].size()]; }
  const Vec3& corner(std::size_t f, int i) const {
    return wet_.vertices[static_cast<std::size_t>(vertex(f, i))];
  }
  std::pair<int, int> edge(std::size_t f, int i) const {
    return std::minmax(vertex(f, i), vertex(f, i + 1));
  }
  /// Where the arc rises to: of a loose edge on calm water or on the centreline within that plane.
  Vec3 outward(std::size_t f, int i, const std::vector<std::size_t>& faces) const {
    Vec3 normal = Vec3::Zero();
    for (const std::size_t g : faces) normal += panels_.panels[g].normal;
    if (faces.size() > 1) return normal.normalized();
    const Vec3 &a = corner(f, i), &b = corner(f, i + 1);
    if (a.z() == 0.0 && b.z() == 0.0) normal.z() = 0.0;
    if (panels_.symmetric && a.y() == 0.0 && b.y() == 0.0) normal.y() = 0.0;
    return normal.normalized();
  }
  /// From the bends of the panels on both sides; none where they meet at a crease.
  Vec3 arcHeight(std::size_t f, int i, const Vec3& along) const {
    constexpr double kHalfCrease = 0.966;  // cos 15°
    const std::vector<std::size_t>& faces = facesOf_.at(edge(f, i));
    const Vec3 rise = outward(f, i, faces);
    double height = 0.0;
    for (const std::size_t g : faces) {
      const double tilt = rise.dot(panels_.panels[g].normal);
      if (!(tilt > kHalfCrease)) return Vec3::Zero();
      height -= along.dot(panels_.patches[g].bend * along) / (8.0 * tilt);
    }
    return height / static_cast<double>(faces.size()) * rise;
  }

  const SurfaceMesh& wet_;
  const PanelMesh& panels_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> facesOf_;
};

}  // namespace

PanelMesh solverPanels(const SurfaceMesh& wet, bool symmetric, PanelShape shape) {
  PanelMesh mesh = makePanels(wet, symmetric);
  if (shape == PanelShape::FlattenedOnly) mesh.patches.clear();
  if (shape == PanelShape::FlattenedOnly || shape == PanelShape::Flat) return mesh;
  // The port faces come first in the whole surface, in their order.
  const SurfaceMesh whole = symmetric ? bothHalves(wet) : wet;
  const Neighbourhood neighbours(whole);
  std::vector<Panel> panels;
  for (std::size_t f = 0; f < mesh.panels.size(); ++f) {
    const Frame frame(mesh.panels[f]);
    Paraboloid surface = paraboloid(whole, whole.faces[f], neighbours.of(f), frame);
    if (shape == PanelShape::Auto) surface = neighbours.borneOut(f, frame, surface);
    panels.push_back(moved(mesh.panels[f], frame, surface));
    PanelPatch& patch = mesh.patches[f];
    patch.curved = surface.trust;
    patch.bend = bendOf(frame, surface);
    // About the centroid of the moved panel.
    patch.couple += (mesh.panels[f].centroid - panels.back().centroid).cross(patch.vectorArea);
    if (!patch.bend.isZero(0.0))
      patch.couple = (1.0 - surface.trust) * patch.couple + coupleOf(panels.back(), patch.bend);
  }
  const PatchAreas areas(wet, mesh);
  for (std::size_t f = 0; f < mesh.panels.size(); ++f) mesh.patches[f].vectorArea = areas.of(f);
  mesh.panels = std::move(panels);
  if (shape == PanelShape::MovedOnly) mesh.patches.clear();
  return mesh;
}

}  // namespace cutwater
