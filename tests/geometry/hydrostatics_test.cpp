#include "hydro/geometry/Hydrostatics.h"

#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

constexpr double kRho = 1025.0, kG = 9.80665;

TEST(HydrostaticsClosedForm, BoxIsExact) {
  const Vec3 cog(0.5, 0.0, 1.0);
  const Hydrostatics h = hydrostatics(cutBelow(closedBox({60, 16, 4, 4}, 6, 2, 2)), cog, kRho, kG);
  const double tolerance = 1e-11;  // relative; round-off of the sums
  const double v = 60 * 16 * 4, a = 60 * 16, it = 60 * std::pow(16, 3) / 12,
               il = 16 * std::pow(60, 3) / 12;
  EXPECT_NEAR(h.volume, v, tolerance * v);
  EXPECT_NEAR(h.displacement, kRho * v, tolerance * kRho * v);
  EXPECT_NEAR(h.wettedArea, a + 2 * 4 * (60 + 16), tolerance * a);
  EXPECT_NEAR(h.waterplaneArea, a, tolerance * a);
  EXPECT_NEAR(h.buoyancy.z(), -2.0, tolerance);
  EXPECT_NEAR(h.kb, 2.0, tolerance);
  EXPECT_NEAR(h.bmT, it / v, 1e-10);
  EXPECT_NEAR(h.bmL, il / v, 1e-9);
  EXPECT_NEAR(h.gmT, it / v - 2 - 1, 1e-10);
  EXPECT_NEAR(h.gmL, il / v - 2 - 1, 1e-9);
  EXPECT_DOUBLE_EQ(h.draft, 4.0);
  EXPECT_DOUBLE_EQ(h.length, 60.0);
  EXPECT_DOUBLE_EQ(h.beam, 16.0);
  Mat6 c = Mat6::Zero();
  c(2, 2) = a;
  c(2, 4) = c(4, 2) = 0.5 * a;  // the waterplane's centroid is 0.5 m aft of G
  c(3, 3) = it + v * (-2 - 1);
  c(4, 4) = il + 0.25 * a + v * (-2 - 1);
  c(3, 5) = v * 0.5;
  EXPECT_LT((h.restoring - kRho * kG * c).cwiseAbs().maxCoeff(), 1e-11 * kRho * kG * il);
}

/// Buoyancy force and moment about G of the closed hull held in a small displacement η.
Vec6 buoyancyLoad(const SurfaceMesh& hull, const Vec3& cog, const Vec6& eta) {
  const Mat3 r =
      (Eigen::AngleAxisd(eta[5], Vec3::UnitZ()) * Eigen::AngleAxisd(eta[4], Vec3::UnitY()) *
       Eigen::AngleAxisd(eta[3], Vec3::UnitX()))
          .toRotationMatrix();
  SurfaceMesh moved = hull;
  for (Vec3& p : moved.vertices) p = cog + eta.head<3>() + r * (p - cog);
  const VolumeIntegrals v = volumeIntegrals(cutBelow(moved));
  const Vec3 force(0, 0, kRho * kG * v.volume);
  Vec6 load;
  load << force, (v.centroid() - cog - eta.head<3>()).cross(force);
  return load;
}

// C is the derivative of the buoyancy load, whatever the hull and wherever G is: the hull here is
// skewed, heeled and has no symmetry, so every entry counts.
TEST(HydrostaticsIdentity, RestoringIsTheDerivativeOfBuoyancy) {
  SurfaceMesh hull;
  const SurfaceMesh shape = closedFrigate(24, 5);
  hull.vertices = shape.vertices;
  for (const Face& f : shape.faces)  // flat faces, so that cutting is exact
    for (int i = 1; i + 1 < f.size(); ++i) hull.faces.push_back({{f[0], f[i], f[i + 1], -1}});
  for (Vec3& p : hull.vertices)
    p += Vec3(0, 0.1 * p.z() + 0.02 * p.x() + 0.5, 0.05 * p.y() - 0.01 * p.x());
  const Vec3 cog(-4.0, 0.7, 1.5);
  const Mat6 c = hydrostatics(cutBelow(hull), cog, kRho, kG).restoring;
  for (int k = 0; k < 6; ++k) {
    const double step = k < 3 ? 1e-3 : 1e-5;
    Vec6 eta = Vec6::Zero();
    eta[k] = step;
    const Vec6 slope = (buoyancyLoad(hull, cog, eta) - buoyancyLoad(hull, cog, -eta)) / (2 * step);
    for (int j = 0; j < 6; ++j) {
      const double scale = std::sqrt(std::abs(c(j, j) * c(k, k))) + 0.01 * std::abs(c(3, 3));
      // Central difference: error of order step², and 1e-12 of the load by round-off over the step.
      EXPECT_NEAR(-slope[j], c(j, k), 2e-5 * scale) << "C" << j + 1 << k + 1;
    }
  }
}

TEST(HydrostaticsConvergence, HalfEllipsoidApproachesItsFormulaAtSecondOrder) {
  const EllipsoidShape e{62.25, 7.4, 4.97};
  const double v = 2.0 / 3 * kPi * e.a * e.b * e.c;
  const auto errors = [&](int n) {
    const Hydrostatics h =
        hydrostatics(cutBelow(closedHalfEllipsoid(e, 5, 4 * n, n)), Vec3::Zero(), kRho, kG);
    return std::array{1 - h.volume / v, 1 - h.waterplaneArea / (kPi * e.a * e.b),
                      1 - h.buoyancy.z() / (-3.0 / 8 * e.c),
                      1 - h.bmT * h.volume / (kPi * e.a * std::pow(e.b, 3) / 4),
                      1 - h.bmL * h.volume / (kPi * e.b * std::pow(e.a, 3) / 4)};
  };
  const auto coarse = errors(8), fine = errors(16);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_LT(std::abs(fine[i]), 5e-3);
    EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2.0, 0.05) << "quantity " << i;
  }
}

TEST(Hydrostatics, NonsenseIsRefused) {
  const SurfaceMesh wet = cutBelow(closedSphere(1, 6, 3));
  EXPECT_THROW(hydrostatics(wet, Vec3::Zero(), 0.0, kG), HydroError);
  EXPECT_THROW(hydrostatics(turnedOver(wet), Vec3::Zero(), kRho, kG), HydroError);
  EXPECT_THROW(hydrostatics({}, Vec3::Zero(), kRho, kG), HydroError);
}

}  // namespace
}  // namespace cutwater
