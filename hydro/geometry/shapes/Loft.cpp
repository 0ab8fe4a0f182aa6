#include "hydro/geometry/shapes/Loft.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater {
namespace {

constexpr int kStemStrips = 2;
constexpr double kLoftCrowding = 0.42;  // stations closer together at the ends, spacedAtEnds

/// Slopes of the monotone cubic through (t, f): the weighted harmonic mean of the neighbours' where
/// they agree in sign, else 0.
std::vector<double> monotoneSlopes(const std::vector<double>& t, const std::vector<double>& f) {
  const std::size_t n = t.size();
  std::vector<double> secant(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i) secant[i] = (f[i + 1] - f[i]) / (t[i + 1] - t[i]);
  slope.front() = secant.front();
  slope.back() = secant.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (secant[i - 1] * secant[i] <= 0.0) continue;
    const double before = t[i] - t[i - 1], behind = t[i + 1] - t[i];
    const double w1 = 2 * behind + before, w2 = behind + 2 * before;
    slope[i] = (w1 + w2) / (w1 / secant[i - 1] + w2 / secant[i]);
  }
  return slope;
}

/// Cubic Hermite between i and i + 1.
double hermite(const std::vector<double>& t, std::size_t i, double f0, double f1, double m0,
               double m1, double where) {
  const double h = t[i + 1] - t[i], s = (where - t[i]) / h;
  return (1 + 2 * s) * (1 - s) * (1 - s) * f0 + s * (1 - s) * (1 - s) * h * m0 +
         s * s * (3 - 2 * s) * f1 + s * s * (s - 1) * h * m1;
}

/// Parts across half the deck and the transom.
int acrossEnd(int girth) { return std::max(1, girth / 4); }

std::size_t interval(const std::vector<double>& t, double where) {
  const auto next = std::upper_bound(t.begin(), t.end(), where);
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - t.begin() - 1, 0, std::ssize(t) - 2));
}

}  // namespace

Vec3 LoftedHull::Section::at(double chordLength) const {
  const std::size_t i = interval(chord, chordLength);
  return {
      x, hermite(chord, i, points[i].y(), points[i + 1].y(), slopeY[i], slopeY[i + 1], chordLength),
      hermite(chord, i, points[i].z(), points[i + 1].z(), slopeZ[i], slopeZ[i + 1], chordLength)};
}

LoftedHull::LoftedHull(const std::vector<Vec3>& offsets) {
  for (const Vec3& p : offsets) {
    if (sections_.empty() || sections_.back().x != p.x()) {
      if (!sections_.empty() && p.x() > sections_.back().x)
        throw HydroError(Fault::BadArgument, "LoftedHull: section at x = " + std::to_string(p.x()) +
                                                 " m is not aft of the one before");
      sections_.push_back({p.x(), {}, {}, {}, {}, 0.0});
    }
    Section& s = sections_.back();
    if (!s.points.empty() && p.z() > s.points.back().z())
      throw HydroError(Fault::ValueOutOfRange,
                       "LoftedHull: section at x = " + std::to_string(p.x()) +
                           " m rises at z = " + std::to_string(p.z()) + " m");
    if (!s.points.empty() && p == s.points.back()) continue;
    s.chord.push_back(s.points.empty() ? 0.0 : s.chord.back() + (p - s.points.back()).norm());
    s.points.push_back(p);
  }
  if (sections_.size() < 3)
    throw HydroError(Fault::BadArgument,
                     "LoftedHull: " + std::to_string(sections_.size()) + " sections");
  for (Section& s : sections_) {
    if (s.points.size() < 3 || s.points.front().z() <= 0 || s.points.back().z() >= 0)
      throw HydroError(Fault::ValueOutOfRange, "LoftedHull: section at x = " + std::to_string(s.x) +
                                                   " m has " + std::to_string(s.points.size()) +
                                                   " points, z from " +
                                                   std::to_string(s.points.front().z()) + " to " +
                                                   std::to_string(s.points.back().z()) + " m");
    std::vector<double> y, z;
    for (const Vec3& p : s.points) {
      y.push_back(p.y());
      z.push_back(p.z());
    }
    s.slopeY = monotoneSlopes(s.chord, y);
    s.slopeZ = monotoneSlopes(s.chord, z);
    double above = 0.0, below = s.chord.back();
    for (int i = 0; i < 60; ++i) {
      s.atWater = 0.5 * (above + below);
      if (s.at(s.atWater).z() > 0) {
        above = s.atWater;
      } else {
        below = s.atWater;
      }
    }
  }
  std::reverse(sections_.begin(), sections_.end());
}

Vec3 LoftedHull::point(double u, double v) const {
  std::vector<double> x, y, z;
  for (const Section& s : sections_) {
    const double end = s.chord.back();
    const Vec3 p = s.at(v < 0 ? (1 + v) * s.atWater : s.atWater + v * (end - s.atWater));
    x.push_back(p.x());
    y.push_back(v == 1.0 ? 0.0 : p.y());
    z.push_back(v == 0.0 ? 0.0 : p.z());
  }
  if (u >= 1.0) {  // a quarter of a circle in the waterline's plane
    const double angle = (u - 1.0) * 0.5 * kPi, breadth = y.back();
    return {x.back() + breadth * std::sin(angle), u == 2.0 ? 0.0 : breadth * std::cos(angle),
            z.back()};
  }
  const double where = x.front() + u * (x.back() - x.front());
  const std::size_t i = interval(x, where);
  const std::vector<double> dy = monotoneSlopes(x, y), dz = monotoneSlopes(x, z);
  return {where, hermite(x, i, y[i], y[i + 1], dy[i], dy[i + 1], where),
          hermite(x, i, z[i], z[i + 1], dz[i], dz[i + 1], where)};
}

std::vector<double> LoftedHull::stations(int along) const {
  std::vector<double> u = spacedAtEnds(along - kStemStrips, kLoftCrowding);
  for (int i = 1; i <= kStemStrips; ++i) u.push_back(1.0 + static_cast<double>(i) / kStemStrips);
  return u;
}

/// Between two heights of the last section, from the centreline outwards.
SurfaceMesh LoftedHull::transom(int girth, double from, double to) const {
  return gridSurface(uniform(girth), uniform(acrossEnd(girth)), [&](double s, double t) -> Vec3 {
    const Vec3 edge = point(0.0, from + s * (to - from));
    return {edge.x(), t * edge.y(), edge.z()};
  });
}

SurfaceMesh LoftedHull::wet(int along, int girth) const {
  const SurfaceMesh side =
      gridSurface(stations(along), uniform(girth), [&](double u, double v) { return point(u, v); });
  const SurfaceMesh both = joined(side, transom(girth, 1.0, 0.0));
  return welded(both, 1e-9 * bounds(both).diagonal());
}

SurfaceMesh LoftedHull::closed(int along, int girth) const {
  const std::vector<double> u = stations(along);
  const int up = std::max(2, girth / 3);
  SurfaceMesh dry =
      gridSurface(u, uniform(up), [&](double s, double t) { return point(s, t - 1.0); });
  const int across = acrossEnd(girth);
  dry = joined(dry, gridSurface(u, uniform(across), [&](double s, double t) -> Vec3 {
                 const Vec3 edge = point(s, -1.0);
                 return {edge.x(), t * edge.y(), edge.z()};
               }));
  SurfaceMesh end = gridSurface(uniform(up), uniform(across), [&](double s, double t) -> Vec3 {
    const Vec3 edge = point(0.0, -s);
    return {edge.x(), t * edge.y(), edge.z()};
  });
  return closedFromHalves(wet(along, girth), joined(dry, end));
}

}  // namespace cutwater
