#pragma once
#include <algorithm>
#include <cmath>

#include "hydro/base/Simd.h"
#include "hydro/bem/matrices/PanelPairs.h"

namespace cutwater {

/// How much of a wave a panel feels, set against its centroid:
///     S(ê) = (1/A) ∫ e^{K s_z − iK ê·s} dS,   s from the centroid, ê horizontal unit vector
/// for a wave that runs along ê (as seen from far away, e^{−iKh}, h growing along ê); S(−ê) is the
/// conjugate. By cumulants up to the fourth: exact to θ⁵, θ = K·(half the panel's length), 0.4 % of
/// 1 at θ = 1.5 and 2 % at θ = 2, where a panel is 2/3 of a wave long; towards 0 beyond.
///
/// Tabulated at one wave number in steps of 1/32 of the quadrant's |sin|/(|sin| + |cos|), linear
/// between: 2e-4 θ².
/// THEORY.md, chapter 5.
class FormFactors {
 public:
  static constexpr int kSteps = 128;

  /// @param all  panels to be tabulated: of the hull, or of hull and lid.
  FormFactors(const PanelPairs& pairs, int all, double K);

  /// (kSteps + 1) values in a row, the last equal to the first.
  const Complex* of(int panel) const {
    return &values_[static_cast<std::size_t>(panel) * (kSteps + 1)];
  }
  /// Unit vector whose |sin|/(|sin| + |cos|), counted on through the quadrants, is step/32.
  static Eigen::Vector2d directionOf(int step);
  /// The inverse: the place, 0 … kSteps, of a unit vector.
  static CUTWATER_INLINE double placeOf(double ex, double ey) {
    const double sine = ey / (std::abs(ex) + std::abs(ey));
    constexpr double kQuadrant = 0.25 * kSteps;
    return kQuadrant * (ex < 0.0 ? 2.0 - sine : sine < 0.0 ? 4.0 + sine : sine);
  }
  /// One panel's values, linear between steps.
  static CUTWATER_INLINE Complex between(const Complex* values, double place) {
    const int cell = std::min(static_cast<int>(place), kSteps - 1);
    return values[cell] + (place - cell) * (values[cell + 1] - values[cell]);
  }

 private:
  std::vector<Complex> values_;
};

}  // namespace cutwater
