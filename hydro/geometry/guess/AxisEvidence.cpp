#include "hydro/geometry/guess/AxisEvidence.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/MeshEdges.h"

namespace cutwater {

namespace {

constexpr double kWeld = 1e-5;       // of the size
constexpr double kNearPlane = 2e-3;  // of the size along the axis

// Where the loose edges of a mesh lie.
struct LooseEdges {
  Vec3 mean = Vec3::Constant(-1.0);  // 0 to 1 in the box; −1 without any
  double length = 0.0;
  Vec3 atZero = Vec3::Zero();  // length of those in the plane 0 of each axis
};

LooseEdges looseEdgesOf(const SurfaceMesh& mesh, const Vec3& low, const Vec3& size) {
  const SurfaceMesh joined = welded(mesh, kWeld * size.norm());
  LooseEdges loose;
  Vec3 sum = Vec3::Zero();
  for (const OpenEdge& edge : looseEdges(joined)) {
    const Vec3 a = joined.vertices[static_cast<std::size_t>(edge.from)];
    const Vec3 b = joined.vertices[static_cast<std::size_t>(edge.to)];
    const double length = (b - a).norm();
    loose.length += length;
    sum += length * (0.5 * (a + b) - low).cwiseQuotient(size);
    for (int axis = 0; axis < 3; ++axis) {
      const double near = kNearPlane * size[axis];
      if (std::abs(a[axis]) < near && std::abs(b[axis]) < near) loose.atZero[axis] += length;
    }
  }
  if (loose.length > 0.5 * size.maxCoeff()) loose.mean = sum / loose.length;
  return loose;
}

// Mean depth of what a surface of these heights, 0 to 1, holds when it is filled from above.
template <typename Height>
double heldOn(const TwoSidedView& view, const Height& height) {
  constexpr int n = TwoSidedView::kCells;
  // The level at which it runs over: no lower than the ground, nor than the lowest way out.
  std::vector<double> level(view.cells.size(), 1.0);
  const auto at = [&](int i, int j) {
    const bool inside = i >= 0 && j >= 0 && i < n && j < n && view.at(i, j).seen();
    return inside ? level[static_cast<std::size_t>(j * n + i)] : 0.0;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int k = 0; k < 2 * n * n; ++k) {  // forth and back, so that a few rounds are enough
      const int c = k < n * n ? k : 2 * n * n - 1 - k, i = c % n, j = c / n;
      if (!view.at(i, j).seen()) continue;
      const double out = std::min({at(i - 1, j), at(i + 1, j), at(i, j - 1), at(i, j + 1)});
      const double lower = std::max(height(view.at(i, j)), out);
      double& here = level[static_cast<std::size_t>(c)];
      changed = changed || lower < here;
      here = std::min(here, lower);
    }
  }
  double depth = 0.0;
  int seen = 0;
  for (std::size_t c = 0; c < view.cells.size(); ++c) {
    if (!view.cells[c].seen()) continue;
    ++seen;
    depth += level[c] - height(view.cells[c]);
  }
  return seen > 0 ? depth / seen : 0.0;
}

void add(std::vector<Evidence>& list, double weight, const std::string& reason) {
  if (weight != 0.0) list.push_back({weight, reason});
}

}  // namespace

AxisEvidence::AxisEvidence(const SurfaceMesh& mesh) {
  const Bounds box = bounds(mesh);
  low_ = box.low;
  high_ = box.high;
  size_ = (high_ - low_).cwiseMax(1e-9 * box.diagonal());
  const std::vector<SurfaceSample> samples = surfaceSamples(mesh);
  const Occupied occupied(samples);
  const LooseEdges loose = looseEdgesOf(mesh, low_, size_);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = index(axis);
    mirror_[i] = mirrorShare(samples, occupied, axis);
    const double a = size_[(axis + 1) % 3], b = size_[(axis + 2) % 3];
    if (std::abs(a - b) < 0.03 * std::max(a, b))
      quarter_[i] = quarterTurnShare(samples, occupied, axis);
    views_[i] = viewAlong(samples, axis);
    openHeight_[i] = loose.mean[axis];
    const double near = kNearPlane * size_[axis];
    endsAtZero_[i] = (std::abs(low_[axis]) < near || std::abs(high_[axis]) < near) &&
                     loose.atZero[axis] > 0.3 * size_.maxCoeff();
  }
}

// Share of the plan that is level seen from the end of the axis, less that seen from its beginning.
double AxisEvidence::levelTop(int axis) const {
  int seen = 0, balance = 0;
  for (const TwoSidedView::Cell& cell : views_[index(axis)].cells) {
    if (!cell.seen()) continue;
    ++seen;
    balance += (cell.highLevel ? 1 : 0) - (cell.lowLevel ? 1 : 0);
  }
  return seen > 0 ? static_cast<double>(balance) / seen : 0.0;
}

// How deep rain would stand on it, over its plan, less how deep air would be caught below it, in
// parts of its height: about a half for a bowl, minus as much for one turned over. The tunnel of
// twin hulls is open at its ends and holds nothing.
double AxisEvidence::bowl(int axis) const {
  const TwoSidedView& view = views_[index(axis)];
  return heldOn(view, [](const TwoSidedView::Cell& cell) { return cell.high; }) -
         heldOn(view, [](const TwoSidedView::Cell& cell) { return 1.0 - cell.low; });
}

// Most of the plan is covered at that end, so that no open edge there opens it.
bool AxisEvidence::closedAtEnd(int axis, bool high) const {
  int seen = 0, covered = 0;
  for (const TwoSidedView::Cell& cell : views_[index(axis)].cells) {
    if (!cell.seen()) continue;
    ++seen;
    covered += (high ? cell.high > 0.97 : cell.low < 0.03) ? 1 : 0;
  }
  return 2 * covered > seen;
}

// Share of the plan's rectangle that is filled in the last sixth at one end.
double AxisEvidence::endShare(int up, int axis, bool high) const {
  const TwoSidedView& view = views_[index(up)];
  constexpr int n = TwoSidedView::kCells, part = n / 6;
  int seen = 0;
  for (int i = high ? n - part : 0; i < (high ? n : part); ++i)
    for (int j = 0; j < n; ++j)
      seen += (view.along == axis ? view.at(i, j) : view.at(j, i)).seen() ? 1 : 0;
  return static_cast<double>(seen) / (part * n);
}

std::vector<Evidence> AxisEvidence::up(int axis, int sign) const {
  std::vector<Evidence> list;
  const std::size_t i = index(axis);
  const double level = sign * levelTop(axis), held = sign * bowl(axis);
  add(list, 5.0 * level,
      level > 0.0 ? "the side that looks this way is level, the other is not"
                  : "the other side is the level one");
  add(list, 10.0 * held,
      held > 0.0 ? "it is a bowl that opens this way" : "it opens the other way");
  if (openHeight_[i] >= 0.0 && !closedAtEnd(axis, openHeight_[i] > 0.5)) {
    const double open = sign * (openHeight_[i] - 0.5);
    add(list, 4.0 * open,
        open > 0.0 ? "its open edges are on this side" : "its open edges are not");
  }
  add(list, -3.0 * std::max(0.0, mirror_[i] - 0.8) / 0.2, "it is a mirror image across it");
  const double offset = std::abs(0.5 * (low_[axis] + high_[axis])) / size_[axis];
  add(list, offset > 0.02 ? 0.7 : -0.5, "the file's origin is not in the middle of it");
  const double wide = std::max(size_[(axis + 1) % 3], size_[(axis + 2) % 3]);
  if (turnsAbout(axis))
    add(list, 4.0, "the body is alike after a quarter turn about it");
  else
    add(list, -3.0 * std::clamp(std::log(size_[axis] / wide), 0.0, 2.0), "it would stand on end");
  const double under = -(sign > 0 ? low_[axis] : -high_[axis]) / size_[axis];
  if (under > 0.55 && under < 1.1 && turnsAbout(axis))
    add(list, 2.2, "most of it lies below the file's 0");
  return list;
}

std::vector<Evidence> AxisEvidence::forward(int axis, int sign, int up) const {
  std::vector<Evidence> list;
  const int side = 3 - axis - up;
  const double ratio = std::log(size_[axis] / size_[side]);
  add(list, std::clamp(3.0 * ratio, -4.0, 1.5), "it is the longer way");
  const double image = endsAtZero_[index(side)] ? 0.97 : mirror_[index(side)];
  add(list, 5.0 * (std::max(image, 0.5) - 0.5), "port and starboard are alike then");
  if (!turnsAbout(up))
    add(list, std::clamp(2.0 * std::log(size_[side] / size_[up]), -2.0, 1.5),
        "it is broader than high then");
  const double fine = endShare(up, axis, sign < 0) - endShare(up, axis, sign > 0);
  add(list, std::clamp(12.0 * fine, -5.0, 5.0),
      fine > 0.0 ? "the plan is finer at this end" : "the plan is fuller at this end");
  return list;
}

}  // namespace cutwater
