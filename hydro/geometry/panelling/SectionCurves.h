#pragma once
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

/// Sections of a surface as curves measured by their length.
namespace cutwater {

/// A polygonal line on a surface.
struct SectionCurve {
  std::vector<Vec3> points;
  std::vector<double> arc;  ///< length from the first point to each [m]
  bool closed = false;      ///< first point = last
  double length() const { return arc.empty() ? 0.0 : arc.back(); }
  /// Point at this length from the start; lengths beyond the curve give its ends.
  Vec3 at(double s) const;
};

/// The line through these points, repeated ones left out.
SectionCurve curveThrough(const std::vector<Vec3>& points);

/// Distance of points at equal fractions of two curves' lengths [m]: greatest, and fourth-power
/// mean.
struct CurveDistance {
  double greatest = 0.0, mean = 0.0;
};
CurveDistance distanceBetween(const SectionCurve& a, const SectionCurve& b);

/// Corners of a line: lengths at which it turns by more than `angle` [rad] from `window` [m] before
/// to `window` behind. None is nearer than `window` to an end or to another.
std::vector<double> cornersOf(const SectionCurve& curve, double window, double angle);

/// Cuts one surface many times, at stations: curves along which a number given at its vertices, and
/// linear between them, is constant. If the number is x, they are plane sections.
class SectionCutter {
 public:
  /// @param mesh     vertices shared, normals out; must outlive this object.
  /// @param station  one number a vertex [m].
  SectionCutter(const SurfaceMesh& mesh, std::vector<double> station);
  double low() const { return low_; }
  double high() const { return high_; }
  /// Which side of the station is cut where faces lie in it.
  enum class Side { Below, Above };
  /// The curves at station c. They run down the port side, and to starboard along the bottom. A
  /// closed curve begins at its highest point. O(faces near the station).
  std::vector<SectionCurve> curvesAt(double c, Side side) const;

 private:
  struct Triangle {
    int a, b, c;
  };
  bool isAbove(int vertex, double c, Side side) const;
  const SurfaceMesh& mesh_;
  std::vector<double> station_;
  double low_ = 0.0, high_ = 0.0, slabWidth_ = 1.0;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<int>> slabs_;  ///< triangles that reach into each slab
};

}  // namespace cutwater
