#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

namespace cutwater {

/// Length along a section in which bends count for more, so that panels are shorter in a bilge: a turn
/// of one radian as much as 0.4 panels besides its length. Turns at corners do not count. Not
/// installed.
class BendMeasure {
 public:
  /// @param corners  where panels end anyway, lengths from the start, rising [m].
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
