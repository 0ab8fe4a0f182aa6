#include <gtest/gtest.h>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

constexpr double kRoundOff = 1e-13;

TEST(MeshIntegralsClosedForm, TetrahedronAnywhere) {
  const Vec3 o(3, -2, 5);
  const SurfaceMesh t{{o, o + Vec3(2, 0, 0), o + Vec3(0, 3, 0), o + Vec3(0, 0, 4)},
                      {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{0, 3, 2, -1}}, {{1, 2, 3, -1}}}};
  const VolumeIntegrals v = volumeIntegrals(t);
  EXPECT_NEAR(v.volume, 2.0 * 3 * 4 / 6, 100 * kRoundOff);
  EXPECT_LT((v.centroid() - (o + Vec3(0.5, 0.75, 1.0))).norm(), 100 * kRoundOff);
  // Three right triangles and the slanted one, ½|(−2,3,0) × (−2,0,4)| = ½√(144 + 64 + 36).
  EXPECT_NEAR(surfaceArea(t), 3 + 4 + 6 + 0.5 * std::sqrt(244.0), 100 * kRoundOff);
  const WaterplaneIntegrals w = waterplaneIntegrals(t);
  EXPECT_NEAR(w.area, 0.0, 10 * kRoundOff);
  EXPECT_NEAR(w.xx, 0.0, 100 * kRoundOff);
}

TEST(MeshIntegralsClosedForm, BoxIsExact) {
  const SurfaceMesh half = wetBox({10, 4, 2, 1}, 5, 2, 2);
  SurfaceMesh wet = joined(half, mirroredInY(half));
  for (Vec3& p : wet.vertices) p += Vec3(7, 1, 0);
  const VolumeIntegrals v = volumeIntegrals(wet);
  EXPECT_NEAR(v.volume, 80.0, 1000 * kRoundOff);
  EXPECT_LT((v.centroid() - Vec3(7, 1, -1)).norm(), 100 * kRoundOff);
  EXPECT_NEAR(surfaceArea(wet), 40 + 2 * 20 + 2 * 8, 1000 * kRoundOff);
  const WaterplaneIntegrals w = waterplaneIntegrals(wet);
  EXPECT_NEAR(w.area, 40.0, 1000 * kRoundOff);
  EXPECT_NEAR(w.x, 280.0, 1e4 * kRoundOff);
  EXPECT_NEAR(w.xx, 40 * 49 + 4 * 1000.0 / 12, 1e5 * kRoundOff);
  EXPECT_NEAR(w.yy, 40 * 1 + 10 * 64.0 / 12, 1e5 * kRoundOff);
  EXPECT_NEAR(w.xy, 40 * 7 * 1, 1e5 * kRoundOff);
}

TEST(MeshIntegralsIdentity, TurningASurfaceOverTurnsTheSignOfItsVolume) {
  const SurfaceMesh mesh = closedFrigate(16, 4);
  EXPECT_NEAR(volumeIntegrals(turnedOver(mesh)).volume, -volumeIntegrals(mesh).volume,
              1e-9);  // 13 000 m³ at double precision
}

TEST(MeshIntegralsIdentity, ATwistedQuadrilateralCountsAsTheMeanOfItsTriangulations) {
  const SurfaceMesh quads = closedWigley(wigley(2), 0.1, 10, 4);
  SurfaceMesh one{quads.vertices, {}}, two = one;
  for (const Face& f : quads.faces) {
    if (f.size() == 3) {
      one.faces.push_back(f);
      two.faces.push_back(f);
      continue;
    }
    one.faces.push_back({{f[0], f[1], f[2], -1}});
    one.faces.push_back({{f[0], f[2], f[3], -1}});
    two.faces.push_back({{f[0], f[1], f[3], -1}});
    two.faces.push_back({{f[1], f[2], f[3], -1}});
  }
  EXPECT_NE(volumeIntegrals(one).volume, volumeIntegrals(two).volume);
  EXPECT_NEAR(volumeIntegrals(quads).volume,
              0.5 * (volumeIntegrals(one).volume + volumeIntegrals(two).volume), kRoundOff);
}

}  // namespace
}  // namespace cutwater
