#include "hydro/geometry/panels/Lid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kClosestStations =
    0.45;                           // of a panel length: nearer waterline vertices share a station
constexpr double kStraight = 0.05;  // of a panel length: smaller kinks are cut off

/// A closed boundary in the plane; `swapped` when its first coordinate is y instead of x.
struct Outline {
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 2>> segments;
  bool swapped = false;
  const Vec2& at(int i) const { return vertices[static_cast<std::size_t>(i)]; }
};

/// Between u0 and u1, from v = low to v = high, each given at both ends.
struct Trapezoid {
  double u0, u1, low0, low1, high0, high1;
};

class LidBuilder {
 public:
  explicit LidBuilder(double target) : target_(target) {}

  void cover(const Outline& outline, bool baseline, double closest);
  std::vector<Panel> panels;

 private:
  using Chain = std::vector<Vec2>;  ///< boundary across one slab, from u0 to u1

  std::vector<double> stations(const Outline& outline, double closest) const;
  std::vector<Chain> crossings(const Outline& outline, double u0, double u1) const;
  Chain follow(const Outline& outline, int segment, double u0, double u1) const;
  bool straight(const Chain& chain) const;
  void coverBetween(const Chain& low, const Chain& high, bool swapped);
  void divide(const Trapezoid& t, bool swapped);
  void add(const std::array<Vec2, 4>& corner, bool swapped);

  double target_;
};

bool isVertical(const Outline& o, const std::array<int, 2>& s) {
  return o.at(s[0]).x() == o.at(s[1]).x();
}

/// Stations at every vertex where the boundary turns back in u, and at all others not closer than
/// `closest` to one already taken.
std::vector<double> LidBuilder::stations(const Outline& o, double closest) const {
  std::vector<int> toLow(o.vertices.size(), 0), toHigh(o.vertices.size(), 0);
  for (const auto& s : o.segments) {
    if (isVertical(o, s)) continue;
    const bool rising = o.at(s[0]).x() < o.at(s[1]).x();
    ++toHigh[static_cast<std::size_t>(rising ? s[0] : s[1])];
    ++toLow[static_cast<std::size_t>(rising ? s[1] : s[0])];
  }
  std::vector<double> must, may, taken;
  for (std::size_t i = 0; i < o.vertices.size(); ++i) {
    if (toLow[i] == 1 && toHigh[i] == 1) {
      may.push_back(o.vertices[i].x());
    } else {
      must.push_back(o.vertices[i].x());
    }
  }
  std::sort(must.begin(), must.end());
  std::sort(may.begin(), may.end());
  must.erase(std::unique(must.begin(), must.end()), must.end());
  for (std::size_t i = 0; i < must.size(); ++i) {
    taken.push_back(must[i]);
    if (i + 1 == must.size()) break;
    for (double u : may)
      if (u >= taken.back() + closest && u <= must[i + 1] - closest) taken.push_back(u);
  }
  return taken;
}

/// The boundary through one segment, followed both ways to the sides of the slab.
LidBuilder::Chain LidBuilder::follow(const Outline& o, int segment, double u0, double u1) const {
  const auto otherSegment = [&](int vertex, int notThis) {
    for (int k = 0; k < static_cast<int>(o.segments.size()); ++k) {
      const auto& s = o.segments[static_cast<std::size_t>(k)];
      if (k != notThis && (s[0] == vertex || s[1] == vertex)) return k;
    }
    return -1;
  };
  const auto end = [&](int k, bool high) {
    const auto& s = o.segments[static_cast<std::size_t>(k)];
    return (o.at(s[0]).x() < o.at(s[1]).x()) == high ? s[1] : s[0];
  };
  const auto valueAt = [&](int k, double u) -> Vec2 {
    const Vec2 &a = o.at(end(k, false)), &b = o.at(end(k, true));
    if (u == a.x()) return a;
    if (u == b.x()) return b;
    return {u, a.y() + (b.y() - a.y()) * (u - a.x()) / (b.x() - a.x())};
  };
  Chain chain;
  int k = segment;
  while (o.at(end(k, false)).x() > u0) {
    const int vertex = end(k, false);
    const int next = otherSegment(vertex, k);
    if (next < 0) break;
    chain.insert(chain.begin(), o.at(vertex));
    k = next;
  }
  chain.insert(chain.begin(), valueAt(k, u0));
  k = segment;
  while (o.at(end(k, true)).x() < u1) {
    const int vertex = end(k, true);
    const int next = otherSegment(vertex, k);
    if (next < 0) break;
    chain.push_back(o.at(vertex));
    k = next;
  }
  chain.push_back(valueAt(k, u1));
  return chain;
}

/// Boundaries that cross the slab, from low to high v.
std::vector<LidBuilder::Chain> LidBuilder::crossings(const Outline& o, double u0, double u1) const {
  const double middle = 0.5 * (u0 + u1);
  std::vector<std::pair<double, int>> hits;
  for (int k = 0; k < static_cast<int>(o.segments.size()); ++k) {
    const auto& s = o.segments[static_cast<std::size_t>(k)];
    const Vec2 &a = o.at(s[0]), &b = o.at(s[1]);
    if (std::min(a.x(), b.x()) < middle && std::max(a.x(), b.x()) >= middle)
      hits.emplace_back(a.y() + (b.y() - a.y()) * (middle - a.x()) / (b.x() - a.x()), k);
  }
  std::sort(hits.begin(), hits.end());
  std::vector<Chain> chains;
  for (const auto& hit : hits) chains.push_back(follow(o, hit.second, u0, u1));
  return chains;
}

bool LidBuilder::straight(const Chain& chain) const {
  const Vec2 along = (chain.back() - chain.front()).normalized();
  for (const Vec2& p : chain) {
    const Vec2 d = p - chain.front();
    if (std::abs(along.x() * d.y() - along.y() * d.x()) > kStraight * target_) return false;
  }
  return true;
}

/// @param baseline  an odd boundary is paired with v = 0, the centreline of a half waterplane.
void LidBuilder::cover(const Outline& outline, bool baseline, double closest) {
  const std::vector<double> u = stations(outline, closest);
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    std::vector<Chain> chains = crossings(outline, u[i], u[i + 1]);
    if (baseline && chains.size() % 2 == 1)
      chains.insert(chains.begin(), Chain{{u[i], 0.0}, {u[i + 1], 0.0}});
    for (std::size_t c = 0; c + 1 < chains.size(); c += 2)
      coverBetween(chains[c], chains[c + 1], outline.swapped);
  }
}

/// A piece with a kinked boundary (a blunt end) is cut along the other coordinate, once.
void LidBuilder::coverBetween(const Chain& low, const Chain& high, bool swapped) {
  if (swapped || (straight(low) && straight(high))) {
    divide({low.front().x(), low.back().x(), low.front().y(), low.back().y(), high.front().y(),
            high.back().y()},
           swapped);
    return;
  }
  Outline piece;
  piece.swapped = true;
  const auto append = [&](const Vec2& p) {
    const Vec2 turned(p.y(), p.x());
    if (piece.vertices.empty() || piece.vertices.back() != turned) piece.vertices.push_back(turned);
  };
  for (const Vec2& p : low) append(p);
  for (auto p = high.rbegin(); p != high.rend(); ++p) append(*p);
  if (piece.vertices.size() > 1 && piece.vertices.front() == piece.vertices.back())
    piece.vertices.pop_back();
  const int n = static_cast<int>(piece.vertices.size());
  for (int i = 0; i < n; ++i) piece.segments.push_back({i, (i + 1) % n});
  cover(piece, false, 0.1 * target_);
}

void LidBuilder::divide(const Trapezoid& t, bool swapped) {
  const double length = t.u1 - t.u0;
  const double width = 0.5 * (t.high0 - t.low0 + t.high1 - t.low1);
  if (length * width < 1e-4 * target_ * target_) return;  // nothing a solver could use
  const int n = std::max(1, static_cast<int>(std::lround(length / target_)));
  const int m = std::max(1, static_cast<int>(std::lround(width / target_)));
  const auto point = [&](int i, int j) -> Vec2 {
    const double s = static_cast<double>(i) / n, r = static_cast<double>(j) / m;
    const double low = t.low0 + s * (t.low1 - t.low0), high = t.high0 + s * (t.high1 - t.high0);
    return {i == n ? t.u1 : t.u0 + s * length, j == m ? high : low + r * (high - low)};
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      add({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)}, swapped);
}

void LidBuilder::add(const std::array<Vec2, 4>& corner, bool swapped) {
  std::vector<Vec3> points;
  for (const Vec2& c : corner) {
    const Vec3 p = swapped ? Vec3(c.y(), c.x(), 0.0) : Vec3(c.x(), c.y(), 0.0);
    if (points.empty() || (p - points.back()).norm() > 1e-9 * target_) points.push_back(p);
  }
  while (points.size() > 1 && (points.front() - points.back()).norm() <= 1e-9 * target_)
    points.pop_back();
  if (points.size() < 3) return;
  if (swapped) std::reverse(points.begin(), points.end());
  panels.push_back(flatPanel(points));
}

/// The waterline: open edges of the wet surface whose ends lie on z = 0.
Outline waterline(const SurfaceMesh& wet, bool symmetric) {
  const double tolerance = 1e-9 * bounds(wet).diagonal();
  Outline outline;
  std::map<int, int> index;
  std::vector<int> uses;
  const auto vertex = [&](int i) {
    const auto [it, isNew] = index.emplace(i, static_cast<int>(outline.vertices.size()));
    if (isNew) {
      const Vec3& p = wet.vertices[static_cast<std::size_t>(i)];
      outline.vertices.emplace_back(p.x(), p.y());
      uses.push_back(0);
    }
    ++uses[static_cast<std::size_t>(it->second)];
    return it->second;
  };
  const auto onWater = [&](int i) {
    return std::abs(wet.vertices[static_cast<std::size_t>(i)].z()) <= tolerance;
  };
  for (const OpenEdge& e : openEdges(wet))
    if (onWater(e.from) && onWater(e.to)) {
      const int a = vertex(e.from), b = vertex(e.to);
      outline.segments.push_back({a, b});
    }
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i] % 2 == 1 && !(symmetric && std::abs(outline.vertices[i].y()) <= tolerance))
      throw HydroError(Fault::WaterlineNotClosed,
                       "makeLid: the waterline has a loose end at x = " +
                           std::to_string(outline.vertices[i].x()) +
                           ", y = " + std::to_string(outline.vertices[i].y()));
  return outline;
}

}  // namespace

std::vector<Panel> makeLid(const SurfaceMesh& wet, bool symmetric, double targetLength) {
  const Outline outline = waterline(wet, symmetric);
  if (outline.segments.empty()) return {};
  if (targetLength <= 0.0) {
    for (const auto& s : outline.segments)
      targetLength += (outline.at(s[0]) - outline.at(s[1])).norm();
    targetLength /= static_cast<double>(outline.segments.size());
  }
  LidBuilder builder(targetLength);
  builder.cover(outline, symmetric, kClosestStations * targetLength);
  return builder.panels;
}

}  // namespace cutwater
