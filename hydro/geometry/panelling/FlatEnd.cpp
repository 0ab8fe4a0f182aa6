#include "hydro/geometry/panelling/FlatEnd.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/FlatPolygon.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panelling/PanelRows.h"

namespace cutwater {
namespace {

constexpr double kLeastRow =
    0.3;  // of the panel size: outline vertices closer in height share a row
constexpr double kBottomRow = 0.35;  // as near as this to the last row, the outline is that row

constexpr double kNothing = 1e-3;  // of a panel's area

class EndRows {
 public:
  EndRows(const std::vector<int>& outline, bool aft, double size, SurfaceMesh& mesh)
      : left_(outline), aft_(aft), size_(size), mesh_(mesh) {
    toCentreline_ = at(outline.back()).y() == 0.0 && at(outline.back()).z() < 0.0;
    if (toCentreline_) return;
    const auto lower = [&](int p, int q) { return at(p).z() < at(q).z(); };
    const auto lowest = std::min_element(outline.begin(), outline.end(), lower);
    left_.assign(outline.begin(), lowest + 1);
    right_.assign(outline.rbegin(), std::make_reverse_iterator(lowest));
  }

  void addRows() {
    std::size_t i = 0, k = 0;
    std::vector<int> upper = withInner(left_[0], toCentreline_ ? centreAt(left_[0]) : right_[0]);
    for (;;) {
      std::size_t j = i + 1, m = k;
      while (j + 1 < left_.size() && at(left_[i]).z() - at(left_[j]).z() < kLeastRow * size_) ++j;
      if (isBottom(j)) {
        addBetween(upper, rest(i, k));
        return;
      }
      std::vector<int> lower(left_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             left_.begin() + static_cast<std::ptrdiff_t>(j));
      if (!toCentreline_) m = levelWith(left_[j], k);
      for (const int v : withInner(left_[j], toCentreline_ ? centreAt(left_[j]) : right_[m]))
        lower.push_back(v);
      for (std::size_t r = m; r > k + 1; --r) lower.push_back(right_[r - 1]);
      addBetween(upper, lower);
      upper = withoutSides(lower, j - i - 1, toCentreline_ || m <= k + 1 ? 0 : m - k - 1);
      i = j;
      k = m;
    }
  }

 private:
  const Vec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }

  int centreAt(int v) {
    Vec3 p = at(v);
    if (p.y() == 0.0) return v;
    p.y() = 0.0;
    mesh_.vertices.push_back(p);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  /// A row from one vertex to another with new vertices between.
  std::vector<int> withInner(int from, int to) {
    std::vector<int> row{from};
    const Vec3 a = at(from), b = at(to);
    const int parts = std::max(1, static_cast<int>(std::lround((b - a).norm() / size_)));
    for (int p = 1; p < parts; ++p) {
      mesh_.vertices.push_back(a + (b - a) * p / parts);
      row.push_back(static_cast<int>(mesh_.vertices.size()) - 1);
    }
    if (to != from) row.push_back(to);
    return row;
  }

  std::vector<int> withoutSides(const std::vector<int>& row, std::size_t first, std::size_t last) {
    return {row.begin() + static_cast<std::ptrdiff_t>(first),
            row.end() - static_cast<std::ptrdiff_t>(last)};
  }

  bool isBottom(std::size_t j) const {
    for (std::size_t n = j; n < left_.size(); ++n)
      if (at(left_[n]).z() < at(left_[j]).z() - kBottomRow * size_) return false;
    return true;
  }

  /// What is left of the outline below rows i and k.
  std::vector<int> rest(std::size_t i, std::size_t k) const {
    std::vector<int> row(left_.begin() + static_cast<std::ptrdiff_t>(i) + 1, left_.end());
    if (!toCentreline_)
      for (std::size_t r = right_.size() - 1; r > k + 1; --r) row.push_back(right_[r - 1]);
    return row;
  }

  std::size_t levelWith(int v, std::size_t from) const {
    std::size_t best = from;
    for (std::size_t m = from; m < right_.size(); ++m)
      if (std::abs(at(right_[m]).z() - at(v).z()) < std::abs(at(right_[best]).z() - at(v).z()))
        best = m;
    return best;
  }

  void addBetween(const std::vector<int>& upper, const std::vector<int>& lower) {
    const auto across = [&](const std::vector<int>& row) {
      std::vector<double> y;
      for (const int v : row) y.push_back(-at(v).y());
      return y;
    };
    if (aft_)
      addPanelsBetween(upper, across(upper), lower, across(lower), mesh_);
    else
      addPanelsBetween(lower, across(lower), upper, across(upper), mesh_);
  }

  std::vector<int> left_, right_;  ///< both sides of the outline from the top to the lowest vertex
  bool toCentreline_ = false;      ///< the right side is the centreline
  bool aft_;
  double size_;
  SurfaceMesh& mesh_;
};

/// The outline closed along calm water, or by the centreline and calm water, counter-clockwise
/// about the end's normal.
std::vector<int> closedOutline(std::vector<int> outline, bool aft, double size, SurfaceMesh& mesh) {
  const auto add = [&](const Vec3& p) {
    mesh.vertices.push_back(p);
    outline.push_back(static_cast<int>(mesh.vertices.size()) - 1);
  };
  const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  const auto lineTo = [&](const Vec3& to) {
    const Vec3 from = at(outline.back());
    const int parts = std::max(1, static_cast<int>(std::lround((to - from).norm() / size)));
    for (int p = 1; p < parts; ++p) add(from + (to - from) * p / parts);
  };
  const Vec3 first = at(outline.front());
  if (at(outline.back()).y() == 0.0 && at(outline.back()).z() < 0.0 && first.y() != 0.0) {
    const Vec3 middle(first.x(), 0.0, first.z());
    lineTo(middle);
    add(middle);
  }
  if (at(outline.back()) == first)
    outline.pop_back();
  else
    lineTo(first);
  if (!aft) std::reverse(outline.begin(), outline.end());
  return outline;
}

/// Stretched faces from `first` on, or all of them if one is turned over or has no area.
std::size_t stretchedFaces(const SurfaceMesh& mesh, std::size_t first, double size, double side) {
  std::size_t stretched = 0;
  for (std::size_t f = first; f < mesh.faces.size(); ++f) {
    if (side * vectorArea(mesh, mesh.faces[f]).x() < kNothing * size * size)
      return mesh.faces.size();
    stretched += aspectRatio(mesh, mesh.faces[f]) > kStretched ? 1 : 0;
  }
  return stretched;
}

}  // namespace

void addFlatEnd(const std::vector<int>& outline, bool aft, double size, SurfaceMesh& mesh) {
  if (outline.size() < 2) return;
  const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  Vec3 corner = at(outline.front());  // where calm water meets the centreline
  if (at(outline.back()).y() == 0.0) corner.y() = 0.0;
  Vec3 enclosed = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
    enclosed += 0.5 * (at(outline[i]) - corner).cross(at(outline[i + 1]) - corner);
  if (std::abs(enclosed.x()) < kNothing * size * size) return;
  const double side = aft ? -1.0 : 1.0;
  SurfaceMesh rows = mesh;
  EndRows(outline, aft, size, rows).addRows();
  if (const auto worse = stretchedFaces(rows, mesh.faces.size(), size, side); worse > 0) {
    SurfaceMesh free = mesh;
    addFlatPolygon(closedOutline(outline, aft, size, free), size, free);
    if (stretchedFaces(free, mesh.faces.size(), size, side) < worse) rows = std::move(free);
  }
  mesh = std::move(rows);
}

}  // namespace cutwater
