#include "hydro/geometry/panelling/SectionRow.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/BendMeasure.h"
#include "hydro/geometry/panelling/PanelRows.h"

namespace cutwater {
namespace {

SectionCurve partOf(const SectionCurve& curve, double from, double to) {
  std::vector<Vec3> points{curve.at(from)};
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    if (curve.arc[i] > from && curve.arc[i] < to) points.push_back(curve.points[i]);
  points.push_back(curve.at(to));
  return curveThrough(points);
}

/// A guest's own corner replaces a stem's that is about there.
void append(SectionRow& row, const SectionRow& more, double about) {
  if (!row.points.empty() && (row.points.back() - more.points.front()).norm() < about) {
    row.points.pop_back();
    row.breaks.pop_back();
  }
  const int offset = static_cast<int>(row.points.size());
  row.points.insert(row.points.end(), more.points.begin(), more.points.end());
  for (const int b : more.breaks) row.breaks.push_back(offset + b);
}

void appendStem(SectionRow& row, const SectionCurve& curve, double from, double to,
                const PanelSize& size) {
  if (to - from < 0.02 * size.girthwise) return;
  SectionRow stem = sectionRow(partOf(curve, from, to), size);
  for (Vec3& p : stem.points)
    if (std::abs(p.y()) < 0.1 * size.girthwise) p.y() = 0.0;
  if (!row.points.empty()) stem.points.front() = row.points.back();
  append(row, stem, 1e-9);
}

}  // namespace

std::vector<double> roomyCorners(const SectionCurve& curve, double size, double angle) {
  const double room = 0.35 * size;
  std::vector<double> kept;
  for (const double s : cornersOf(curve, 0.2 * size, angle))
    if (s > room && s < curve.length() - room && (kept.empty() || s - kept.back() > room))
      kept.push_back(s);
  return kept;
}

SectionRow sectionRow(const SectionCurve& curve, const PanelSize& size) {
  const BendMeasure measure(curve, roomyCorners(curve, size.girthwise, kKnuckle), size.girthwise,
                            size.corners);
  const Crowding crowding{curve.points.front().z() == 0.0, curve.points.back().z() == 0.0,
                          size.waterCrowding};
  const Division division =
      divided(measure.total(), measure.corners(), measure.total() / size.girthwise, crowding);
  SectionRow row{{}, division.breaks};
  for (const double m : division.place) row.points.push_back(curve.at(measure.arcAt(m)));
  return row;
}

namespace {

/// Length along a curve of the point nearest to p, the first such or the last; −1 beyond reach.
double nearestOn(const SectionCurve& curve, const Vec3& p, double reach, bool first) {
  double best = -1.0, least = reach;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Vec3 step = curve.points[i + 1] - curve.points[i];
    const double t = std::clamp((p - curve.points[i]).dot(step) / step.squaredNorm(), 0.0, 1.0);
    const double d = (curve.points[i] + t * step - p).norm();
    if (first ? d < least : d <= least) {
      least = d;
      best = curve.arc[i] + t * step.norm();
    }
  }
  return best;
}

}  // namespace

CurveSpan spanOn(const SectionCurve& curve, const SectionCurve& part, double reach) {
  const CurveSpan span{nearestOn(curve, part.points.front(), reach, true),
                       nearestOn(curve, part.points.back(), reach, false)};
  if (span.from < 0 || span.to < 0 || std::abs(span.to - span.from - part.length()) > reach)
    return {};
  return span;
}

SectionRow hostRow(const SectionCurve& curve, const std::vector<SectionCurve>& guests,
                   const PanelSize& size) {
  std::vector<std::pair<double, const SectionCurve*>> order;
  for (const SectionCurve& guest : guests)
    order.emplace_back(spanOn(curve, guest, size.girthwise).from, &guest);
  std::sort(order.begin(), order.end());
  SectionRow row;
  double done = 0.0;
  for (const auto& [from, guest] : order) {
    appendStem(row, curve, done, from, size);
    append(row, sectionRow(*guest, size), 0.1 * size.girthwise);
    done = spanOn(curve, *guest, size.girthwise).to;
  }
  appendStem(row, curve, done, curve.length(), size);
  return row;
}

}  // namespace cutwater
