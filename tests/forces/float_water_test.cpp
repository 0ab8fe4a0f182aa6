// The water beside small bodies: its velocity and gradient, the ellipsoid's added mass, shapes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hydro/forces/floats/Ellipsoid.h"
#include "hydro/forces/floats/FloatBody.h"
#include "hydro/forces/floats/FloatHull.h"
#include "hydro/forces/floats/FloatShapes.h"
#include "hydro/forces/floats/FloatWater.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater::test {
namespace {

constexpr double kRoundOff = 1e-12;

// A ball's is half of what it displaces, and nothing about its axes.
TEST(EllipsoidClosedForm, ABallHasHalfItsVolume) {
  const EllipsoidMass ball = ellipsoidMass(Vec3::Constant(2.0), 1025.0);
  const double displaced = 1025.0 * 4.0 / 3.0 * kPi * 8.0;
  EXPECT_NEAR((ball.linear / displaced - Vec3::Constant(0.5)).norm(), 0.0, kRoundOff);
  EXPECT_EQ(ball.angular.norm(), 0.0);
}

TEST(EllipsoidClosedForm, IntegralsSumToTwo) {
  for (const Vec3& a : {Vec3(1, 2, 3), Vec3(10, 0.1, 1), Vec3(1, 1, 1e-3)})
    EXPECT_NEAR(ellipsoidIntegrals(a).sum(), 2.0, 1e-11);
}

// A disc: 8/3 ρa³ across, 16/45 ρa⁵ about a diameter; thin to 1e-4, which is felt at that.
TEST(EllipsoidClosedForm, ADiscIsKnown) {
  const double a = 1.5;
  const EllipsoidMass disc = ellipsoidMass({a, a, 1e-4 * a}, 1000.0);
  EXPECT_NEAR(disc.linear.z() / (8.0 / 3.0 * 1000.0 * a * a * a), 1.0, 5e-4);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(disc.angular[axis] / (16.0 / 45.0 * 1000.0 * std::pow(a, 5)), 1.0, 5e-4);
    // It turns with the slope of the water: about x with ∂w/∂y, about y against ∂w/∂x.
    EXPECT_NEAR(disc.straining[axis] / disc.angular[axis], axis == 0 ? 1.0 : -1.0, 1e-6);
  }
}

// Prolate spheroids by their own closed form, e² = 1 − b²/a² [Lamb32] § 114:
//   α = 2(1 − e²)/e³ (artanh e − e),   β = 1 − ½α
TEST(EllipsoidClosedForm, ProlateSpheroids) {
  for (const double ratio : {1.01, 2.0, 5.0, 40.0}) {
    const double e = std::sqrt(1.0 - 1.0 / (ratio * ratio));
    const double alpha = 2.0 * (1.0 - e * e) / (e * e * e) * (std::atanh(e) - e);
    const double beta = 1.0 - 0.5 * alpha;
    const EllipsoidMass mass = ellipsoidMass({ratio, 1.0, 1.0}, 1.0);
    const double volume = 4.0 / 3.0 * kPi * ratio;
    // artanh e − e loses three digits where e is small.
    EXPECT_NEAR(mass.linear.x() / volume, alpha / (2.0 - alpha), 1e-11);
    EXPECT_NEAR(mass.linear.y() / volume, beta / (2.0 - beta), 1e-11);
    const double square = ratio * ratio;
    const double turning = (square - 1.0) * (square - 1.0) * (beta - alpha) /
                           (2.0 * (square - 1.0) + (square + 1.0) * (alpha - beta)) / 5.0;
    EXPECT_NEAR(mass.angular.y() / (volume * square), turning / square, 1e-10);
  }
}

SeaState crossedSea(WaveProfile profile) {
  return SeaState({{.omega = 0.8, .amplitude = 0.7, .phase = 0.4, .heading = 0.3},
                   {.omega = 1.7, .amplitude = 0.2, .phase = 2.0, .heading = -1.9}},
                  kStandardGravity, 10.0, profile);
}

TEST(FloatWaterIdentity, VelocityIsTheSeasAndTheGradientIsItsSlope) {
  const SeaState sea = crossedSea(WaveProfile::Extrapolated);
  FloatWater water(sea);
  const double h = 1e-4;
  // Five places: one more than a block.
  std::vector<FloatWater::Place> places;
  for (int i = 0; i < 5; ++i) places.push_back({Vec3(3.0 * i, -20.0 + 7.0 * i, -2.0 - i), 0.0});
  std::vector<FloatWater::Motion> motions(places.size());
  water.motion(7.0, places, motions);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LT((motions[i].velocity - sea.velocity(7.0, places[i].at)).norm(), kRoundOff);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = h * Vec3::Unit(axis);
      const Vec3 slope =
          (sea.velocity(7.0, places[i].at + step) - sea.velocity(7.0, places[i].at - step)) /
          (2.0 * h);
      EXPECT_LT((motions[i].gradient.col(axis) - slope).norm(), 1e-8);  // differences
    }
  }
}

// Above the water it is that at the surface; with Wheeler's profile the surface has that of z = 0.
TEST(FloatWaterIdentity, ProfilesEndAtTheSurface) {
  for (const WaveProfile profile :
       {WaveProfile::Extrapolated, WaveProfile::Wheeler, WaveProfile::Constant}) {
    const SeaState sea = crossedSea(profile);
    FloatWater water(sea);
    const double zeta = sea.elevation(30.0, 2.0, 3.0);
    const std::array<FloatWater::Place, 2> places{
        {{Vec3(2.0, 3.0, zeta), 0.0}, {Vec3(2.0, 3.0, zeta + 9.0), 0.0}}};
    std::array<FloatWater::Motion, 2> motions;
    water.motion(30.0, places, motions);
    EXPECT_LT((motions[0].velocity - motions[1].velocity).norm(), kRoundOff);
    if (profile == WaveProfile::Wheeler) {
      EXPECT_LT((motions[0].velocity - sea.velocity(30.0, {2.0, 3.0, 0.0})).norm(), kRoundOff);
    }
  }
}

// Far from the middle of a long body no short wave says more than its own velocity.
TEST(FloatWaterIdentity, GradientsOfShortWavesEnd) {
  const double omega = 3.0, a = 0.1, reach = 6.0;
  FloatWater water(SeaState({{.omega = omega, .amplitude = a}}, kStandardGravity));
  std::vector<FloatWater::Place> places(64);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = {Vec3(0.1 * static_cast<double>(i), 0.0, 0.0), reach};
  std::vector<FloatWater::Motion> motions(places.size());
  water.motion(0.0, places, motions);
  for (const auto& one : motions) {
    EXPECT_LE(reach * one.gradient.norm() / std::sqrt(2.0),
              omega * a * std::exp(omega * omega * a / kStandardGravity) * (1.0 + kRoundOff));
  }
}

TEST(FloatShapesClosedForm, ShapesAreClosedAndHaveTheirVolume) {
  struct Case {
    SurfaceMesh mesh;
    double volume;
  };
  const Case cases[] = {{floatBox({1, 2, 0.3}), 8 * 0.6},
                        {floatBox({6.0, 1.2, 1.3}), 8 * 6.0 * 1.2 * 1.3},
                        {floatBall(0.7), 4.0 / 3.0 * kPi * 0.343},
                        {floatCylinder(0.4, 0.5), kPi * 0.16},
                        {floatCapsule(0.3, 0.5), kPi * 0.09 * 1.4},
                        {floatCapsule(0.3, 0.01), kPi * 0.09 * 0.42},
                        {floatCone(0.5, 1.2), kPi * 0.1}};
  for (const Case& one : cases) {
    EXPECT_TRUE(openEdges(one.mesh).empty());
    const VolumeIntegrals whole = volumeIntegrals(one.mesh);
    EXPECT_NEAR(whole.volume, one.volume, kRoundOff * one.volume);
    EXPECT_LE(one.mesh.faces.size(), FloatHull::kMostTriangles);
  }
  EXPECT_LT((volumeIntegrals(floatBox({1, 2, 0.3})).moment).norm(), kRoundOff);
}

TEST(FloatShapesClosedForm, SecondMomentsOfABox) {
  const Mat3 expected = Vec3(8 * 6.0 / 3.0, 8 * 6.0 * 4.0 / 3.0, 8 * 6.0 * 9.0 / 3.0).asDiagonal();
  EXPECT_LT((secondMoments(floatBox({1, 2, 3})) - expected).norm(), 1e-10);
}

TEST(FloatShapesClosedForm, OverlapIsSeen) {
  SurfaceMesh shifted = floatBox({1, 1, 1});
  for (Vec3& p : shifted.vertices) p.x() += 1.0;
  const std::array<SurfaceMesh, 2> crossed{floatBox({1, 1, 1}), shifted};
  EXPECT_NEAR(overlapOf(crossed), 0.5, 0.1);  // half of each; a lattice of nine
  for (Vec3& p : shifted.vertices) p.x() += 1.0;
  const std::array<SurfaceMesh, 2> beside{floatBox({1, 1, 1}), shifted};
  EXPECT_EQ(overlapOf(beside), 0.0);
}

// A ball and a box along other axes than their own.
TEST(FloatHullIdentity, EllipsoidsLieAsTheBodyDoes) {
  const FloatHull ball(floatBall(0.5));
  EXPECT_LT((ball.semiAxes() - Vec3::Constant(0.5)).norm(), 1e-9);
  EXPECT_LT((ball.linear() - 0.5 * ball.volume() * Mat3::Identity()).norm(), 1e-9);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const SurfaceMesh box = floatBox({1, 2, 0.3});
  SurfaceMesh turned = box;
  for (Vec3& p : turned.vertices) p = turn * p;
  const FloatHull as(box), along(turned);
  EXPECT_LT((along.linear() - turn * as.linear() * turn.transpose()).norm(), 1e-9);
  EXPECT_LT((along.angular() - turn * as.angular() * turn.transpose()).norm(), 1e-9);
  const Mat3 strain = (Mat3() << 1, 2, 3, 2, -4, 5, 3, 5, 3).finished();
  EXPECT_LT((along.strained(turn * strain * turn.transpose()) - turn * as.strained(strain)).norm(),
            1e-9);
}

// In calm water at rest a body has Archimedes' force and no more, and no drag.
TEST(FloatBodyClosedForm, AtRestThereIsBuoyancyAlone) {
  FloatBody body(std::make_shared<const FloatHull>(floatBox({1, 1, 0.5})), {});
  const std::size_t n = body.points();
  std::vector<double> x(n), y(n), z(n), zero(n, 0.0);
  body.place({{3.0, 4.0, 0.1}, Mat3::Identity()}, {x, y, z});
  body.press(10.0, {z, zero, zero, zero});
  const double buoyancy = 1025.0 * 10.0 * 4.0 * 0.4;
  EXPECT_NEAR(body.pressure()[Heave], buoyancy, 1e-9 * buoyancy);
  EXPECT_NEAR(body.immersion(), 0.4, kRoundOff);
  const FloatBody::Tick tick = body.tick({}, 1640.0, {}, 0.01);
  EXPECT_NEAR(tick.impulse[Heave], 0.01 * buoyancy, 1e-9 * buoyancy);
  EXPECT_LT((tick.impulse - tick.impulse[Heave] * Vec6::Unit(Heave)).norm(), 1e-9 * buoyancy);
  // A and D are those of motion, so that what it moves is positive in every direction.
  EXPECT_GT(tick.inertia.diagonal().minCoeff(), 0.0);
}

}  // namespace
}  // namespace cutwater::test
