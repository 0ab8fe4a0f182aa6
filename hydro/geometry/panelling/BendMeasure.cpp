#include "hydro/geometry/panelling/BendMeasure.h"

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

constexpr double kBendStep = 0.15;     // of a panel edge: how finely bends are measured
constexpr double kBendWeight = 0.4;    // panels for a turn of one radian
constexpr double kCornerWindow = 0.2;  // of a panel edge: how far chords beside a corner reach
constexpr double kCornerWeight = 1.0;  // panels on either side, for each radian beyond kSoftCorner:
constexpr double kSoftCorner = 20 * kPi / 180;  // so a chine that fades has none at its end

double turnBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Panels that a corner asks for on either side. In a hollow one water is slow: none.
double weightOf(const SectionCurve& curve, double corner, double size) {
  const double window = kCornerWindow * size;
  const Vec3 here = curve.at(corner);
  const Vec3 before = here - curve.at(corner - window), behind = curve.at(corner + window) - here;
  if (before.cross(behind).x() > 0.0) return 0.0;
  return kCornerWeight * std::max(0.0, turnBetween(before, behind) - kSoftCorner);
}

}  // namespace

BendMeasure::BendMeasure(const SectionCurve& curve, const std::vector<double>& corners, double size,
                         double weight)
    : arc_{0.0}, measure_{0.0} {
  Part part{0.0, 0.0, 0.0, 0.0};
  for (const double to : corners) {
    part.to = to;
    part.weightTo = weight * weightOf(curve, to, size);
    addPart(curve, part, size);
    corners_.push_back(total());
    part.from = to;
    part.weightFrom = part.weightTo;
  }
  part.to = curve.length();
  part.weightTo = 0.0;
  addPart(curve, part, size);
}

double BendMeasure::arcAt(double m) const {
  if (m >= total()) return arc_.back();
  const auto next = std::lower_bound(measure_.begin(), measure_.end(), m);
  const auto k = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - measure_.begin(), 1, std::ssize(measure_) - 1));
  const double t = (m - measure_[k - 1]) / (measure_[k] - measure_[k - 1]);
  return arc_[k - 1] + t * (arc_[k] - arc_[k - 1]);
}

void BendMeasure::addPart(const SectionCurve& curve, const Part& part, double size) {
  const double length = part.to - part.from;
  const int steps = std::max(2, static_cast<int>(std::ceil(length / (kBendStep * size))));
  const double step = length / steps;
  std::vector<Vec3> chord;
  for (int k = 0; k < steps; ++k)
    chord.push_back(
        (curve.at(part.from + (k + 1) * step) - curve.at(part.from + k * step)).normalized());
  std::vector<double> turn(chord.size() + 1, 0.0);
  for (std::size_t k = 1; k < chord.size(); ++k) turn[k] = turnBetween(chord[k - 1], chord[k]);
  const double fade = std::exp(-step / size);
  double fromCorner = 1.0, toCorner = std::exp(-length / size);
  for (std::size_t k = 0; k < chord.size(); ++k) {
    const double near =
        part.weightFrom * fromCorner * (1.0 - fade) + part.weightTo * toCorner * (1.0 / fade - 1.0);
    arc_.push_back(k + 1 == chord.size() ? part.to : part.from + static_cast<double>(k + 1) * step);
    measure_.push_back(total() + step +
                       size * (0.5 * kBendWeight * (turn[k] + turn[k + 1]) + near));
    fromCorner *= fade;
    toCorner /= fade;
  }
}

}  // namespace cutwater
