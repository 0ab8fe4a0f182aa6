#include "hydro/geometry/repair/ShellSplit.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/SurfaceTree.h"
#include "hydro/geometry/repair/CrackClosing.h"

namespace cutwater {
namespace {

constexpr double kOnPlane = 1e-9;  // of the size: nearer to a plane than this is on it

using Triangle = std::array<Vec3, 3>;

struct CutPlane {
  Vec3 normal, point;
  double height(const Vec3& p) const { return normal.dot(p - point); }
};

CutPlane planeOf(const Triangle& t) {
  return {(t[1] - t[0]).cross(t[2] - t[0]).normalized(), t[0]};
}

/// From where to where, along a direction, a triangle lies in a plane; empty if it does not cross
/// it.
struct Range {
  double from = 1e300, to = -1e300;
  void add(double s) {
    from = std::min(from, s);
    to = std::max(to, s);
  }
  bool empty() const { return !(from < to); }
};

std::array<double, 3> heights(const Triangle& t, const CutPlane& plane, double tolerance) {
  std::array<double, 3> h{};
  for (std::size_t i = 0; i < 3; ++i) {
    h[i] = plane.height(t[i]);
    if (std::abs(h[i]) <= tolerance) h[i] = 0.0;
  }
  return h;
}

Range rangeIn(const Triangle& t, const CutPlane& plane, const Vec3& along, double tolerance) {
  const std::array<double, 3> h = heights(t, plane, tolerance);
  Range range;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (h[i] == 0.0) range.add(along.dot(t[i]));
    if (h[i] * h[j] < 0) range.add(along.dot(t[i] + h[i] / (h[i] - h[j]) * (t[j] - t[i])));
  }
  return range;
}

/// Do the triangles share more than a point of the line in which their planes meet?
bool cross(const Triangle& a, const Triangle& b, double tolerance) {
  const CutPlane planeA = planeOf(a), planeB = planeOf(b);
  const Vec3 along = planeA.normal.cross(planeB.normal);
  if (along.norm() < 1e-6) return false;
  const Vec3 line = along.normalized();
  const Range ra = rangeIn(a, planeB, line, tolerance), rb = rangeIn(b, planeA, line, tolerance);
  if (ra.empty() || rb.empty()) return false;
  return std::min(ra.to, rb.to) - std::max(ra.from, rb.from) > 10 * tolerance;
}

/// Adds the parts of a triangle above and below a plane.
void splitBy(const CutPlane& plane, const Triangle& t, double tolerance,
             std::vector<Triangle>& out) {
  const std::array<double, 3> h = heights(t, plane, tolerance);
  std::vector<Vec3> above, below;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (h[i] >= 0) above.push_back(t[i]);
    if (h[i] <= 0) below.push_back(t[i]);
    if (h[i] * h[j] >= 0) continue;
    const Vec3 p = t[i] + h[i] / (h[i] - h[j]) * (t[j] - t[i]);
    above.push_back(p);
    below.push_back(p);
  }
  for (const auto& part : {above, below})
    for (std::size_t i = 1; i + 1 < part.size(); ++i)
      out.push_back({part[0], part[i], part[i + 1]});
}

// To look at each part from the water takes about two milliseconds.
constexpr std::size_t kMostParts = 2000;

class Splitter {
 public:
  explicit Splitter(const SurfaceMesh& mesh)
      : mesh_(mesh), tree_(mesh), tolerance_(kOnPlane * bounds(mesh).diagonal()) {}

  SplitSurface split() {
    out_.mesh.vertices = mesh_.vertices;
    for (std::size_t f = 0; f < mesh_.faces.size() && !out_.gaveUp; ++f)
      for (int i = 1; i + 1 < mesh_.faces[f].size(); ++i)
        addFace(f, {mesh_.faces[f][0], mesh_.faces[f][i], mesh_.faces[f][i + 1]});
    if (out_.gaveUp) return std::move(out_);
    const std::size_t whole = out_.mesh.faces.size();
    out_.firstCut = static_cast<int>(welded(out_.mesh, 0.0).vertices.size());
    const double together = kTogether / kOnPlane * tolerance_;
    out_.mesh = withoutCracks(welded(joined(out_.mesh, parts_), together), together, whole);
    return std::move(out_);
  }

 private:
  Triangle triangle(const std::array<int, 3>& v) const {
    const auto at = [&](std::size_t i) { return mesh_.vertices[static_cast<std::size_t>(v[i])]; };
    return {at(0), at(1), at(2)};
  }

  void addFace(std::size_t face, const std::array<int, 3>& v) {
    const Triangle own = triangle(v);
    std::vector<Triangle> fragments{own};
    for (const Triangle& other : crossing(face, v, own)) {
      const CutPlane plane = planeOf(other);
      std::vector<Triangle> next;
      for (const Triangle& f : fragments)
        if (cross(f, other, tolerance_))
          splitBy(plane, f, tolerance_, next);
        else
          next.push_back(f);
      fragments = std::move(next);
    }
    if (fragments.size() == 1) {
      out_.mesh.faces.push_back({{v[0], v[1], v[2], -1}});
      return;
    }
    if (out_.split++ == 0) out_.first = own[0];
    for (const Triangle& f : fragments) {
      const int first = static_cast<int>(parts_.vertices.size());
      parts_.vertices.insert(parts_.vertices.end(), f.begin(), f.end());
      parts_.faces.push_back({{first, first + 1, first + 2, -1}});
    }
    out_.gaveUp = parts_.faces.size() > kMostParts;
  }

  /// Triangles without a common vertex that pass through this one.
  std::vector<Triangle> crossing(std::size_t face, const std::array<int, 3>& v,
                                 const Triangle& own) const {
    const Vec3 low = own[0].cwiseMin(own[1]).cwiseMin(own[2]),
               high = own[0].cwiseMax(own[1]).cwiseMax(own[2]);
    std::vector<Triangle> found;
    for (const int g : tree_.near(low, high)) {
      if (g == static_cast<int>(face)) continue;
      const Face& other = mesh_.faces[static_cast<std::size_t>(g)];
      bool neighbour = false;
      for (int i = 0; i < other.size(); ++i)
        neighbour = neighbour || std::find(v.begin(), v.end(), other[i]) != v.end();
      if (neighbour) continue;
      for (int i = 1; i + 1 < other.size(); ++i) {
        const Triangle t = triangle({other[0], other[i], other[i + 1]});
        if (cross(own, t, tolerance_)) found.push_back(t);
      }
    }
    return found;
  }

  const SurfaceMesh& mesh_;
  SurfaceTree tree_;
  double tolerance_;
  SurfaceMesh parts_;  ///< of split faces, each with vertices of its own
  SplitSurface out_;
};

}  // namespace

SplitSurface splitWhereCrossing(const SurfaceMesh& mesh) { return Splitter(mesh).split(); }

}  // namespace cutwater
