#include "hydro/geometry/Hull.h"

#include <gtest/gtest.h>

#include <random>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

Fault faultOf(const SurfaceMesh& mesh, Symmetry symmetry = Symmetry::Auto) {
  try {
    makeHull(mesh, "test", symmetry);
  } catch (const HydroError& e) {
    EXPECT_EQ(std::string(e.what()).substr(0, 6), "test: ");
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    return e.fault();
  }
  ADD_FAILURE() << "accepted";
  return Fault::BadArgument;
}

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.vertices) p += by;
  return mesh;
}

TEST(HullIdentity, FacesTurnedAtRandomComeOutOutward) {
  std::mt19937 random(2);
  const SurfaceMesh hull = closedFrigate(16, 4);
  SurfaceMesh muddled = hull;
  for (Face& f : muddled.faces)
    if (random() % 2) std::reverse(f.v.begin(), f.v.begin() + f.size());
  const Hull made = makeHull(muddled, "test", Symmetry::Auto);
  EXPECT_TRUE(made.closed);
  EXPECT_TRUE(made.symmetric);
  EXPECT_NEAR(volumeIntegrals(made.surface).volume, volumeIntegrals(hull).volume, 1e-8);
}

TEST(Hull, EveryPieceOfACatamaranIsTurnedByItself) {
  const SurfaceMesh one = closedWigley(wigley(3), 0.1, 10, 3);
  const SurfaceMesh both = joined(moved(one, {0, 0.5, 0}), turnedOver(moved(one, {0, -0.5, 0})));
  const Hull made = makeHull(both, "test", Symmetry::Auto);
  EXPECT_TRUE(made.symmetric);
  EXPECT_NEAR(volumeIntegrals(made.surface).volume, 2 * volumeIntegrals(one).volume, 1e-12);
  EXPECT_GT(bounds(wetSurface(made)).low.y(), 0.3);
}

TEST(Hull, HalvesAreMirrored) {
  const SurfaceMesh port = wetFrigate(16, 4);
  for (const SurfaceMesh& half : {port, mirroredInY(port), turnedOver(port)})
    for (const Symmetry s : {Symmetry::Auto, Symmetry::Half}) {
      const Hull made = makeHull(half, "test", s);
      EXPECT_TRUE(made.symmetric);
      EXPECT_FALSE(made.closed);
      EXPECT_EQ(made.surface.faces.size(), 2 * port.faces.size());
      EXPECT_NEAR(volumeIntegrals(made.surface).volume, 2 * volumeIntegrals(port).volume, 1e-9);
      EXPECT_EQ(wetSurface(made).faces.size(), port.faces.size());
      EXPECT_GE(bounds(wetSurface(made)).low.y(), 0.0);
    }
  // Without permission to use symmetry, a half is a hull with a hole.
  EXPECT_EQ(faultOf(port, Symmetry::None), Fault::HullNotClosed);
}

TEST(Hull, AHullOnOneSideOfTheCentrelineIsNotAHalf) {
  const SurfaceMesh off = moved(closedSphere(1.0, 8, 4), {0, 2.0, 0});
  EXPECT_FALSE(makeHull(off, "test", Symmetry::Auto).symmetric);
  const Hull both = makeHull(off, "test", Symmetry::Half);
  EXPECT_TRUE(both.symmetric);
  EXPECT_NEAR(volumeIntegrals(both.surface).volume, 2 * volumeIntegrals(off).volume, 1e-12);
}

TEST(Hull, TheWallOfAClosedHalfGoes) {
  const SurfaceMesh half = wetBox({10, 4, 2, 1}, 5, 2, 2);
  SurfaceMesh withWall = half;
  const int n = static_cast<int>(withWall.vertices.size());
  withWall.vertices.insert(withWall.vertices.end(),
                           {{-5, 0, -2}, {5, 0, -2}, {5, 0, 0}, {-5, 0, 0}});
  withWall.faces.push_back({{n, n + 1, n + 2, n + 3}});
  EXPECT_EQ(makeHull(withWall, "test", Symmetry::Half).surface.faces.size(), 2 * half.faces.size());
}

TEST(Hull, SymmetryIsSeenOnlyWhereItIs) {
  SurfaceMesh hull = closedFrigate(16, 4);
  EXPECT_TRUE(makeHull(hull, "test", Symmetry::Auto).symmetric);
  EXPECT_FALSE(makeHull(hull, "test", Symmetry::None).symmetric);
  // A deckhouse to one side does not matter, a bulge below water does.
  EXPECT_TRUE(makeHull(joined(hull, moved(closedBox({8, 2, 1, 1}, 1, 1, 1), {0, 2, 12})), "test",
                       Symmetry::Auto)
                  .symmetric);
  for (Vec3& p : hull.vertices)
    if (p.y() > 5 && p.z() < -1 && std::abs(p.x()) < 10) p.y() += 0.01;
  EXPECT_FALSE(makeHull(hull, "test", Symmetry::Auto).symmetric);
}

TEST(Hull, RoundOffOfFilesIsForgiven) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-2e-5, 2e-5);  // m: six digits of 62 m
  SurfaceMesh soup;                                           // every face with vertices of its own
  const SurfaceMesh clean = closedFrigate(16, 4);
  for (const Face& f : clean.faces) {
    Face g = f;
    for (int i = 0; i < f.size(); ++i) {
      g.v[static_cast<std::size_t>(i)] = static_cast<int>(soup.vertices.size());
      soup.vertices.push_back(clean.corner(f, i) +
                              Vec3(noise(random), noise(random), noise(random)));
    }
    soup.faces.push_back(g);
  }
  const Hull made = makeHull(soup, "test", Symmetry::Auto);
  EXPECT_TRUE(made.closed);
  EXPECT_TRUE(made.symmetric);
  EXPECT_EQ(wetSurface(made).faces.size(), wetFrigate(16, 4).faces.size());
}

TEST(Hull, DoubledFacesCountOnce) {
  const SurfaceMesh hull = closedBox({10, 4, 2, 1}, 5, 2, 2);
  const Hull made = makeHull(joined(hull, turnedOver(hull)), "test", Symmetry::Auto);
  EXPECT_EQ(made.surface.faces.size(), hull.faces.size());
}

TEST(Hull, AHoleBelowWaterIsRefusedAndAboveItAllowed) {
  const SurfaceMesh hull = closedBox({10, 4, 2, 1}, 5, 2, 2);
  SurfaceMesh wetHole = hull, dryHole = hull;
  std::erase_if(wetHole.faces, [&](const Face& f) { return &f == &wetHole.faces[3]; });
  std::erase_if(dryHole.faces, [&](const Face& f) {
    return hull.corner(f, 0).z() == 1 && hull.corner(f, 1).z() == 1 && hull.corner(f, 2).z() == 1;
  });
  EXPECT_EQ(faultOf(wetHole), Fault::HullNotClosed);
  const Hull open = makeHull(dryHole, "test", Symmetry::Auto);
  EXPECT_FALSE(open.closed);
  EXPECT_TRUE(open.symmetric);
}

TEST(Hull, WhatCannotBeAHullIsRefused) {
  const SurfaceMesh sphere = closedSphere(1.0, 8, 4);
  EXPECT_EQ(faultOf(moved(sphere, {0, 0, 2})), Fault::HullNotInWater);
  EXPECT_EQ(faultOf(moved(sphere, {0, 0, -2})), Fault::HullNotInWater);
  EXPECT_EQ(faultOf({}), Fault::MeshEmpty);
  EXPECT_EQ(faultOf(moved(sphere, {0, 0, std::nan("")})), Fault::MeshNotFinite);
  SurfaceMesh bad = sphere;
  bad.faces[5].v[1] = 100000;
  EXPECT_EQ(faultOf(bad), Fault::MeshIndexOutOfRange);
  bad.faces[5].v[1] = -7;
  EXPECT_EQ(faultOf(bad), Fault::MeshIndexOutOfRange);
  // A tank inside the hull would count twice.
  EXPECT_EQ(faultOf(joined(closedSphere(3.0, 12, 6), sphere)), Fault::HullPartHidden);
  // Vertices on both sides of a "half".
  EXPECT_EQ(faultOf(sphere, Symmetry::Half), Fault::HullNotSymmetric);
}

TEST(Hull, AOneSidedSurfaceIsRefused) {
  // A Möbius band, its rim above water, so that no hole is in the way: it is one-sided all the
  // same.
  SurfaceMesh band;
  const int n = 24;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 across = std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitZ();
    band.vertices.push_back(4 * out - across + Vec3(0, 0, 1.5));
    band.vertices.push_back(4 * out + across + Vec3(0, 0, 1.5));
  }
  for (int i = 0; i + 1 < n; ++i) band.faces.push_back({{2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2}});
  band.faces.push_back({{2 * n - 2, 2 * n - 1, 0, 1}});
  EXPECT_EQ(faultOf(joined(closedSphere(1.0, 8, 4), band)), Fault::HullInverted);
}

}  // namespace
}  // namespace cutwater
