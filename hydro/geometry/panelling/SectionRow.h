#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

namespace cutwater {

/// Mean lengths of panel edges [m] across and along the sections, and how much shorter than the mean
/// those across are at calm water, those along at the ends (Crowding::c).
struct PanelSize {
  double girthwise = 1.0, lengthwise = 1.0, waterCrowding = 0.0, endCrowding = 0.0;
};

/// A section divided without regard to its neighbours; not installed.
struct SectionRow {
  std::vector<Vec3> points;
  std::vector<int> breaks;  ///< indices of both ends and of the knuckles
};

/// Knuckles of more than `angle` [rad] with room for a panel on either side, lengths from the start.
std::vector<double> roomyCorners(const SectionCurve& curve, double size, double angle);

inline constexpr double kKnuckle = 35 * kPi / 180;  ///< a turn of this much is an edge of panels

SectionRow sectionRow(const SectionCurve& curve, const PanelSize& size);

/// The end row of a strand that goes on as others (`guests`), each along a part of its last section: the
/// guests' own rows, and the rest, which is a stem, divided by itself and put on the centreline.
SectionRow hostRow(const SectionCurve& curve, const std::vector<SectionCurve>& guests,
                   const PanelSize& size);

/// Where along the curve another one begins and ends that is a part of it, within reach [m] of it; both
/// −1 if it is none.
struct CurveSpan {
  double from = -1.0, to = -1.0;
  bool found() const { return from >= 0.0; }
};
CurveSpan spanOn(const SectionCurve& curve, const SectionCurve& part, double reach);

}  // namespace cutwater
