#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

namespace cutwater {

/// A measure along a section in which bends count for more than their length, so that panels of
/// equal measure are shorter in a bilge: a turn of one radian counts as much as 0.4 panels. Turns
/// at corners do not count.
class BendMeasure {
 public:
  /// @param corners  where panels end anyway: lengths from the start, rising [m].
  /// @param size     panel edge [m].
  BendMeasure(const SectionCurve& curve, const std::vector<double>& corners, double size);
  double total() const { return measure_.back(); }
  /// The corners in this measure.
  const std::vector<double>& corners() const { return corners_; }
  /// Length from the start [m] where the measure is m.
  double arcAt(double m) const;

 private:
  void addPart(const SectionCurve& curve, double from, double to, double size);
  std::vector<double> arc_, measure_, corners_;
};

}  // namespace cutwater
