#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

namespace cutwater {

/// A measure along a section in which bends count for more than their length, so that panels of
/// equal measure are shorter in a bilge: a turn of one radian counts as much as 0.4 panels. A
/// corner that bulges out by θ, around which the water is fast, counts w = θ − 20° in radians
/// (decision 0095): at a distance d on either side of it a length ds counts
/// (1 + w e^{−d/size}) ds.
class BendMeasure {
 public:
  /// @param corners  where panels end anyway: lengths from the start, rising [m].
  /// @param size     panel edge [m].
  /// @param weight   of w: 1, or less where panels would be too narrow.
  BendMeasure(const SectionCurve& curve, const std::vector<double>& corners, double size,
              double weight = 1.0);
  double total() const { return measure_.back(); }
  /// The corners in this measure.
  const std::vector<double>& corners() const { return corners_; }
  /// Length from the start [m] where the measure is m.
  double arcAt(double m) const;

 private:
  /// From corner to corner, with what these weigh.
  struct Part {
    double from, to, weightFrom, weightTo;
  };
  void addPart(const SectionCurve& curve, const Part& part, double size);
  std::vector<double> arc_, measure_, corners_;
};

}  // namespace cutwater
