#include <gtest/gtest.h>

#include <random>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/ship/StillWater.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

ShipParticulars shipOf(const SurfaceMesh& hull, const Vec3& cog) {
  // Triangles to starboard are the mirror images of those to port.
  const SurfaceMesh port = triangulated(cutAbove(hull, {Vec3::UnitY(), 0.0}));
  return afloat(panelledAsItIs({bothHalves(port), true, true}), {.cog = cog}).ship;
}

/// The hull as it stands in level axes, z from calm water.
SurfaceMesh held(const ShipParticulars& ship, const Attitude& pose) {
  SurfaceMesh mesh = ship.hull;
  for (Vec3& p : mesh.vertices) p = pose.rotation() * (p - ship.cog) + Vec3(0.0, 0.0, pose.height);
  return mesh;
}

// Archimedes in any attitude, against another way: the hull cut by the plane, the volume below by
// the divergence theorem. Tolerance: round-off of sums over faces, and the 1e-9 of the diagonal at
// which the cut moves vertices onto the plane.
TEST(StillWaterClosedForm, ArchimedesInAnyAttitude) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> size(0.5, 20.0), angle(-kPi, kPi), share(-1.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const BoxShape box{size(random), size(random), size(random), size(random)};
    const ShipParticulars ship = i % 3 == 0 ? shipOf(closedFrigate(16, 5), {-2.4, 0.0, 1.29})
                                            : shipOf(closedBox(box, 1 + i % 4, 1 + i % 2, 1),
                                                     {0.3 * share(random), 0.1, 0.2});
    StillWater water(ship);
    const double scale = bounds(ship.hull).diagonal(), weight = ship.density * ship.gravity;
    const Attitude pose{0.4 * scale * share(random), angle(random), angle(random)};
    const Immersed wet = water.at(pose);
    const VolumeIntegrals below = volumeIntegrals(cutBelow(held(ship, pose)));
    const double whole = water.wholeVolume();
    EXPECT_NEAR(wet.volume, below.volume, 1e-8 * whole);
    EXPECT_NEAR(wet.force.z(), weight * wet.volume, 1e-11 * weight * whole);
    EXPECT_LT(wet.force.head<2>().norm(), 1e-11 * weight * whole);
    EXPECT_LT((wet.moment - wet.centre.cross(wet.force)).norm(), 1e-11 * weight * whole * scale);
    const Vec3 moment = wet.volume * (wet.centre + Vec3(0.0, 0.0, pose.height));
    EXPECT_LT((moment - below.moment).norm(), 1e-8 * whole * scale);
  }
}

TEST(StillWaterClosedForm, AHullUnderWaterOrOutOfIt) {
  const ShipParticulars ship = shipOf(closedFrigate(16, 5), {-2.4, 0.0, 1.29});
  StillWater water(ship);
  const VolumeIntegrals whole = volumeIntegrals(ship.hull);
  const double weight = ship.density * ship.gravity * whole.volume;
  for (const double roll : {0.0, 1.0, kPi}) {
    const Attitude deep{-200.0, roll, 0.3};
    const Immersed wet = water.at(deep);
    // 1e-12: sums over faces of terms 200 m deep.
    EXPECT_NEAR(wet.volume, whole.volume, 1e-12 * whole.volume);
    EXPECT_LT((wet.centre - deep.rotation() * (whole.centroid() - ship.cog)).norm(), 1e-9);
    EXPECT_LT((wet.force - Vec3(0.0, 0.0, weight)).norm(), 1e-11 * weight);
    const Immersed dry = water.at({200.0, roll, 0.3});
    EXPECT_EQ(dry.volume, 0.0);
    EXPECT_EQ(dry.force, Vec3::Zero());
  }
}

TEST(StillWaterClosedForm, ABoxFloatsWhereItsVolumeSays) {
  const ShipParticulars ship = shipOf(closedBox({30.0, 8.0, 2.0, 3.0}, 1, 1, 1), {0.0, 0.0, 1.0});
  StillWater water(ship);
  for (const double guess : {-50.0, 1.0, 400.0})  // keel at −(z_G − height) − T
    EXPECT_NEAR(water.afloat(30.0 * 8.0 * 4.5, {.height = guess}).height, 1.0 - 2.5, 1e-14 * 30.0);
  // On its side: 5 m wide, 8 m deep; G 0.5 m off the middle of the depth, which is level now.
  EXPECT_NEAR(water.afloat(30.0 * 5.0 * 1.0, {.roll = kPi / 2.0}).height, 3.0, 1e-14 * 30.0);
  EXPECT_NEAR(water.afloat(1e-6, {.roll = kPi}).height, 2.0 - 1e-6 / 240.0, 1e-14 * 30.0);
}

// The error of the linear load is quadratic in the displacement: halved, it falls to a quarter, or
// to an eighth where a symmetric hull leaves no quadratic term. 3.8: what is cubic besides.
TEST(StillWaterConvergence, LinearBuoyancyIsTheLimitOfSmallDisplacements) {
  const ShipParticulars ship = shipOf(closedFrigate(24, 8), {-2.4, 0.0, 1.29});
  StillWater water(ship);
  const double weight = ship.mass * ship.gravity;
  const auto error = [&](Attitude shift) {
    const Vec6 linear = linearBuoyancyLoad(ship, shift);
    shift.height += ship.cog.z();
    return (buoyancyLoad(water, shift) - linear).cwiseAbs().eval();
  };
  EXPECT_LT(error({}).maxCoeff(), 1e-10 * weight);
  for (const Attitude& unit : {Attitude{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.1}}) {
    const auto at = [&](double size) {
      return error({size * unit.height, size * unit.roll, size * unit.pitch});
    };
    const Vec6 large = at(2e-3), small = at(1e-3);
    for (int j = 0; j < 6; ++j) {
      if (large[j] > 1e-8 * weight) {
        EXPECT_GT(large[j] / small[j], 3.8) << "mode " << j + 1;
      }
    }
    EXPECT_GT(large.maxCoeff(), 1e-8 * weight);  // or nothing was compared
  }
}

// Rotations about the ship's own x and the level y are those whose work the parts of the moment
// are: −dE/d(height, roll, pitch) with E = −ρg∫z dV below water, which is −F₃ z_B. Central
// differences of 1e-4: 1e-8 of the curvature, and round-off 1e-12.
TEST(StillWaterIdentity, LoadsAreTheSlopeOfEnergy) {
  const ShipParticulars ship = shipOf(closedFrigate(16, 5), {-2.4, 0.0, 1.29});
  StillWater water(ship);
  const double step = 1e-4, weight = ship.density * ship.gravity * ship.volume;
  const auto energy = [&](Attitude pose) {
    const Immersed wet = water.at(pose);
    return -wet.force.z() * (pose.height + wet.centre.z());
  };
  for (const Attitude& pose :
       {Attitude{0.5, 0.3, 0.02}, {-1.0, 1.9, -0.05}, {2.0, -2.8, 0.3}, {1.0, 0.7, 1.2}}) {
    const Vec6 load = buoyancyLoad(water, pose);
    const auto slope = [&](double height, double roll, double pitch) {
      const auto moved = [&](double s) {
        return Attitude{pose.height + s * height, pose.roll + s * roll, pose.pitch + s * pitch};
      };
      return -(energy(moved(step)) - energy(moved(-step))) / (2.0 * step);
    };
    EXPECT_NEAR(load[Heave], slope(1.0, 0.0, 0.0), 1e-5 * weight);
    EXPECT_NEAR(load[Roll], slope(0.0, 1.0, 0.0), 1e-4 * weight);
    EXPECT_NEAR(load[Pitch], slope(0.0, 0.0, 1.0), 1e-3 * weight);
    EXPECT_NEAR(load[Yaw], 0.0, 1e-9 * weight);
  }
}

// Of any hull in any attitude, by central differences of 1e-5: 1e-10 of the third derivative and
// round-off 1e-11; bounds for a corner that comes out of the water meanwhile.
TEST(StillWaterIdentity, SlopesOfVolumeAndMoment) {
  const ShipParticulars ship = shipOf(closedFrigate(16, 5), {-2.4, 0.0, 1.29});
  StillWater water(ship);
  const double step = 1e-5, V = ship.volume, L = 124.5;
  for (const Attitude& pose :
       {Attitude{0.5, 0.3, 0.02}, {-1.0, 1.9, -0.05}, {2.0, -2.8, 0.3}, {1.0, 0.7, 1.2}}) {
    const ImmersedSlopes slopes = water.slopes(pose);
    const auto change = [&](double height, double pitch) {
      const Immersed more = water.at({pose.height + height, pose.roll, pose.pitch + pitch});
      const Immersed less = water.at({pose.height - height, pose.roll, pose.pitch - pitch});
      return std::pair{
          (more.volume - less.volume) / (2.0 * step),
          (more.volume * more.centre.x() - less.volume * less.centre.x()) / (2.0 * step)};
    };
    const auto [area, areaMoment] = change(step, 0.0);
    const auto [turned, momentSlope] = change(0.0, step);
    EXPECT_NEAR(slopes.area, -area, 1e-5 * V);
    EXPECT_NEAR(slopes.areaMoment, -areaMoment, 1e-5 * V * L);
    EXPECT_NEAR(slopes.areaMoment, turned, 1e-5 * V * L);
    EXPECT_NEAR(slopes.momentSlope, momentSlope, 1e-5 * V * L * L);
  }
}

TEST(StillWater, AHullThatIsOpenIsRefused) {
  ShipParticulars ship = shipOf(closedBox({30.0, 8.0, 2.0, 3.0}, 1, 1, 1), {0.0, 0.0, 1.0});
  ship.hull.faces.pop_back();
  test::expectRefusal(Fault::HullNotClosed, {"not closed", "open edges"},
                      [&] { StillWater water(ship); });
  ship.hull = {};
  test::expectRefusal(Fault::MeshEmpty, {"no faces"}, [&] { StillWater water(ship); });
}

}  // namespace
}  // namespace cutwater
