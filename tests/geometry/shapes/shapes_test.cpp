#include "hydro/geometry/shapes/Shapes.h"

#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater {
namespace {

/// Faces of the closed hull below water, port side: they must be the panels themselves.
void expectWetPartIs(const SurfaceMesh& closed, const SurfaceMesh& wet) {
  EXPECT_TRUE(openEdges(closed).empty());
  EXPECT_GT(volumeIntegrals(closed).volume, 0.0);
  const SurfaceMesh port = cutAbove(cutBelow(closed), {Vec3::UnitY(), 0.0});
  ASSERT_EQ(port.faces.size(), wet.faces.size());
  for (std::size_t k = 0; k < wet.faces.size(); ++k)
    EXPECT_LT((vectorArea(port, port.faces[k]) - vectorArea(wet, wet.faces[k])).norm(), 1e-9);
}

TEST(Shapes, ClosedHullsAreWatertightAndTheirWetFacesAreThePanels) {
  expectWetPartIs(closedBox({10, 4, 2, 1}, 10, 2, 2), wetBox({10, 4, 2, 1}, 10, 2, 2));
  expectWetPartIs(closedSphere(10, 27, 16), wetHemisphere(10, 27, 16));
  expectWetPartIs(closedHalfEllipsoid({62.25, 7.4, 4.97}, 5, 50, 8),
                  wetHalfEllipsoid({62.25, 7.4, 4.97}, 50, 8));
  for (int hull = 1; hull <= 4; ++hull)
    expectWetPartIs(closedWigley(wigley(hull), 0.1, 40, 10), wetWigley(wigley(hull), 40, 10));
  expectWetPartIs(closedFrigate(48, 9), wetFrigate(48, 9));
}

TEST(Shapes, VerticesLieOnTheSurface) {
  for (const Vec3& p : wetHemisphere(10, 27, 16).vertices) EXPECT_NEAR(p.norm(), 10.0, 1e-14 * 10);
  for (const Vec3& p : wetHalfEllipsoid({62.25, 7.4, 4.97}, 50, 8).vertices)
    EXPECT_NEAR(p.cwiseQuotient(Vec3(62.25, 7.4, 4.97)).norm(), 1.0, 1e-14);
  EXPECT_EQ(wetHemisphere(10, 27, 16).faces.size(), 432u);
  EXPECT_EQ(wetHemisphere(10, 40, 26).faces.size(), 1040u);
}

TEST(ShapesConvergence, SphereAtSecondOrder) {
  const auto errors = [](int n) {
    const SurfaceMesh half = wetHemisphere(1.0, 5 * n, 3 * n);
    const VolumeIntegrals v = volumeIntegrals(half);
    return std::array{1 - v.volume / (kPi / 3),
                      1 - surfaceArea(half) / kPi,
                      1 - v.centroid().z() / (-3.0 / 8),
                      1 - v.centroid().y() / (3.0 / 8),
                      1 - waterplaneIntegrals(half).area / (kPi / 2),
                      1 - waterplaneIntegrals(half).yy / (kPi / 8)};
  };
  const auto coarse = errors(4), fine = errors(8);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_GT(fine[i], 0.0);  // inscribed: from below
    EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2.0, 0.06) << "quantity " << i;
  }
}

/// Exact integrals of Journée's hulls: ∫(1−ζ²)dζ = 2/3,
/// ∫(1−ξ²)(1+0.2ξ²)dξ = 2·(1 − 1/3 + 0.2/3 − 0.2/5), ∫(ζ²−ζ¹⁰)dζ = 8/33, ∫(1−ξ²)⁴dξ = 256/315
/// (whole range 2·128/315).
double wigleyVolume(const WigleyShape& w) {
  const double plane = 2 * (1 - 1.0 / 3 + 0.2 / 3 - 0.2 / 5);
  return w.breadth * 0.5 * w.length * w.draft *
         (2.0 / 3 * plane + w.alpha * 8.0 / 33 * 256.0 / 315);
}

TEST(ShapesConvergence, WigleyHullsAtSecondOrder) {
  for (int hull = 1; hull <= 4; ++hull) {
    const WigleyShape w = wigley(hull);
    const double plane = w.breadth * 0.5 * w.length * 2 * (1 - 1.0 / 3 + 0.2 / 3 - 0.2 / 5);
    const auto errors = [&](int n) {
      const SurfaceMesh half = wetWigley(w, 4 * n, n);
      return std::array{1 - 2 * volumeIntegrals(half).volume / wigleyVolume(w),
                        1 - 2 * waterplaneIntegrals(half).area / plane};
    };
    const auto coarse = errors(10), fine = errors(20);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      EXPECT_LT(std::abs(fine[i]), 2e-3);
      // Sections are cut into equal lengths, whose distribution itself still changes a little.
      EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2.0, 0.1) << "hull " << hull << ", " << i;
    }
  }
}

// Volumes that Journée's report gives for its four hulls, to its four decimals.
TEST(ShapesVerification, WigleyVolumesAreThoseOfTheReport) {
  const double reported[] = {0.0946, 0.1892, 0.0780, 0.1560};
  for (int hull = 1; hull <= 4; ++hull)
    EXPECT_NEAR(wigleyVolume(wigley(hull)), reported[hull - 1], 5e-5);
}

TEST(Shapes, EqualArcsAreEqual) {
  const auto circle = [](double t) { return Vec3(std::cos(t * t), std::sin(t * t), 0); };
  const std::vector<double> t = equalArcs(5, circle);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(t[i] * t[i], 0.2 * static_cast<double>(i), 1e-6);
}

TEST(Shapes, NonsenseIsRefused) {
  EXPECT_THROW(wetHemisphere(-1, 4, 4), HydroError);
  EXPECT_THROW(wetHemisphere(1, 0, 4), HydroError);
  EXPECT_THROW(wetBox({10, 0, 2, 1}, 1, 1, 1), HydroError);
  EXPECT_THROW(wigley(5), HydroError);
  EXPECT_THROW(frigateDivision(3), HydroError);
}

}  // namespace
}  // namespace cutwater
