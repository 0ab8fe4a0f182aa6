#include "hydro/geometry/panelling/SectionPanels.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/BendMeasure.h"
#include "hydro/geometry/panelling/FlatEnd.h"
#include "hydro/geometry/panelling/PanelRows.h"

namespace cutwater {
namespace {

constexpr double kStem = 0.1;             // of a panel edge: a narrower stem is a line
constexpr double kKept = 20 * kPi / 180;  // and stays one on the next section down to this

class StrandPanels {
 public:
  StrandPanels(const SectionStrand& strand, const SectionCutter& cutter, const PanelSize& size)
      : strand_(strand), cutter_(cutter), size_(size) {}

  SurfaceMesh panels() {
    measure();
    crowdRows();
    const std::vector<SectionCurve> curves = stationCurves();
    const std::vector<std::vector<double>> corners = rowCorners(curves);
    std::vector<BendMeasure> measures;
    for (std::size_t k = 0; k < curves.size(); ++k)
      measures.emplace_back(curves[k], corners[k], size_.girthwise, size_.corners);
    const std::vector<double> counts =
        rowCounts(measures, enclosing(curves[curves.size() / 2]) ? 3.0 : 1.0);
    std::vector<PanelRow> rows;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const bool end = k == 0 || k + 1 == curves.size();
      rows.push_back(
          end ? endRow(curves[k], k == 0 ? strand_.start : strand_.end, measures[k], counts[k])
              : row(curves[k], measures[k], counts[k]));
    }
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) addPanelsBetween(rows[k], rows[k + 1], mesh_);
    if (strand_.start.alone()) addFlatEnd(rows.front().vertex, true, size_.girthwise, mesh_);
    if (strand_.end.alone()) addFlatEnd(rows.back().vertex, false, size_.girthwise, mesh_);
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
    std::sort(found.begin(), found.end());
    std::vector<double> apart;
    for (const double s : found)
      if (s > 0.3 * size_.lengthwise && s < moved_.back() - 0.3 * size_.lengthwise &&
          (apart.empty() || s - apart.back() > 0.5 * size_.lengthwise))
        apart.push_back(s);
    return apart;
  }
  std::vector<double> stationPlaces() const {
    const double count = std::max(1.0, moved_.back() / size_.lengthwise);
    const Crowding crowding{count > 6, count > 6, size_.endCrowding};
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

  std::vector<SectionCurve> stationCurves() const {
    const std::vector<double> places = stationPlaces();
    std::vector<SectionCurve> curves{strand_.curves.front()};
    for (std::size_t k = 1; k + 1 < places.size(); ++k) curves.push_back(curveAt(places[k]));
    curves.push_back(strand_.curves.back());
    return curves;
  }

  /// Of the curves in that plane the one that belongs to this strand.
  SectionCurve curveAt(double place) const {
    const auto next = std::lower_bound(strand_.place.begin(), strand_.place.end(), place);
    const auto k =
        std::min(static_cast<std::size_t>(next - strand_.place.begin()), strand_.curves.size() - 1);
    SectionCurve best = strand_.curves[k];
    double least = 1e300;
    for (SectionCurve& curve : cutter_.curvesAt(place, SectionCutter::Side::Above))
      if (const double d = distanceBetween(curve, strand_.curves[k]).mean; d < least) {
        least = d;
        best = std::move(curve);
      }
    return best;
  }

  /// Knuckles of each section; a soft one counts beside a section with a sharp one, so that a
  /// fading chine is followed.
  std::vector<std::vector<double>> rowCorners(const std::vector<SectionCurve>& curves) const {
    std::vector<bool> sharp;
    for (const SectionCurve& c : curves)
      sharp.push_back(!roomyCorners(c, size_.girthwise, kKnuckle).empty());
    std::vector<std::vector<double>> corners;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const bool beside = (k > 0 && sharp[k - 1]) || (k + 1 < sharp.size() && sharp[k + 1]);
      corners.push_back(roomyCorners(curves[k], size_.girthwise, beside ? kKept : kKnuckle));
    }
    return corners;
  }

  /// Parts of each row; the median of five, so that a girth near a limit does not flicker.
  std::vector<double> rowCounts(const std::vector<BendMeasure>& measures, double least) const {
    std::vector<double> raw, counts;
    for (const BendMeasure& m : measures)
      raw.push_back(std::max(least, std::ceil(m.total() / size_.girthwise - 0.501)));
    for (std::size_t k = 0; k < raw.size(); ++k) {
      const std::size_t reach = std::min({std::size_t{2}, k, raw.size() - 1 - k});
      std::vector<double> near(raw.begin() + static_cast<std::ptrdiff_t>(k - reach),
                               raw.begin() + static_cast<std::ptrdiff_t>(k + reach + 1));
      std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(reach), near.end());
      counts.push_back(near[reach]);
    }
    return counts;
  }

  /// So short that no panel ends in it; a loop may be longer, as its ends need not stay on calm
  /// water or on the centreline.
  bool isPoint(const SectionCurve& curve) const {
    return curve.length() < (curve.closed ? 0.6 : 0.02) * size_.girthwise;
  }

  /// A section both ends of which are in one place or on the centreline needs corners between.
  static bool enclosing(const SectionCurve& curve) {
    return curve.closed || (curve.points.front().y() == 0.0 && curve.points.back().y() == 0.0);
  }

  PanelRow endRow(const SectionCurve& curve, const StrandEnd& end, const BendMeasure& measure,
                  double count) {
    if (end.hosted) return rowOf(sectionRow(curve, size_));
    if (!end.guests.empty()) return rowOf(hostRow(curve, end.guests, size_));
    if (isPoint(curve)) return pointRow(curve);
    PanelRow last = row(curve, measure, count);
    closeWedge(last.vertex);
    return last;
  }
  PanelRow rowOf(const SectionRow& row) {
    PanelRow out{{}, row.breaks};
    for (const Vec3& p : row.points) out.vertex.push_back(addVertex(p));
    return out;
  }

  PanelRow pointRow(const SectionCurve& curve) {
    return {{addVertex(curve.at(0.5 * curve.length()))}, {0}};
  }

  PanelRow row(const SectionCurve& curve, const BendMeasure& measure, double count) {
    const Division division = divided(measure.total(), measure.corners(), count, crowding_);
    PanelRow row{{}, division.breaks};
    for (const double m : division.place)
      row.vertex.push_back(addVertex(curve.at(measure.arcAt(m))));
    return row;
  }

  /// A stem a small part of a panel broad becomes a line: else it would need panels of its own.
  void closeWedge(const std::vector<int>& row) {
    const auto at = [&](std::size_t i) -> Vec3& {
      return mesh_.vertices[static_cast<std::size_t>(row[i])];
    };
    const bool toCentreline = at(row.size() - 1).y() == 0.0;
    double broadest = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i)
      broadest = std::max(
          broadest, toCentreline ? std::abs(at(i).y()) : (at(i) - at(row.size() - 1 - i)).norm());
    if (broadest > kStem * size_.girthwise) return;
    for (std::size_t i = 0; 2 * i < row.size() || (toCentreline && i < row.size()); ++i) {
      if (toCentreline)
        at(i).y() = 0.0;
      else
        at(i) = at(row.size() - 1 - i) = 0.5 * (at(i) + at(row.size() - 1 - i));
    }
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
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh panelsOn(const SectionStrand& strand, const SectionCutter& cutter,
                     const PanelSize& size) {
  return StrandPanels(strand, cutter, size).panels();
}

}  // namespace cutwater
