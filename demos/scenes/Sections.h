#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// A hundred sections of a hull, each as pieces of its outline.
class Sections {
 public:
  explicit Sections(const ShipParticulars& ship) : pieces_(kCount) {
    const Bounds size = bounds(ship.hull);
    step_ = (size.high.x() - size.low.x()) / kCount;
    for (const Face& face : ship.hull.faces) {
      double x = size.low.x() + 0.5 * step_;
      for (Pieces& section : pieces_) {
        addPiece(ship.hull, face, x, section);
        x += step_;
      }
    }
  }

  /// ½πρ∫b² dx [kg], b half the beam of the part of each section below z.
  double addedMass(double density, double z) const {
    double sum = 0.0;
    for (const auto& section : pieces_) {
      double half = 0.0;
      for (const auto& [a, b] : section) half = std::max(half, widest(a, b, z));
      sum += half * half;
    }
    return 0.5 * kPi * density * sum * step_;
  }

 private:
  static constexpr int kCount = 100;
  struct Point {
    double y, z;
  };
  using Pieces = std::vector<std::pair<Point, Point>>;

  static void addPiece(const SurfaceMesh& hull, const Face& face, double x, Pieces& pieces) {
    std::vector<Point> ends;
    for (int i = 0; i < face.size(); ++i) {
      const Vec3 a = hull.corner(face, i), b = hull.corner(face, (i + 1) % face.size());
      if ((a.x() < x) == (b.x() < x)) continue;
      const Vec3 at = a + (x - a.x()) / (b.x() - a.x()) * (b - a);
      ends.push_back({at.y(), at.z()});
    }
    if (ends.size() == 2) pieces.emplace_back(ends[0], ends[1]);
  }

  static double widest(Point a, Point b, double z) {
    if (a.z > b.z) std::swap(a, b);
    if (a.z >= z) return 0.0;
    const double share = b.z > z ? (z - a.z) / (b.z - a.z) : 1.0;
    return std::max(std::abs(a.y), std::abs(a.y + share * (b.y - a.y)));
  }

  std::vector<Pieces> pieces_;
  double step_ = 0.0;
};

}  // namespace cutwater
