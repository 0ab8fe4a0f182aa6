#pragma once
#include "hydro/geometry/panelling/SectionCurves.h"

/// Sections divided one by one, and where one section is a part of another.
namespace cutwater {

/// Mean lengths of panel edges [m] across and along the sections, and how much shorter than the
/// mean they are: those across at calm water, those along at the ends (Crowding::c). `corners`: how
/// much corners count in the BendMeasure.
struct PanelSize {
  double girthwise = 1.0, lengthwise = 1.0, waterCrowding = 0.0, endCrowding = 0.0, corners = 1.0;
};

/// A section divided into panel edges without regard to its neighbours.
struct SectionRow {
  std::vector<Vec3> points;
  std::vector<int> breaks;  ///< indices of both ends and of the knuckles
};

inline constexpr double kKnuckle = 35 * kPi / 180;  ///< a turn of this much is an edge of panels

/// Corners of more than `angle` [rad] that leave room for a panel on either side: lengths from the
/// start.
std::vector<double> roomyCorners(const SectionCurve& curve, double size, double angle);

SectionRow sectionRow(const SectionCurve& curve, const PanelSize& size);

/// The end row of a strand that goes on as others (`guests`), each along a part of its last
/// section: the guests' own rows, and the rest, which is a stem, divided by itself and put on the
/// centreline.
SectionRow hostRow(const SectionCurve& curve, const std::vector<SectionCurve>& guests,
                   const PanelSize& size);

/// Where along a curve another one begins and ends that is a part of it; both −1 if it is none.
struct CurveSpan {
  double from = -1.0, to = -1.0;
  bool found() const { return from >= 0.0; }
};
/// @param reach  [m] distance within which points of `part` count as on the curve.
CurveSpan spanOn(const SectionCurve& curve, const SectionCurve& part, double reach);

}  // namespace cutwater
