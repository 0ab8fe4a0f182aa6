#include "hydro/geometry/panelling/StationField.h"

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

constexpr double kFacing = 0.5;                          // |n_x| of an end
constexpr double kAcross = 0.3;                          // |n_y| of an end at most
constexpr double kAlike = 0.9986;                        // cos 3°
constexpr double kRough = 2e-4;                          // of the size
constexpr double kLeastBlend = 0.15, kMostBlend = 0.45;  // of the length
constexpr double kUpright = 8e-3;                        // dx/dz of a stem
constexpr double kMostBulge = 4.0;                       // the same
constexpr double kMostFold = 0.65;                       // rake times draught by reach
constexpr double kUpperPart = 0.3;                       // of the draught
constexpr double kFanDepths = 3.0;                       // draughts from the end
constexpr double kExact = 1e-6;                          // of the size
constexpr int kPicks = 40;                               // faces whose planes are tried

/// The plane normal·p = offset in which a hull ends, and the vertices of the faces in it.
struct EndPlane {
  Vec3 normal = Vec3::Zero();
  double offset = 0.0, area = 0.0;
  std::vector<int> vertices;
};

class EndFinder {
 public:
  EndFinder(const SurfaceMesh& wet, double side)
      : wet_(wet), rough_(kRough * bounds(wet).diagonal()) {
    for (const Face& f : wet.faces) {
      const Vec3 n = vectorArea(wet, f);
      if (side * n.x() < kFacing * n.norm() || std::abs(n.y()) > kAcross * n.norm()) continue;
      faces_.push_back(&f);
      area_.push_back((area_.empty() ? 0.0 : area_.back()) + n.norm());
    }
  }

  /// The largest plane that ends the hull; area 0 if there is none.
  EndPlane find() const {
    EndPlane best;
    for (int i = 0; i < kPicks && !faces_.empty(); ++i) {
      const double target = area_.back() * (i + 0.5) / kPicks;
      const auto k = std::lower_bound(area_.begin(), area_.end(), target) - area_.begin();
      const Face& face = *faces_[static_cast<std::size_t>(k)];
      EndPlane plane = around(vectorArea(wet_, face).normalized(), wet_.corner(face, 0));
      if (plane.area > best.area) best = std::move(plane);
    }
    if (best.area == 0.0) return best;
    best = around(best.normal, best.offset * best.normal);
    for (const Vec3& p : wet_.vertices)
      if (best.normal.dot(p) - best.offset > rough_) return {};
    return best;
  }

 private:
  /// The mean plane of the faces that lie in this one.
  EndPlane around(const Vec3& normal, const Vec3& point) const {
    EndPlane plane;
    Vec3 sum = Vec3::Zero();
    double moment = 0.0;
    for (const Face* f : faces_) {
      const Vec3 n = vectorArea(wet_, *f);
      bool inside = normal.dot(n) > kAlike * n.norm();
      for (int i = 0; i < f->size(); ++i)
        inside = inside && std::abs(normal.dot(wet_.corner(*f, i) - point)) < rough_;
      if (!inside) continue;
      sum += n;
      moment += n.dot(meanCorner(wet_, *f));
      plane.area += n.norm();
      for (int i = 0; i < f->size(); ++i) plane.vertices.push_back((*f)[i]);
    }
    if (plane.area == 0.0) return plane;
    plane.normal = sum.normalized();
    plane.offset = moment / sum.norm();
    return plane;
  }

  const SurfaceMesh& wet_;
  double rough_;
  std::vector<const Face*> faces_;
  std::vector<double> area_;  ///< of the faces up to each
};

/// Leans the stations near one end as its plane does.
void lean(std::vector<double>& station, const SurfaceMesh& wet, const EndPlane& end) {
  const Bounds box = bounds(wet);
  const double length = box.high.x() - box.low.x(), draft = -box.low.z();
  const double slope = -end.normal.z() / end.normal.x();  // dx/dz of the plane
  const double atWater = end.offset / end.normal.x();
  const double blend =
      std::clamp(4 * std::abs(slope) * draft, kLeastBlend * length, kMostBlend * length);
  for (std::size_t i = 0; i < station.size(); ++i) {
    const double z = wet.vertices[i].z();
    const double inward = std::abs(wet.vertices[i].x() - atWater - slope * z);
    station[i] -= std::max(0.0, 1 - inward / blend) * slope * z;
  }
  for (const int v : end.vertices) station[static_cast<std::size_t>(v)] = atWater;
}

/// How a hull ends below one end of its waterline: raked, or bulging out as a sphere does that is
/// sunk deeper than its centre.
struct Stem {
  double tip = 0.0;    ///< x of the waterline's end [m]
  double reach = 0.0;  ///< how far from there stations lean [m]
  double slope = 0.0;  ///< dx/dz of the plane through the tip with the hull on one side; 0: upright
};

/// The slope that the upper part of the hull has, unless the lower reaches out farther (a bulb) or
/// the keel rises to calm water.
Stem stemAt(const SurfaceMesh& wet, double side) {
  const Bounds box = bounds(wet);
  double tip = -1e300, otherTip = 1e300, upper = -1e300, all = -1e300;  // outwards; per depth
  for (const Vec3& p : wet.vertices) {
    if (p.z() != 0.0) continue;
    tip = std::max(tip, side * p.x());
    otherTip = std::min(otherTip, side * p.x());
  }
  for (const Vec3& p : wet.vertices) {
    if (p.z() > -kRough * box.diagonal()) continue;
    const double out = (side * p.x() - tip) / -p.z();
    all = std::max(all, out);
    if (p.z() > kUpperPart * box.low.z()) upper = std::max(upper, out);
  }
  const double reach = std::min(0.5 * (tip - otherTip), -kFanDepths * box.low.z());
  const bool upright = std::abs(upper) < kUpright || upper > kMostBulge ||
                       upper * box.low.z() > kMostFold * reach || all > upper + kUpright;
  return {side * tip, reach, upright ? 0.0 : -side * upper};
}

/// Stations near one end are planes through one line above or below the hull, the last of them the
/// stem's:   x = c + slope z w(c),   w from 0 at `start` to 1 at the tip.
void fan(std::vector<double>& station, const SurfaceMesh& wet, const Stem& stem, double side) {
  const double start = stem.tip - side * stem.reach, exact = kExact * bounds(wet).diagonal();
  for (std::size_t i = 0; i < station.size(); ++i) {
    const double perReach = side * stem.slope * wet.vertices[i].z() / stem.reach;
    const double c = (wet.vertices[i].x() + perReach * start) / (1 + perReach);
    if (side * (c - stem.tip) > -exact)
      station[i] = stem.tip;
    else if (side * (c - start) > 0.0)
      station[i] = c;
  }
}

}  // namespace

std::vector<double> stationField(const SurfaceMesh& wet, double leastArea) {
  std::vector<double> station;
  for (const Vec3& p : wet.vertices) station.push_back(p.x());
  for (const double side : {-1.0, 1.0})
    if (const EndPlane end = EndFinder(wet, side).find(); end.area > leastArea)
      lean(station, wet, end);
    else if (const Stem stem = stemAt(wet, side); stem.slope != 0.0)
      fan(station, wet, stem, side);
  return station;
}

}  // namespace cutwater
