#include "hydro/ship/Righting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "hydro/ship/StabilityRange.h"
#include "tests/support/CsvTable.h"
#include "tests/support/Hulls.h"
#include "tests/support/Refusal.h"
#include "tests/support/Results.h"

namespace cutwater {
namespace {

constexpr double kDegree = kPi / 180.0;

/// In triangles, those to starboard the mirror images of those to port.
PanelledHull inTriangles(const SurfaceMesh& hull) {
  const SurfaceMesh port = triangulated(cutAbove(hull, {Vec3::UnitY(), 0.0}));
  return panelledAsItIs({bothHalves(port), true, true});
}

ShipParticulars shipOf(const SurfaceMesh& hull, const Vec3& cog, std::optional<double> mass = {}) {
  return afloat(inTriangles(hull), {.mass = mass, .cog = cog}).ship;
}

/// A box whose G is `kg` above its keel.
ShipParticulars boxShip(double length, double B, double D, double T, double kg, int divided = 1) {
  return shipOf(closedBox({length, B, T, D - T}, divided, divided, divided), {0.0, 0.0, kg - T});
}

SurfaceMesh catamaran() {
  const SurfaceMesh one = test::chinedHull(20, 2, 2, true);
  return joined(test::moved(one, {0, 10, 0}), test::moved(one, {0, -10, 0}));
}

/// Ships of all kinds, G over the centre of buoyancy.
std::map<std::string, ShipParticulars> ships() {
  const auto level = [](const SurfaceMesh& hull, double z, double heavier = 1.0) {
    ShipParticulars ship = afloat(inTriangles(hull), {.cog = {0.0, 0.0, z}, .level = true}).ship;
    ship.mass *= heavier;
    return ship;
  };
  return {{"frigate", level(closedFrigate(24, 8), 1.29)},
          {"frigate, deep", level(closedFrigate(24, 8), 1.29, 1.5)},
          {"catamaran", level(catamaran(), 1.0)},
          {"Wigley", level(closedWigley(wigley(3), 0.1, 20, 6), 0.02)},
          {"box", boxShip(60.0, 20.0, 12.0, 8.0, 7.0, 2)},
          {"box, deck just above water", boxShip(60.0, 20.0, 12.0, 11.999, 5.0)},
          {"box, hardly in the water", boxShip(60.0, 20.0, 12.0, 0.01, 0.5)}};
}

// The project's acceptance line: every row to 1e-6 of the beam. The box has any length, any
// division, and trims nowhere.
TEST(RightingClosedForm, LeversOfBoxesToBothSides) {
  const test::CsvTable table("ship/box_gz_exact.csv");
  double worst = 0.0;
  for (const auto& [length, divided] : {std::pair{60.0, 1}, {15.0, 3}}) {
    for (const RightingTrim trim : {RightingTrim::Free, RightingTrim::Fixed}) {
      std::map<std::vector<double>, Righting> boxes;
      for (std::size_t i = 0; i < table.rows(); ++i) {
        std::vector<double> box;
        for (const char* name : {"B", "D", "T", "KG"}) box.push_back(table.number(i, name));
        const double B = box[0];
        const ShipParticulars ship = boxShip(length, B, box[1], box[2], box[3], divided);
        Righting& righting = boxes.try_emplace(box, ship, trim).first->second;
        StillWater water(ship);
        for (const double side : {1.0, -1.0}) {
          const RightingLever lever = righting.at(side * table.number(i, "phi_deg") * kDegree);
          const Immersed wet = water.at({lever.heightOfG, lever.heel, lever.trim});
          for (const double off :
               {side * lever.gz - table.number(i, "GZ_m"),
                -lever.heightOfG - table.number(i, "waterline_above_CG_m"),
                wet.centre.z() - table.number(i, "buoyancy_centre_above_CG_m")}) {
            EXPECT_LT(std::abs(off), 1e-6 * B) << "row " << i << ", length " << length;
            worst = std::max(worst, std::abs(off) / B);
          }
          EXPECT_NEAR(lever.trim, 0.0, 1e-9);
        }
      }
    }
  }
  test::recordResult("Wetted hull", "righting levers of boxes, 0 to 180 deg, of the beam",
                     "exact: polygon clipping", worst, "1e-6");
}

// While deck edge and bilge stay where they are, gz = (GM + ½BM tan²φ) sin φ. Round-off only.
TEST(RightingClosedForm, WallSidedBox) {
  const double B = 20.0, D = 20.0, T = 8.0, kg = 7.0, bm = B * B / (12.0 * T);
  Righting righting(boxShip(50.0, B, D, T, kg), RightingTrim::Free);
  for (double heel = -38.0; heel <= 38.0; heel += 4.0) {
    const double tangent = std::tan(heel * kDegree), gm = 0.5 * T + bm - kg;
    const double exact = (gm + 0.5 * bm * tangent * tangent) * std::sin(heel * kDegree);
    EXPECT_NEAR(righting.at(heel * kDegree).gz, exact, 1e-12 * B) << heel;
  }
}

// gz = 0 there: tan²φ = −2GM/BM, while wall-sided. Acceptance: 0.001°; reached: round-off.
TEST(StabilityRangeClosedForm, AngleOfLollOfBoxes) {
  const double B = 20.0, T = 8.0, bm = B * B / (12.0 * T);
  double worst = 0.0;
  for (const double gm : {-0.001, -0.1, -0.5, -1.0, -1.3}) {
    for (const double side : {1.0, -1.0}) {
      Righting righting(boxShip(70.0, B, 20.0, T, 0.5 * T + bm - gm), RightingTrim::Free);
      const StabilityRange range = stabilityRange(righting, side * kPi);
      ASSERT_TRUE(range.rest);
      EXPECT_NEAR(range.gm, gm, 1e-6 * B);
      const double loll = side * std::atan(std::sqrt(-2.0 * gm / bm));
      EXPECT_NEAR(*range.rest / kDegree, loll / kDegree, 1e-7);
      worst = std::max(worst, std::abs(*range.rest - loll) / kDegree);
    }
  }
  // Half of a square, G in its middle: on its corner, as both diagonals are symmetric.
  Righting square(boxShip(40.0, 10.0, 10.0, 5.0, 5.0), RightingTrim::Free);
  const StabilityRange range = stabilityRange(square, kPi);
  ASSERT_TRUE(range.rest);
  EXPECT_NEAR(*range.rest / kDegree, 45.0, 1e-7);
  EXPECT_NEAR(range.gm, 10.0 / 6.0 - 2.5, 1e-6);
  ASSERT_TRUE(range.vanishing);
  EXPECT_NEAR(*range.vanishing / kDegree, 90.0, 1e-7);
  test::recordResult("Wetted hull", "angle of loll of boxes [deg]", "tan² = -2GM/BM", worst,
                     "0.001");
}

// A sphere sees no heel: gz = GM sin φ with GM = −z_G from its centre, greatest on its side, and it
// rests upright only. The mesh lies inside the sphere, by the square of its step: on half the step
// a quarter of the error; 3.5, as the mesh is not yet fine.
TEST(RightingConvergence, ABuoysLeverIsASine) {
  const auto worst = [](int around) {
    Righting buoy(shipOf(closedSphere(5.0, around, around), {0.0, 0.0, -1.0}), RightingTrim::Free);
    double off = 0.0;
    for (int heel = 0; heel <= 180; heel += 15)
      off = std::max(off, std::abs(buoy.at(heel * kDegree).gz - std::sin(heel * kDegree)));
    const StabilityRange range = stabilityRange(buoy, kPi);
    EXPECT_EQ(*range.rest, 0.0);
    EXPECT_FALSE(range.vanishing);
    EXPECT_NEAR(range.greatest->heel / kDegree, 90.0, 2.0);
    return off;
  };
  const double coarse = worst(12), fine = worst(24);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(coarse / fine, 3.5);
}

// The weight balances the pressure, nothing tilts the ship about the level y, the volume is the
// mass's: to round-off in every attitude, also where the deck is under or hardly a corner is in.
TEST(RightingIdentity, EveryShipIsBalancedAtEveryHeel) {
  for (const auto& [name, ship] : ships()) {
    Righting righting(ship, RightingTrim::Free);
    StillWater water(ship);
    const double weight = ship.mass * ship.gravity, scale = righting.scale();
    for (int heel = -180; heel <= 180; heel += 5) {
      const RightingLever lever = righting.at(heel * kDegree);
      const Immersed wet = water.at({lever.heightOfG, lever.heel, lever.trim});
      EXPECT_NEAR(wet.force.z(), weight, 1e-11 * weight) << name << " " << heel;
      EXPECT_NEAR(wet.moment.y(), 0.0, 1e-10 * weight * scale) << name << " " << heel;
      EXPECT_NEAR(wet.moment.x(), -weight * lever.gz, 1e-10 * weight * scale);
      EXPECT_NEAR(lever.volume * ship.density, ship.mass, 1e-11 * ship.mass);
      // Its deck under water, that box has no waterplane; keel up its G lies above the buoyancy.
      if (name != "box, deck just above water") {
        EXPECT_TRUE(lever.trimIsStable) << name << " " << heel;
      }
    }
    EXPECT_TRUE(righting.trimJumps().empty()) << name;
  }
}

// A ship alike to both sides heels alike to both.
TEST(RightingIdentity, LeversAreOddAndTheRestIsEven) {
  for (const auto& [name, ship] : ships()) {
    Righting righting(ship, RightingTrim::Free);
    const double scale = righting.scale();
    for (int heel = 0; heel <= 180; heel += 15) {
      const RightingLever right = righting.at(heel * kDegree), left = righting.at(-heel * kDegree);
      EXPECT_NEAR(right.gz, -left.gz, 1e-11 * scale) << name << " " << heel;
      EXPECT_NEAR(right.height, left.height, 1e-11 * scale) << name << " " << heel;
      EXPECT_NEAR(right.trim, left.trim, 1e-11) << name << " " << heel;
      if (heel % 180 == 0) {
        EXPECT_NEAR(right.gz, 0.0, 1e-11 * scale);
      }
    }
  }
}

// The work of heeling: of E/mg = z_G − z_B the slope over heel is gz cos(trim), as what is free is
// balanced. Central differences of 1e-4 rad: 1e-8 of the third derivative; a corner that comes out
// of the water jumps in the second: 1e-4 of it.
TEST(RightingIdentity, TheLeverIsTheSlopeOfTheEnergy) {
  for (const auto& [name, ship] : ships()) {
    Righting righting(ship, RightingTrim::Free);
    StillWater water(ship);
    const auto energy = [&](double heel) {
      const RightingLever lever = righting.at(heel);
      return -water.at({lever.heightOfG, lever.heel, lever.trim}).centre.z();
    };
    for (int heel = 7; heel < 180; heel += 11) {
      const double at = heel * kDegree, step = 1e-4;
      const RightingLever lever = righting.at(at);
      EXPECT_NEAR((energy(at + step) - energy(at - step)) / (2.0 * step),
                  lever.gz * std::cos(lever.trim), 1e-4 * righting.scale())
          << name << " " << heel;
    }
  }
}

TEST(Righting, UprightAShipFloatsAsItsFileSays) {
  ShipParticulars ship = ships().at("frigate");
  ship.file.origin = {3.0, 0.0, -2.5};
  Righting righting(ship, RightingTrim::Free);
  const RightingLever lever = righting.at(0.0);
  EXPECT_NEAR(lever.gz, 0.0, 1e-11);
  EXPECT_NEAR(lever.trim, 0.0, 1e-11);
  EXPECT_NEAR(lever.height, -2.5, 1e-10);
  EXPECT_NEAR(lever.volume, ship.volume, 1e-8);
}

// What was asked before does not matter: the way is always that from upright by whole degrees.
TEST(Righting, LeversDoNotDependOnWhatElseWasAsked) {
  const ShipParticulars ship = ships().at("frigate, deep");
  Righting one(ship, RightingTrim::Free), other(ship, RightingTrim::Free);
  for (int heel = 0; heel < 100; heel += 9) other.at((heel + 0.3) * kDegree);
  EXPECT_EQ(one.at(1.7).gz, other.at(1.7).gz);
  EXPECT_EQ(one.at(1.7).trim, other.at(1.7).trim);
}

TEST(Righting, AShipWithItsWeightAftTrimsByTheStern) {
  const ShipParticulars ship = shipOf(closedBox({60.0, 20.0, 8.0, 4.0}, 1, 1, 1), {-0.5, 0, -1.0});
  Righting free(ship, RightingTrim::Free), fixed(ship, RightingTrim::Fixed);
  // Wall-sided along: x_G cos θ … = (GM + ½BM tan²θ) sin θ, solved for G off the middle.
  const double bm = 60.0 * 60.0 / 96.0, gm = bm + 4.0 - 7.0, t = std::tan(free.at(0.0).trim);
  EXPECT_NEAR((gm + 0.5 * bm * t * t) * t, -0.5, 1e-11);
  EXPECT_EQ(fixed.at(0.4).trim, 0.0);
}

// Long cylinders of short ships: keel up with a low G, a buoy would rather turn end over end.
TEST(Righting, ATrimThatDoesNotComeBackIsTold) {
  Righting buoy(shipOf(closedSphere(5.0, 8, 8), {0.0, 0.0, -1.0}), RightingTrim::Free);
  EXPECT_TRUE(buoy.at(60.0 * kDegree).trimIsStable);
  EXPECT_FALSE(buoy.at(150.0 * kDegree).trimIsStable);
  EXPECT_NEAR(buoy.at(150.0 * kDegree).trim, 0.0, 1e-9);
}

// A short box with a low G, heeled far: its trim runs away and ends, as it would stand on its end.
// What is told before and after is balanced all the same, and the jump is told with its heel.
TEST(Righting, ATrimThatEndsIsTold) {
  const ShipParticulars ship = shipOf(closedBox({12.0, 7.5, 4.7, 6.9}, 1, 1, 1), {-0.16, 0, -1.3});
  Righting righting(ship, RightingTrim::Free);
  StillWater water(ship);
  for (int heel = 0; heel <= 180; heel += 2) {
    const RightingLever lever = righting.at(heel * kDegree);
    const Immersed wet = water.at({lever.heightOfG, lever.heel, lever.trim});
    EXPECT_NEAR(wet.centre.x(), 0.0, 1e-10 * righting.scale()) << heel;
    EXPECT_NEAR(wet.volume, ship.volume, 1e-11 * ship.volume) << heel;
  }
  ASSERT_EQ(righting.trimJumps().size(), 1u);
  const Righting::TrimJump& jump = righting.trimJumps().front();
  EXPECT_NEAR(righting.at(jump.heel - 1e-3).trim, jump.from, 5.0 * kDegree);
  EXPECT_NEAR(righting.at(jump.heel + 1e-3).trim, jump.to, 5.0 * kDegree);
  EXPECT_FALSE(righting.at(jump.heel + 1e-3).trimIsStable);
}

TEST(StabilityRange, GreatestLeverAndWhereItVanishes) {
  Righting righting(boxShip(60.0, 20.0, 12.0, 8.0, 7.0), RightingTrim::Free);
  const StabilityRange range = stabilityRange(righting, kPi);
  EXPECT_EQ(*range.rest, 0.0);
  EXPECT_NEAR(range.gm, 4.0 + 400.0 / 96.0 - 7.0, 1e-6);
  // box_gz_exact.csv: 0.74953 m at 35 deg, 0.73737 at 40; above 0 at 65, below at 70.
  EXPECT_NEAR(range.greatest->heel / kDegree, 36.0, 3.0);
  EXPECT_GT(range.greatest->gz, 0.74953485);
  for (const double off : {-0.1, 0.1})
    EXPECT_GT(range.greatest->gz, righting.at(range.greatest->heel + off * kDegree).gz);
  EXPECT_NEAR(*range.vanishing / kDegree, 67.0, 1.0);
  EXPECT_NEAR(righting.at(*range.vanishing).gz, 0.0, 1e-10);
  const StabilityRange port = stabilityRange(righting, -kPi);
  EXPECT_NEAR(*port.vanishing, -*range.vanishing, 1e-10);
  EXPECT_NEAR(port.greatest->gz, -range.greatest->gz, 1e-10);
  // Beyond what was asked nothing is told.
  const StabilityRange narrow = stabilityRange(righting, 30.0 * kDegree);
  EXPECT_FALSE(narrow.vanishing);
  EXPECT_FALSE(narrow.greatest);
}

TEST(StabilityRange, AListAndAShipThatOnlyRestsKeelUp) {
  // G to port: tan φ ≈ y/GM, to port; the wall-sided lever has y cos φ besides.
  const double gm = 4.0 + 400.0 / 96.0 - 7.0, bm = 400.0 / 96.0;
  Righting listed(shipOf(closedBox({60.0, 20.0, 8.0, 4.0}, 1, 1, 1), {0.0, 0.1, -1.0}),
                  RightingTrim::Free);
  for (const double side : {1.0, -1.0}) {
    const StabilityRange range = stabilityRange(listed, side * kPi);
    const double t = std::tan(*range.rest);
    EXPECT_LT(t, 0.0);
    EXPECT_NEAR((gm + 0.5 * bm * t * t) * t, -0.1, 1e-10);
  }
  Righting top(boxShip(60.0, 4.0, 12.0, 6.0, 11.5), RightingTrim::Free);
  EXPECT_LT(stabilityRange(top, kPi).gm, 0.0);
  EXPECT_FALSE(stabilityRange(top, kPi).rest);
}

TEST(Righting, WhatCannotFloatIsRefused) {
  const SurfaceMesh box = closedBox({60.0, 20.0, 8.0, 4.0}, 1, 1, 1);
  const double whole = 60.0 * 20.0 * 12.0 * kSeaWaterDensity;
  for (const double share : {1.0, 1.2, 50.0}) {
    test::expectRefusal(Fault::ValueOutOfRange, {"mass", "14400 m^3", "sinks"}, [&] {
      Righting sunk(shipOf(box, {0.0, 0.0, 0.0}, share * whole), RightingTrim::Free);
    });
  }
  test::expectRefusal(Fault::ValueOutOfRange, {"no trim", "at heel 0 deg", "on its end"}, [&] {
    Righting ahead(shipOf(box, {500.0, 0.0, 0.0}), RightingTrim::Free);
  });
  Righting righting(shipOf(box, {0.0, 0.0, 0.0}), RightingTrim::Free);
  test::expectRefusal(Fault::ValueOutOfRange, {"heel"}, [&] { righting.at(30.0); });
}

}  // namespace
}  // namespace cutwater
