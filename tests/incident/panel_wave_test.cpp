#include <gtest/gtest.h>

#include "hydro/geometry/panels/PanelQuadrature.h"
#include "hydro/incident/PanelWave.h"

namespace cutwater::test {
namespace {

Panel slanted(bool triangle) {
  const Vec3 a(0.3, 0.2, -0.5), b(2.1, 0.5, -0.7), c(1.8, 1.4, -1.6);
  if (triangle) return flatPanel({a, b, c});
  return flatPanel({a, b, c, a + 0.8 * (c - b)});
}

Eigen::Vector3cd deepWater(double k, double heading) {
  return {Complex(0.0, -k * std::cos(heading)), Complex(0.0, k * std::sin(heading)), k};
}

// 16 × 16 points are exact to round-off for waves down to the panel's own length. Waves from
// 1000 panels long, where points take over from the edges, to half a panel; 1e-9 as stated.
TEST(PanelWaveClosedForm, EdgesGiveWhatManyPointsGive) {
  const Vec3 origin(0.4, 0.0, 0.0);
  for (const bool triangle : {false, true})
    for (const double k : {1e-3, 0.02, 0.03, 0.05, 0.4, 2.0, 8.0})
      for (const double heading : {0.0, 0.7, kPi / 2, 2.5, kPi}) {
        const Panel panel = slanted(triangle);
        const Eigen::Vector3cd kappa = deepWater(k, heading);
        const PanelWave wave = panelWave(panel, kappa, origin);
        Complex sum = 0.0;
        Eigen::Vector3cd moment = Eigen::Vector3cd::Zero();
        for (const QuadraturePoint& point : panelQuadrature(panel, 16)) {
          const Complex e =
              point.weight * std::exp((kappa.transpose() * (point.x - origin)).value());
          sum += e;
          moment += e * (point.x - panel.centroid);
        }
        const double size = panel.area * std::exp(k * panel.centroid.z());
        EXPECT_LT(std::abs(wave.sum - sum), 1e-9 * size) << k << ' ' << heading;
        EXPECT_LT((wave.moment - moment).norm(), 1e-9 * size) << k << ' ' << heading;
      }
}

// A hundred waves on a panel: no overflow, and no more than the waves on its edges carry.
TEST(PanelWaveClosedForm, WavesMuchShorterThanThePanel) {
  const Panel panel = slanted(false);
  const PanelWave wave = panelWave(panel, deepWater(2000.0, 0.3), Vec3::Zero());
  EXPECT_TRUE(std::isfinite(wave.sum.real()) && wave.moment.allFinite());
  EXPECT_LT(std::abs(wave.sum), 1e-100);  // e^{-2000·0.5}
}

}  // namespace
}  // namespace cutwater::test
