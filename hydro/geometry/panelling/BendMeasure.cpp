#include "hydro/geometry/panelling/BendMeasure.h"

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

constexpr double kBendStep = 0.15;   // of a panel edge: how finely bends are measured
constexpr double kBendWeight = 0.4;  // panels for a turn of one radian

double turnBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

BendMeasure::BendMeasure(const SectionCurve& curve, const std::vector<double>& corners, double size)
    : arc_{0.0}, measure_{0.0} {
  double from = 0.0;
  for (const double to : corners) {
    addPart(curve, from, to, size);
    corners_.push_back(total());
    from = to;
  }
  addPart(curve, from, curve.length(), size);
}

double BendMeasure::arcAt(double m) const {
  if (m >= total()) return arc_.back();
  const auto next = std::lower_bound(measure_.begin(), measure_.end(), m);
  const auto k = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - measure_.begin(), 1, std::ssize(measure_) - 1));
  const double t = (m - measure_[k - 1]) / (measure_[k] - measure_[k - 1]);
  return arc_[k - 1] + t * (arc_[k] - arc_[k - 1]);
}

void BendMeasure::addPart(const SectionCurve& curve, double from, double to, double size) {
  const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / (kBendStep * size))));
  const double step = (to - from) / steps;
  std::vector<Vec3> chord;
  for (int k = 0; k < steps; ++k)
    chord.push_back((curve.at(from + (k + 1) * step) - curve.at(from + k * step)).normalized());
  std::vector<double> turn(chord.size() + 1, 0.0);
  for (std::size_t k = 1; k < chord.size(); ++k) turn[k] = turnBetween(chord[k - 1], chord[k]);
  for (std::size_t k = 0; k < chord.size(); ++k) {
    arc_.push_back(k + 1 == chord.size() ? to : from + static_cast<double>(k + 1) * step);
    measure_.push_back(total() + step + 0.5 * kBendWeight * size * (turn[k] + turn[k + 1]));
  }
}

}  // namespace cutwater
