#include "hydro/bem/matrices/PanelMoments.h"

#include "hydro/geometry/panels/PanelQuadrature.h"

namespace cutwater {

PanelMoments::PanelMoments(const Panel& panel) : second{}, third{}, fourth{} {
  u = (panel.corner[2] - panel.corner[0]).normalized();
  v = panel.normal.cross(u);
  for (const QuadraturePoint& point : panelQuadrature(panel, 3)) {
    const Vec3 s = point.x - panel.centroid;
    const double a = u.dot(s), b = v.dot(s), w = point.weight / panel.area;
    const std::array<double, 5> powerA{1.0, a, a * a, a * a * a, a * a * a * a},
        powerB{1.0, b, b * b, b * b * b, b * b * b * b};
    for (std::size_t i = 0; i < 3; ++i) second[i] += w * powerA[2 - i] * powerB[i];
    for (std::size_t i = 0; i < 4; ++i) third[i] += w * powerA[3 - i] * powerB[i];
    for (std::size_t i = 0; i < 5; ++i) fourth[i] += w * powerA[4 - i] * powerB[i];
  }
  const auto [aa, ab, bb] = second;
  const std::array<double, 5> gaussian{3.0 * aa * aa, 3.0 * aa * ab, aa * bb + 2.0 * ab * ab,
                                       3.0 * bb * ab, 3.0 * bb * bb};
  constexpr std::array<double, 5> binomial{1.0, 4.0, 6.0, 4.0, 1.0};
  for (std::size_t i = 0; i < 5; ++i) fourth[i] = binomial[i] * (fourth[i] - gaussian[i]);
  second[1] *= 2.0;
  third[1] *= 3.0;
  third[2] *= 3.0;
}

}  // namespace cutwater
