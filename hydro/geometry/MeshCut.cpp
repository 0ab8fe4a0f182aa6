#include "hydro/geometry/MeshCut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

using Polygon = std::vector<int>;

class Cutter {
 public:
  Cutter(const SurfaceMesh& mesh, const Plane& plane, double tolerance)
      : plane_(plane), out_{mesh.vertices, {}} {
    for (Vec3& p : out_.vertices) {
      double d = plane.normal.dot(p) - plane.offset;
      if (std::abs(d) <= tolerance) {
        p = onPlane(p);
        d = 0.0;
      }
      height_.push_back(d);
    }
  }

  void add(const Face& f) {
    int above = 0, below = 0, changes = 0;
    for (int i = 0; i < f.size(); ++i) {
      const double d = height(f[i]), next = height(f[(i + 1) % f.size()]);
      above += d > 0;
      below += d < 0;
      changes += d * next < 0;
    }
    if (below == 0) return;
    if (above == 0) {
      out_.faces.push_back(f);
    } else if (changes > 2 || (f.size() == 4 && above == 2 && changes == 0)) {
      // A twisted quadrilateral that the plane crosses twice: as two triangles.
      add({{f[0], f[1], f[2], -1}});
      add({{f[0], f[2], f[3], -1}});
    } else {
      emit(clipped(f));
    }
  }

  SurfaceMesh result() const { return welded(out_, 0.0); }

 private:
  double height(int i) const { return height_[static_cast<std::size_t>(i)]; }
  const Vec3& at(int i) const { return out_.vertices[static_cast<std::size_t>(i)]; }

  /// Exactly on the plane when it is a coordinate plane.
  Vec3 onPlane(const Vec3& p) const {
    Vec3 q = p - (plane_.normal.dot(p) - plane_.offset) * plane_.normal;
    for (int i = 0; i < 3; ++i)
      if (std::abs(plane_.normal[i]) == 1.0) q[i] = plane_.normal[i] * plane_.offset + 0.0;
    return q;
  }

  /// The vertex where an edge meets the plane, one for both faces that share it.
  int crossing(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [it, isNew] = crossing_.emplace(std::pair{a, b}, static_cast<int>(height_.size()));
    if (isNew) {
      const double t = height(a) / (height(a) - height(b));
      out_.vertices.push_back(onPlane(at(a) + t * (at(b) - at(a))));
      height_.push_back(0.0);
    }
    return it->second;
  }

  Polygon clipped(const Face& f) {
    Polygon p;
    for (int i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      if (height(a) <= 0) p.push_back(a);
      if (height(a) * height(b) < 0) p.push_back(crossing(a, b));
    }
    return p;
  }

  /// Area over the square of the longest side: 0 for a sliver.
  double quality(const Polygon& p) const {
    Vec3 area = Vec3::Zero();
    double longest2 = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3 &a = at(p[0]), &b = at(p[i]), &c = at(p[(i + 1) % p.size()]);
      area += 0.5 * (b - a).cross(c - a);
      longest2 = std::max(longest2, (c - b).squaredNorm());
    }
    return longest2 > 0 ? area.norm() / longest2 : 0.0;
  }

  void emit(const Polygon& p) {
    if (p.size() == 3) out_.faces.push_back({{p[0], p[1], p[2], -1}});
    if (p.size() == 4) out_.faces.push_back({{p[0], p[1], p[2], p[3]}});
    if (p.size() != 5) return;
    double best = -1.0;
    Polygon triangle, rest;
    for (std::size_t i = 0; i < 5; ++i) {
      const Polygon t{p[i], p[(i + 1) % 5], p[(i + 2) % 5]};
      const Polygon r{p[i], p[(i + 2) % 5], p[(i + 3) % 5], p[(i + 4) % 5]};
      const double worse = std::min(quality(t), quality(r));
      if (worse > best) {
        best = worse;
        triangle = t;
        rest = r;
      }
    }
    emit(triangle);
    emit(rest);
  }

  Plane plane_;
  SurfaceMesh out_;
  std::vector<double> height_;  ///< above the plane, per vertex of out_
  std::map<std::pair<int, int>, int> crossing_;
};

}  // namespace

SurfaceMesh cutBelow(const SurfaceMesh& mesh, const Plane& plane, double tolerance) {
  if (!(std::abs(plane.normal.norm() - 1.0) < 1e-12))
    throw HydroError(Fault::BadArgument, "cutBelow: the plane's normal has length " +
                                             std::to_string(plane.normal.norm()));
  if (tolerance < 0) tolerance = 1e-9 * bounds(mesh).diagonal();
  Cutter cutter(mesh, plane, tolerance);
  for (const Face& f : mesh.faces) cutter.add(f);
  return cutter.result();
}

SurfaceMesh cutAbove(const SurfaceMesh& mesh, const Plane& plane, double tolerance) {
  return cutBelow(mesh, {-plane.normal, -plane.offset}, tolerance);
}

SurfaceMesh withSplitWaterCorners(const SurfaceMesh& wet) {
  SurfaceMesh out{wet.vertices, {}};
  for (const Face& f : wet.faces) {
    int below = -1, onWater = 0;
    for (int i = 0; i < f.size(); ++i)
      if (wet.corner(f, i).z() == 0.0)
        ++onWater;
      else
        below = i;
    if (onWater == f.size()) continue;
    if (f.size() == 4 && onWater == 3) {
      const auto at = [&](int i) { return f[(below + i) % 4]; };
      out.faces.push_back({{at(0), at(1), at(2), -1}});
      out.faces.push_back({{at(0), at(2), at(3), -1}});
    } else {
      out.faces.push_back(f);
    }
  }
  return out;
}

}  // namespace cutwater
