#include "hydro/geometry/panelling/SectionCurves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace cutwater {
namespace {

constexpr int kSlabs = 512;

/// An edge of the mesh that the plane crosses, whichever way it is named.
using CrossedEdge = std::uint64_t;

CrossedEdge crossedEdge(int a, int b) {
  return (static_cast<CrossedEdge>(std::min(a, b)) << 32) |
         static_cast<std::uint32_t>(std::max(a, b));
}

struct CutSegment {
  CrossedEdge from, to;
  bool used = false;
};

/// Segments in one plane, joined into lines.
class SegmentChains {
 public:
  explicit SegmentChains(std::vector<CutSegment> segments) : segments_(std::move(segments)) {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      leaving_.emplace(segments_[i].from, i);
      ++arriving_[segments_[i].to];
    }
  }
  /// Lines with two ends first, then loops.
  std::vector<std::vector<CrossedEdge>> chains() {
    std::vector<std::vector<CrossedEdge>> all;
    for (const bool loops : {false, true})
      for (std::size_t i = 0; i < segments_.size(); ++i)
        if (!segments_[i].used && (loops || !arriving_.contains(segments_[i].from)))
          all.push_back(follow(i));
    return all;
  }

 private:
  std::vector<CrossedEdge> follow(std::size_t i) {
    std::vector<CrossedEdge> chain{segments_[i].from};
    for (;;) {
      segments_[i].used = true;
      chain.push_back(segments_[i].to);
      const auto range = leaving_.equal_range(segments_[i].to);
      auto next = range.first;
      while (next != range.second && segments_[next->second].used) ++next;
      if (next == range.second) return chain;
      i = next->second;
    }
  }
  std::vector<CutSegment> segments_;
  std::unordered_multimap<CrossedEdge, std::size_t> leaving_;
  std::unordered_map<CrossedEdge, int> arriving_;
};

/// A loop begins at its highest point, of several at the outermost.
void beginAtTop(std::vector<Vec3>& loop) {
  loop.pop_back();
  const auto lower = [](const Vec3& p, const Vec3& q) {
    return std::pair(p.z(), p.y()) < std::pair(q.z(), q.y());
  };
  std::rotate(loop.begin(), std::max_element(loop.begin(), loop.end(), lower), loop.end());
  loop.push_back(loop.front());
}

struct Turn {
  double angle;  ///< between the chords before and behind
  double bend;   ///< their difference, greatest right at a knuckle, a fold included
};

Turn turnAt(const SectionCurve& curve, double s, double window) {
  const Vec3 here = curve.at(s);
  const Vec3 before = here - curve.at(s - window), behind = curve.at(s + window) - here;
  return {std::atan2(before.cross(behind).norm(), before.dot(behind)), (behind - before).norm()};
}

}  // namespace

Vec3 SectionCurve::at(double s) const {
  if (points.size() < 2 || s <= 0.0) return points.front();
  if (s >= length()) return points.back();
  const auto next = std::upper_bound(arc.begin(), arc.end(), s);
  const auto i = static_cast<std::size_t>(next - arc.begin());
  const double t = (s - arc[i - 1]) / (arc[i] - arc[i - 1]);
  return points[i - 1] + t * (points[i] - points[i - 1]);
}

SectionCurve curveThrough(const std::vector<Vec3>& points) {
  SectionCurve curve;
  for (const Vec3& p : points) {
    const double step = curve.points.empty() ? 0.0 : (p - curve.points.back()).norm();
    if (!curve.points.empty() && step == 0.0) continue;
    curve.arc.push_back(curve.length() + step);
    curve.points.push_back(p);
  }
  return curve;
}

CurveDistance distanceBetween(const SectionCurve& a, const SectionCurve& b) {
  constexpr int kParts = 8;
  CurveDistance distance;
  for (int i = 0; i <= kParts; ++i) {
    const double f = static_cast<double>(i) / kParts;
    const double d = (a.at(f * a.length()) - b.at(f * b.length())).norm();
    distance.greatest = std::max(distance.greatest, d);
    distance.mean += d * d * d * d / (kParts + 1);
  }
  distance.mean = std::sqrt(std::sqrt(distance.mean));
  return distance;
}

std::vector<double> cornersOf(const SectionCurve& curve, double window, double angle) {
  std::vector<std::pair<double, double>> found;  // bend, place
  for (const double s : curve.arc) {
    if (s < window || s > curve.length() - window) continue;
    if (const Turn turn = turnAt(curve, s, window); turn.angle > angle)
      found.emplace_back(turn.bend, s);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<double> corners;
  for (const auto& [bend, s] : found) {
    const bool near = std::any_of(corners.begin(), corners.end(), [&, at = s](double c) {
      return std::abs(c - at) < 1.5 * window;
    });
    if (!near) corners.push_back(s);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

SectionCutter::SectionCutter(const SurfaceMesh& mesh, std::vector<double> station)
    : mesh_(mesh), station_(std::move(station)), slabs_(kSlabs) {
  const auto [least, most] = std::minmax_element(station_.begin(), station_.end());
  low_ = *least;
  high_ = *most;
  slabWidth_ = std::max((high_ - low_) / kSlabs, 1e-300);
  for (const Face& f : mesh.faces) {
    triangles_.push_back({f[0], f[1], f[2]});
    if (f.size() == 4) triangles_.push_back({f[0], f[2], f[3]});
  }
  const auto slab = [&](double x) {
    return std::clamp(static_cast<int>((x - low_) / slabWidth_), 0, kSlabs - 1);
  };
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    double least = high_, most = low_;
    for (const int v : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) {
      least = std::min(least, station_[static_cast<std::size_t>(v)]);
      most = std::max(most, station_[static_cast<std::size_t>(v)]);
    }
    if (least == most) continue;
    for (int k = slab(least); k <= slab(most); ++k)
      slabs_[static_cast<std::size_t>(k)].push_back(static_cast<int>(i));
  }
}

bool SectionCutter::isAbove(int vertex, double c, Side side) const {
  const double x = station_[static_cast<std::size_t>(vertex)];
  return side == Side::Above ? x > c : x >= c;
}

std::vector<SectionCurve> SectionCutter::curvesAt(double c, Side side) const {
  const int k = std::clamp(static_cast<int>((c - low_) / slabWidth_), 0, kSlabs - 1);
  std::vector<CutSegment> segments;
  // A plane between two slabs may have its triangles in either.
  for (int slab = std::max(0, k - 1); slab <= std::min(kSlabs - 1, k + 1); ++slab)
    for (const int i : slabs_[static_cast<std::size_t>(slab)]) {
      const Triangle& t = triangles_[static_cast<std::size_t>(i)];
      const int v[] = {t.a, t.b, t.c};
      const bool above[] = {isAbove(t.a, c, side), isAbove(t.b, c, side), isAbove(t.c, c, side)};
      if (above[0] == above[1] && above[1] == above[2]) continue;
      CutSegment segment{};
      for (int e = 0; e < 3; ++e) {
        const int next = (e + 1) % 3;
        if (above[e] == above[next]) continue;
        if (above[next]) {
          segment.from = crossedEdge(v[e], v[next]);
        } else {
          segment.to = crossedEdge(v[e], v[next]);
        }
      }
      segments.push_back(segment);
    }
  // Each triangle once, though up to three slabs name it.
  const auto order = [](const CutSegment& p, const CutSegment& q) {
    return std::pair(p.from, p.to) < std::pair(q.from, q.to);
  };
  const auto same = [](const CutSegment& p, const CutSegment& q) {
    return p.from == q.from && p.to == q.to;
  };
  std::sort(segments.begin(), segments.end(), order);
  segments.erase(std::unique(segments.begin(), segments.end(), same), segments.end());

  std::vector<SectionCurve> curves;
  for (const std::vector<CrossedEdge>& chain : SegmentChains(std::move(segments)).chains()) {
    std::vector<Vec3> points;
    for (const CrossedEdge e : chain) {
      const std::size_t a = e >> 32, b = e & 0xffffffffu;
      const double t = std::clamp((c - station_[a]) / (station_[b] - station_[a]), 0.0, 1.0);
      points.push_back(mesh_.vertices[a] + t * (mesh_.vertices[b] - mesh_.vertices[a]));
    }
    const bool closed = chain.size() > 2 && chain.front() == chain.back();
    if (closed) beginAtTop(points);
    curves.push_back(curveThrough(points));
    curves.back().closed = closed;
  }
  return curves;
}

}  // namespace cutwater
