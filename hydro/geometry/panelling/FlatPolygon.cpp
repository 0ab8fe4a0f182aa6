#include "hydro/geometry/panelling/FlatPolygon.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cutwater {
namespace {

constexpr double kFromOutline =
    0.6;  // of the panel size: no vertex inside is nearer to the outline
constexpr double kSquareEnough = 0.6;  // least sine of a corner of a quadrilateral
constexpr double kSame = 1e-9;         // of qualities
constexpr int kEarPasses = 100;

class FlatTriangles {
 public:
  /// The outline's own triangles: the best ear is clipped first.
  FlatTriangles(const std::vector<int>& outline, SurfaceMesh& mesh) : mesh_(mesh) {
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
      normal_ += (at(outline[i]) - at(outline[0])).cross(at(outline[i + 1]) - at(outline[0]));
    normal_.normalize();
    for (std::vector<int> left = outline; left.size() > 2;) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < left.size(); ++i)
        if (earQuality(left, i) > earQuality(left, best)) best = i;
      faces_.push_back(ear(left, best));
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }

  /// Vertices on a level grid.
  void addInside(const std::vector<int>& outline, double size) {
    const Vec3 across = Vec3::UnitZ().cross(normal_).normalized(), down = across.cross(normal_);
    SurfaceMesh seen;
    for (const int v : outline)
      seen.vertices.emplace_back(across.dot(at(v) - at(outline[0])),
                                 down.dot(at(v) - at(outline[0])), 0.0);
    const Bounds box = bounds(seen);
    const Vec3 extent = box.high - box.low;
    const int columns = std::max(1, static_cast<int>(std::lround(extent.x() / size))),
              rows = std::max(1, static_cast<int>(std::lround(extent.y() / size)));
    for (int r = 1; r < rows; ++r)
      for (int c = 1; c < columns; ++c)
        add(at(outline[0]) + (box.low.x() + extent.x() * c / columns) * across +
                (box.low.y() + extent.y() * r / rows) * down,
            outline, kFromOutline * size);
  }

  /// Turns the common edge of two triangles where that makes the worse of them better, or the
  /// better if the worse stays.
  void improve() {
    bool changed = true;
    for (int pass = 0; changed && pass < kEarPasses; ++pass) {
      changed = false;
      for (const auto& [edge, pair] : pairs())
        changed =
            turn(static_cast<std::size_t>(pair.first), static_cast<std::size_t>(pair.second)) ||
            changed;
    }
  }

  void addTo(SurfaceMesh& mesh) const {
    std::vector<std::pair<double, std::pair<int, int>>> good;
    for (const auto& [edge, pair] : pairs())
      if (const double q = squareness(quadrilateral(pair.first, pair.second)); q > kSquareEnough)
        good.emplace_back(-q, pair);
    std::sort(good.begin(), good.end());
    std::vector<bool> used(faces_.size(), false);
    for (const auto& [q, pair] : good) {
      const auto a = static_cast<std::size_t>(pair.first),
                 b = static_cast<std::size_t>(pair.second);
      if (used[a] || used[b]) continue;
      used[a] = used[b] = true;
      mesh.faces.push_back(quadrilateral(pair.first, pair.second));
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (!used[f]) mesh.faces.push_back(faces_[f]);
  }

 private:
  const Vec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
  double area2(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return normal_.dot((b - a).cross(c - a));
  }

  static Face ear(const std::vector<int>& left, std::size_t i) {
    const std::size_t n = left.size();
    return {{left[(i + n - 1) % n], left[i], left[(i + 1) % n], -1}};
  }

  /// Negative if it is none: re-entrant, or with another vertex in it.
  double earQuality(const std::vector<int>& left, std::size_t i) const {
    const Face f = ear(left, i);
    const double q = quality(f[0], f[1], f[2]);
    if (!(q > 0.0)) return -1.0;
    for (const int v : left)
      if (v != f[0] && v != f[1] && v != f[2] && isIn(f, at(v))) return -1.0;
    return q;
  }

  bool isIn(const Face& f, const Vec3& p) const {
    for (int i = 0; i < 3; ++i)
      if (area2(at(f[i]), at(f[(i + 1) % 3]), p) < 0.0) return false;
    return true;
  }

  /// Each pair of triangles with a common edge.
  std::map<std::pair<int, int>, std::pair<int, int>> pairs() const {
    std::map<std::pair<int, int>, std::pair<int, int>> all;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const std::pair<int, int> edge = std::minmax(faces_[f][i], faces_[f][(i + 1) % 3]);
        const auto [place, first] = all.try_emplace(edge, static_cast<int>(f), -1);
        if (!first) place->second.second = static_cast<int>(f);
      }
    std::erase_if(all, [](const auto& entry) { return entry.second.second < 0; });
    return all;
  }

  /// Around both triangles, beginning with the corner of the first that is not the other's; none
  /// (−1) if they no longer touch.
  Face quadrilateral(int first, int second) const {
    const Face &a = faces_[static_cast<std::size_t>(first)],
               &b = faces_[static_cast<std::size_t>(second)];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (a[(i + 1) % 3] == b[(k + 2) % 3] && a[(i + 2) % 3] == b[(k + 1) % 3])
          return {{a[i], a[(i + 1) % 3], b[k], a[(i + 2) % 3]}};
    return {};
  }

  /// Least sine of its corners, negative if one is re-entrant.
  double squareness(const Face& q) const {
    if (q[0] < 0) return -1.0;
    double least = 1.0;
    for (int i = 0; i < 4; ++i) {
      const Vec3 &a = at(q[(i + 3) % 4]), &b = at(q[i]), &c = at(q[(i + 1) % 4]);
      least = std::min(least, area2(a, b, c) / ((b - a).norm() * (c - b).norm()));
    }
    return least;
  }

  /// Of a triangle: twice its area by the square of its longest edge.
  double quality(int a, int b, int c) const {
    const double longest2 = std::max({(at(b) - at(a)).squaredNorm(), (at(c) - at(b)).squaredNorm(),
                                      (at(a) - at(c)).squaredNorm()});
    return area2(at(a), at(b), at(c)) / longest2;
  }

  bool turn(std::size_t first, std::size_t second) {
    const Face q = quadrilateral(static_cast<int>(first), static_cast<int>(second));
    if (q[0] < 0) return false;
    const auto now = std::minmax({quality(q[0], q[1], q[3]), quality(q[1], q[2], q[3])}),
               turned = std::minmax({quality(q[0], q[1], q[2]), quality(q[0], q[2], q[3])});
    const double gain = turned.first - now.first;
    if (gain < -kSame || (gain < kSame && turned.second < now.second + kSame)) return false;
    faces_[first] = {{q[0], q[1], q[2], -1}};
    faces_[second] = {{q[0], q[2], q[3], -1}};
    return true;
  }

  double fromOutline(const Vec3& p, const std::vector<int>& outline) const {
    double least = 1e300;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec3 &a = at(outline[i]), step = at(outline[(i + 1) % outline.size()]) - a;
      const double t =
          std::clamp((p - a).dot(step) / std::max(step.squaredNorm(), 1e-300), 0.0, 1.0);
      least = std::min(least, (a + t * step - p).norm());
    }
    return least;
  }

  /// The triangle that the point lies in becomes three.
  void add(const Vec3& p, const std::vector<int>& outline, double distance) {
    if (fromOutline(p, outline) < distance) return;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Face t = faces_[f];
      if (!isIn(t, p)) continue;
      const int v = static_cast<int>(mesh_.vertices.size());
      mesh_.vertices.push_back(p);
      faces_[f] = {{t[0], t[1], v, -1}};
      faces_.push_back({{t[1], t[2], v, -1}});
      faces_.push_back({{t[2], t[0], v, -1}});
      improve();
      return;
    }
  }

  SurfaceMesh& mesh_;
  Vec3 normal_ = Vec3::Zero();
  std::vector<Face> faces_;
};

}  // namespace

void addFlatPolygon(const std::vector<int>& outline, double size, SurfaceMesh& mesh) {
  FlatTriangles triangles(outline, mesh);
  triangles.improve();
  triangles.addInside(outline, size);
  triangles.addTo(mesh);
}

}  // namespace cutwater
