#include "hydro/ship/Afloat.h"

#include <gtest/gtest.h>

#include "hydro/Errors.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater {
namespace {

constexpr double kL = 20.0, kB = 6.0, kT = 2.0;

PanelledHull boxHull() { return {{}, wetBox({kL, kB, kT, 1.0}, 8, 4, 2), true}; }

// C of a box with G at (x_G, 0, z_G): BM = B²/12T and L²/12T. Flat panels have no error but
// round-off.
TEST(AfloatClosedForm, ABoxHasTheHydrostaticsOfItsFormula) {
  const double xG = 0.5, zG = 0.7, rho = 1000.0, g = 9.81, V = kL * kB * kT;
  const Afloat made = afloat(boxHull(), {.cog = {xG, 0.0, zG}}, {rho, g});
  const ShipParticulars& ship = made.ship;
  EXPECT_NEAR(ship.volume, V, 1e-9 * V);
  EXPECT_NEAR(ship.mass, rho * V, 1e-9 * rho * V);
  EXPECT_NEAR((ship.centreOfBuoyancy - Vec3(0.0, 0.0, -0.5 * kT)).norm(), 0.0, 1e-12);
  const double unit = rho * g, arm = V * (-0.5 * kT - zG);
  EXPECT_NEAR(ship.restoring(Heave, Heave), unit * kL * kB, 1e-9 * unit * kL * kB);
  EXPECT_NEAR(ship.restoring(Heave, Pitch), unit * kL * kB * xG, 1e-9 * unit * kL * kB);
  EXPECT_NEAR(ship.restoring(Roll, Roll), unit * (kL * kB * kB * kB / 12.0 + arm), 1e-9 * unit * V);
  EXPECT_NEAR(ship.restoring(Pitch, Pitch),
              unit * (kB * kL * kL * kL / 12.0 + kL * kB * xG * xG + arm), 1e-9 * unit * V * kL);
  EXPECT_EQ(made.hydrostatics.restoring, ship.restoring);
  EXPECT_EQ(ship.gyradii, Vec3(0.35 * kB, 0.25 * kL, 0.25 * kL));
  EXPECT_EQ(ship.density, rho);
  EXPECT_EQ(ship.gravity, g);
  EXPECT_NEAR(ship.length(), kL, 1e-12);
  EXPECT_NEAR(ship.beam(), kB, 1e-12);
}

TEST(Afloat, WhatIsGivenIsKept) {
  Loading loading{.mass = 2.5e5, .cog = {0.1, 0.2, 0.3}, .gyradii = Vec3(1.0, 2.0, 3.0)};
  loading.supplementary.damping[Roll] = 7.0;
  const ShipParticulars ship = afloat(boxHull(), loading).ship;
  EXPECT_EQ(ship.mass, 2.5e5);
  EXPECT_EQ(ship.cog, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(ship.gyradii, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(ship.supplementary.damping[Roll], 7.0);
  EXPECT_EQ(ship.wetSurface.faces.size(), boxHull().panels.faces.size());
  EXPECT_TRUE(ship.symmetric);
}

// Panels are inscribed in the hull, so that they lack volume; the ship's mass, volume and C are the
// hull's, to the round-off of 2000 m³.
TEST(AfloatIdentity, AShipHasTheHydrostaticsOfItsHullNotOfItsPanels) {
  const Vec3 cog(-2.4, 0.0, 1.29);
  const SurfaceMesh surface = closedFrigate(48, 14);
  const Afloat own = afloat({surface, wetFrigate(48, 14), true}, {.cog = cog});
  const Afloat coarse = afloat({surface, wetFrigate(16, 4), true}, {.cog = cog});
  const Afloat panelsAlone = afloat({{}, wetFrigate(16, 4), true}, {.cog = cog});
  EXPECT_NEAR(coarse.ship.volume, own.ship.volume, 1e-9 * own.ship.volume);
  EXPECT_NEAR(coarse.ship.mass, own.ship.mass, 1e-9 * own.ship.mass);
  EXPECT_LT((coarse.ship.restoring - own.ship.restoring).norm(), 1e-9 * own.ship.restoring.norm());
  EXPECT_LT(panelsAlone.ship.volume, 0.99 * own.ship.volume);
  EXPECT_EQ(coarse.ship.wetSurface.faces.size(), panelsAlone.ship.wetSurface.faces.size());
}

// C46 = −ρgV(x_B − x_G) is the moment that would trim the ship.
// Of a hull and of panels alone, as a database of another code has them.
TEST(AfloatIdentity, TheHydrostaticsOfAShipAreFoundAgain) {
  PanelledHull hull = boxHull();
  for (const bool whole : {false, true}) {
    if (whole) hull.surface = bothHalves(hull.panels);
    const Afloat made = afloat(hull, {.cog = {0.5, 0.0, 0.7}});
    const Hydrostatics again = hydrostaticsOf(made.ship);
    EXPECT_EQ(again.restoring, made.hydrostatics.restoring);
    EXPECT_EQ(again.volume, made.hydrostatics.volume);
    EXPECT_EQ(again.draft, made.hydrostatics.draft);
  }
}

TEST(AfloatIdentity, ALevelShipHasNoMomentAtRest) {
  const FrigateDivision division = frigateDivision(224);
  const PanelledHull hull{{}, wetFrigate(division.along, division.girth), true};
  const ShipParticulars trimmed = afloat(hull, {.cog = {0.0, 0.0, 1.29}}).ship;
  const ShipParticulars level = afloat(hull, {.cog = {0.0, 0.0, 1.29}, .level = true}).ship;
  EXPECT_GT(std::abs(trimmed.restoring(Roll, Yaw)), 1e6);
  EXPECT_EQ(level.restoring(Roll, Yaw), 0.0);
  EXPECT_EQ(level.cog.x(), level.centreOfBuoyancy.x());
  EXPECT_EQ(level.cog.z(), 1.29);
}

// The panels of a hull as it is: half of a symmetric hull, the whole of another; the same ship.
TEST(AfloatIdentity, HalfAndWholeAreTheSameShip) {
  const SurfaceMesh box = closedBox({kL, kB, kT, 1.0}, 8, 4, 3);
  const ShipParticulars half = afloat(panelledAsItIs(makeHull(box, "box", Symmetry::Auto))).ship;
  const ShipParticulars whole = afloat(panelledAsItIs(makeHull(box, "box", Symmetry::None))).ship;
  EXPECT_TRUE(half.symmetric);
  EXPECT_FALSE(whole.symmetric);
  EXPECT_NEAR(half.mass, whole.mass, 1e-9 * whole.mass);
  EXPECT_LT((half.restoring - whole.restoring).norm(), 1e-9 * whole.restoring.norm());
  EXPECT_NEAR(half.beam(), whole.beam(), 1e-9);
  EXPECT_FALSE(half.hull.faces.empty());
}

TEST(Afloat, RefusesAHullOutOfTheWater) { EXPECT_THROW(afloat({{}, {}, false}), HydroError); }

}  // namespace
}  // namespace cutwater
