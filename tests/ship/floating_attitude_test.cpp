#include <gtest/gtest.h>

#include <cmath>

#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/ship/FloatingAttitude.h"
#include "hydro/ship/StillWater.h"
#include "tests/support/Refusal.h"

namespace cutwater {
namespace {

constexpr double kL = 20.0, kB = 6.0, kT = 2.0, kFreeboard = 3.0;

/// A box drawn at a draught of 2 m.
ShipParticulars box(double mass, const Vec3& cog) {
  const PanelledHull hull{closedBox({kL, kB, kT, kFreeboard}, 4, 2, 2),
                          wetBox({kL, kB, kT, kFreeboard}, 4, 2, 2), true};
  return afloat(hull, {.mass = mass, .cog = cog}).ship;
}

double massAt(double draught) { return kSeaWaterDensity * kL * kB * draught; }

TEST(FloatingAttitudeClosedForm, ABoxSinksByItsMassOverItsWaterplane) {
  for (const double draught : {0.5, 2.0, 3.5}) {
    const FloatingAttitude rest = floatingAttitude(box(massAt(draught), {0, 0, -1}), false);
    EXPECT_NEAR(rest.height, kT - draught, 1e-9);  // found to round-off
    EXPECT_NEAR(rest.trim, 0.0, 1e-9);
    EXPECT_EQ(rest.heel, 0.0);
  }
}

// Wall-sided to any angle at which neither deck nor bottom come to calm water: with t = tan of the
// trim, B moves by t L²/12T along and t² L²/24T up in the box's own axes, and G lies over it where
//     x_G = t (BM + z_B − z_G) + t³ BM / 2,   BM = L²/12T
TEST(FloatingAttitudeClosedForm, ABoxTrimsAsAWallSidedBodyDoes) {
  const double draught = 2.5, keel = -kT, zG = -0.4;
  const double bm = kL * kL / (12 * draught), zB = keel + draught / 2;
  for (const double t : {0.01, -0.05, 0.1}) {
    const double xG = t * (bm + zB - zG) + 0.5 * t * t * t * bm;
    const FloatingAttitude rest = floatingAttitude(box(massAt(draught), {xG, 0, zG}), false);
    EXPECT_NEAR(std::tan(rest.trim), t, 1e-8);
  }
}

TEST(FloatingAttitudeClosedForm, ABoxHeelsAsAWallSidedBodyDoes) {
  const double draught = 2.5, keel = -kT, zG = -0.6;
  const double bm = kB * kB / (12 * draught), zB = keel + draught / 2;
  for (const double t : {0.02, -0.15}) {
    const double yG = t * (bm + zB - zG) + 0.5 * t * t * t * bm;
    const FloatingAttitude rest = floatingAttitude(box(massAt(draught), {0, -yG, zG}), true);
    EXPECT_NEAR(std::tan(rest.heel), t, 1e-8);  // starboard down is positive, y is to port
  }
}

// Trim and heel together: weight and buoyancy are equal and B lies below G.
TEST(FloatingAttitudeIdentity, AtRestNothingTurnsTheShip) {
  const ShipParticulars ship = box(massAt(2.2), {0.3, -0.04, -0.8});
  const FloatingAttitude rest = floatingAttitude(ship, true);
  EXPECT_GT(rest.trim, 0.005);
  EXPECT_GT(rest.heel, 0.005);
  Attitude pose{.roll = rest.heel, .pitch = rest.trim};
  pose.height = rest.height + (pose.rotation() * ship.cog).z();
  StillWater water(ship);
  const Immersed wet = water.at(pose);
  EXPECT_NEAR(wet.volume, ship.mass / ship.density, 1e-9 * wet.volume);  // round-off
  EXPECT_NEAR(wet.centre.x(), 0.0, 1e-8);                                // findRoot's 1e-10 rad
  EXPECT_NEAR(wet.centre.y(), 0.0, 1e-8);
}

TEST(FloatingAttitude, WhatFallsOverAndWhatSinksIsRefused) {
  test::expectRefusal(Fault::ValueOutOfRange, {"falls over"}, [] {
    floatingAttitude(box(massAt(2.0), {0, 0, 2.5}), false);
  });
  test::expectRefusal(Fault::ValueOutOfRange, {"sinks"}, [] {
    floatingAttitude(box(massAt(6.0), {0, 0, -1}), false);
  });
}

}  // namespace
}  // namespace cutwater
