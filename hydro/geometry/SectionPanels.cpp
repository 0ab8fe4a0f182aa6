#include "hydro/geometry/SectionPanels.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/FlatEnd.h"
#include "hydro/geometry/PanelRows.h"

namespace cutwater {
namespace {

constexpr double kEndCrowding = 0.2;  // stations closer together at the ends
constexpr double kBendStep = 0.15;    // of a panel edge: how finely bends are looked at
constexpr double kBendWeight = 0.4;  // panels for a turn of one radian, besides those of its length
constexpr double kKnuckle = 35 * kPi / 180;  // a turn of this much is an edge of panels
constexpr double kKept = 20 * kPi / 180;     // and stays one on the next section down to this
constexpr double kStepping = 0.75;  // parts by which a row's number must be off before it changes

/// Length along a section in which bends count for more, so that panels are shorter in a bilge: a turn
/// of one radian as much as kBendWeight panels. Turns at corners do not count.
class BendMeasure {
 public:
  BendMeasure(const SectionCurve& curve, const std::vector<double>& corners, double size)
      : arc_{0.0}, measure_{0.0} {
    std::vector<double> ends = corners;
    ends.push_back(curve.length());
    double from = 0.0;
    for (const double to : ends) {
      addPart(curve, from, to, size);
      if (to < curve.length()) corners_.push_back(total());
      from = to;
    }
  }
  double total() const { return measure_.back(); }
  const std::vector<double>& corners() const { return corners_; }
  double arcAt(double m) const {
    if (m >= total()) return arc_.back();
    const auto next = std::lower_bound(measure_.begin(), measure_.end(), m);
    const auto k = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(next - measure_.begin(), 1, std::ssize(measure_) - 1));
    const double t = (m - measure_[k - 1]) / (measure_[k] - measure_[k - 1]);
    return arc_[k - 1] + t * (arc_[k] - arc_[k - 1]);
  }

 private:
  void addPart(const SectionCurve& curve, double from, double to, double size) {
    const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / (kBendStep * size))));
    const double step = (to - from) / steps;
    std::vector<Vec3> chord;
    for (int k = 0; k < steps; ++k)
      chord.push_back((curve.at(from + (k + 1) * step) - curve.at(from + k * step)).normalized());
    const auto turn = [&](int k) {
      if (k < 1 || k >= steps) return 0.0;
      const Vec3 &a = chord[static_cast<std::size_t>(k) - 1],
                 &b = chord[static_cast<std::size_t>(k)];
      return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    for (int k = 0; k < steps; ++k) {
      arc_.push_back(k + 1 == steps ? to : from + (k + 1) * step);
      measure_.push_back(total() + step + 0.5 * kBendWeight * size * (turn(k) + turn(k + 1)));
    }
  }
  std::vector<double> arc_, measure_, corners_;
};

class StrandPanels {
 public:
  StrandPanels(const SectionStrand& strand, const SectionCutter& cutter, const PanelSize& size)
      : strand_(strand), cutter_(cutter), size_(size) {}

  SurfaceMesh panels() {
    measure();
    crowdRows();
    const std::vector<double> stations = stationPlaces();
    for (std::size_t k = 0; k < stations.size(); ++k) {
      const bool end = k == 0 || k + 1 == stations.size();
      rows_.push_back(row(curveAt(stations[k], k == 0, k + 1 == stations.size()), end));
    }
    for (std::size_t k = 0; k + 1 < rows_.size(); ++k)
      addPanelsBetween(rows_[k], rows_[k + 1], mesh_);
    addFlatEnd(rows_.front().vertex, true, size_.girthwise, mesh_);
    addFlatEnd(rows_.back().vertex, false, size_.girthwise, mesh_);
    return mesh_;
  }

 private:
  /// How far the section has moved, sample by sample.
  void measure() {
    moved_.push_back(0.0);
    for (std::size_t k = 1; k < strand_.curves.size(); ++k)
      moved_.push_back(moved_.back() +
                       distanceBetween(strand_.curves[k - 1], strand_.curves[k]).mean);
  }

  /// Rows are crowded at an end that lies on calm water along most of the strand.
  void crowdRows() {
    double start = 0.0, end = 0.0;
    for (std::size_t k = 1; k < strand_.curves.size(); ++k) {
      const double part = moved_[k] - moved_[k - 1];
      if (strand_.curves[k].points.front().z() == 0.0) start += part;
      if (strand_.curves[k].points.back().z() == 0.0) end += part;
    }
    crowding_.start = start > 0.5 * moved_.back();
    crowding_.end = end > 0.5 * moved_.back();
    crowding_.c = size_.waterCrowding;
  }

  /// Where the hull's lines turn: knuckles across the strand.
  std::vector<double> knuckles() const {
    std::vector<double> found;
    for (const double f : {0.0, 0.5, 1.0}) {
      SectionCurve line;
      for (std::size_t k = 0; k < moved_.size(); ++k) {
        line.points.push_back(strand_.curves[k].at(f * strand_.curves[k].length()));
        line.arc.push_back(moved_[k]);
      }
      for (const double s : cornersOf(line, 0.4 * size_.lengthwise, kKnuckle)) found.push_back(s);
    }
    for (std::size_t k = 1; k < moved_.size(); ++k)
      if (startsOnWater(k - 1) != startsOnWater(k)) found.push_back(moved_[k]);
    std::sort(found.begin(), found.end());
    std::vector<double> apart;
    for (const double s : found)
      if (s > 0.3 * size_.lengthwise && s < moved_.back() - 0.3 * size_.lengthwise &&
          (apart.empty() || s - apart.back() > 0.5 * size_.lengthwise))
        apart.push_back(s);
    return apart;
  }
  bool startsOnWater(std::size_t k) const { return strand_.curves[k].points.front().z() == 0.0; }

  std::vector<double> stationPlaces() const {
    const double count = std::max(1.0, moved_.back() / size_.lengthwise);
    const Crowding crowding{count > 6, count > 6, kEndCrowding};
    std::vector<double> places;
    for (const double s : divided(moved_.back(), knuckles(), count, crowding).place) {
      const auto next = std::lower_bound(moved_.begin(), moved_.end(), s);
      const auto k = static_cast<std::size_t>(
          std::clamp<std::ptrdiff_t>(next - moved_.begin(), 1, std::ssize(moved_) - 1));
      const double step = moved_[k] - moved_[k - 1];
      const double t = step > 0.0 ? (s - moved_[k - 1]) / step : 0.0;
      places.push_back(strand_.place[k - 1] + t * (strand_.place[k] - strand_.place[k - 1]));
    }
    return places;
  }

  SectionCurve curveAt(double place, bool first, bool last) const {
    if (first) return strand_.curves.front();
    if (last) return strand_.curves.back();
    const auto next = std::lower_bound(strand_.place.begin(), strand_.place.end(), place);
    const auto k =
        std::min(static_cast<std::size_t>(next - strand_.place.begin()), strand_.curves.size() - 1);
    const SectionCurve* best = &strand_.curves[k];
    double least = 1e300;
    const std::vector<SectionCurve> there = cutter_.curvesAt(place, SectionCutter::Side::Above);
    for (const SectionCurve& curve : there)
      if (const double d = distanceBetween(curve, strand_.curves[k]).mean; d < least) {
        least = d;
        best = &curve;
      }
    return *best;
  }

  PanelRow row(const SectionCurve& curve, bool end) {
    if (end && curve.length() < 0.6 * size_.girthwise) {
      before_ = 1.0;
      return {{addVertex(curve.at(0.5 * curve.length()))}, {0}};
    }
    const BendMeasure measure(curve, rowCorners(curve), size_.girthwise);
    const double wanted = std::max(1.0, measure.total() / size_.girthwise);
    if (std::abs(wanted - before_) > kStepping) before_ = std::round(wanted);
    const Division division = divided(measure.total(), measure.corners(), before_, crowding_);
    PanelRow row{{}, division.breaks};
    for (const double m : division.place)
      row.vertex.push_back(addVertex(curve.at(measure.arcAt(m))));
    return row;
  }

  std::vector<double> rowCorners(const SectionCurve& curve) {
    std::vector<double> kept;
    for (const double s : cornersOf(curve, 0.2 * size_.girthwise, kKept)) {
      const bool sharp = !cornersOf(curve, 0.2 * size_.girthwise, kKnuckle).empty();
      const bool known = cornersBefore_ > 0;
      const bool room = s > 0.35 * size_.girthwise && s < curve.length() - 0.35 * size_.girthwise &&
                        (kept.empty() || s - kept.back() > 0.35 * size_.girthwise);
      if (room && (sharp || known)) kept.push_back(s);
    }
    cornersBefore_ = kept.size();
    return kept;
  }

  int addVertex(const Vec3& p) {
    mesh_.vertices.push_back(p);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  const SectionStrand& strand_;
  const SectionCutter& cutter_;
  PanelSize size_;
  Crowding crowding_;
  std::vector<double> moved_;
  double before_ = 1.0;  ///< parts of the row before
  std::size_t cornersBefore_ = 0;
  std::vector<PanelRow> rows_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh panelsOn(const SectionStrand& strand, const SectionCutter& cutter,
                     const PanelSize& size) {
  return StrandPanels(strand, cutter, size).panels();
}

}  // namespace cutwater
