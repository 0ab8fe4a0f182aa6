#include "hydro/forces/manoeuvring/Resistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "tests/forces/SlowMotion.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

constexpr double kLength = 40.0, kBeam = 8.0, kDraught = 2.0, kDrag = 1.3;
constexpr double kRounding = 1e-12;  // of sums of 80 numbers, relative

ShipParticulars box(const Vec3& cog = Vec3::Zero()) {
  ShipParticulars ship =
      afloat({{}, wetBox({kLength, kBeam, kDraught, 1.0}, 16, 4, 3), true}, {.cog = cog}).ship;
  ship.drag.crossFlow = kDrag;
  return ship;
}

ShipParticulars frigate() {
  return afloat({{}, wetFrigate(40, 10), true}, {.cog = {0, 0, 1.29}, .level = true}).ship;
}

// ½ρ C_D L T of the box.
const double kBroadside = 0.5 * kSeaWaterDensity * kDrag * kLength * kDraught;

TEST(ResistanceClosedForm, ABoxPushedSidewaysFeelsItsSideAreaAboutItsMiddle) {
  Resistance drag(box(Vec3(3.0, 0.0, 0.5)));
  for (const double v : {-2.0, -0.1, 0.0, 0.7}) {
    const Vec6 load = drag.evaluate(moving(0.0, v, 0.0)).load;
    const double side = -kBroadside * v * std::abs(v);
    EXPECT_NEAR(load[Sway], side, kRounding * kBroadside);
    EXPECT_NEAR(load[Yaw], -3.0 * side, kRounding * kBroadside * kLength);  // 3 m aft of G
    EXPECT_EQ(load[Surge], 0.0);
    EXPECT_TRUE(load.segment<3>(Heave).isZero(0.0));
  }
}

// ∫T x²|x| dx = T L⁴/32.
TEST(ResistanceClosedForm, ASpinningBoxFeelsTheFourthPowerOfItsLength) {
  Resistance drag(box());
  const double moment = 0.5 * kSeaWaterDensity * kDrag * kDraught * std::pow(kLength, 4) / 32.0;
  for (const double r : {-0.3, 0.02}) {
    const Vec6 load = drag.evaluate(moving(0.0, 0.0, r)).load;
    EXPECT_NEAR(load[Yaw], -moment * r * std::abs(r), kRounding * moment);
    EXPECT_NEAR(load[Sway], 0.0, kRounding * moment);
  }
}

// About a point of the side at x₀ = −v/r, |x₀| < L/2: ∫(v + xr)|v + xr| dx is the difference of two
// cubes. The sign changes within a piece of the length: 1/80 of it, squared.
TEST(ResistanceClosedForm, ABoxTurningAboutAPointOfItsSideFeelsADifferenceOfCubes) {
  Resistance drag(box());
  const double r = 0.05, v = 0.033 * kLength * r;
  const double bow = v + 0.5 * kLength * r, stern = v - 0.5 * kLength * r;
  const double cubes = (std::pow(bow, 3) - std::pow(-stern, 3)) / (3.0 * r);
  const double expected = -0.5 * kSeaWaterDensity * kDrag * kDraught * cubes;
  EXPECT_NEAR(drag.evaluate(moving(0.0, v, r)).load[Sway], expected, 1e-3 * std::abs(expected));
}

TEST(ResistanceClosedForm, FrictionIsThatOfItsLine) {
  // Re = 10⁷: 0.075/5². Re = 10⁹: 0.075/7².
  EXPECT_NEAR(Resistance::friction(1e7), 3.0e-3, 1e-15);
  EXPECT_NEAR(Resistance::friction(1e9), 0.075 / 49.0, 1e-15);
  ShipParticulars ship = box();
  ship.drag.formFactor = 0.15;
  const double speed = 1e8 * Resistance::kViscosity / kLength;  // Re = 10⁸: 0.075/6²
  // Bottom, two sides and two ends.
  const double area = kLength * kBeam + 2.0 * (kLength + kBeam) * kDraught;
  const double force = 0.5 * kSeaWaterDensity * area * 1.15 * (0.075 / 36.0) * speed * speed;
  Resistance drag(ship);
  EXPECT_NEAR(drag.evaluate(moving(speed, 0.0, 0.0)).load[Surge], -force, kRounding * force);
  EXPECT_NEAR(drag.evaluate(moving(-speed, 0.0, 0.0)).load[Surge], force, kRounding * force);
}

TEST(Resistance, FrictionGoesToRestSmoothly) {
  const Resistance drag(box());
  EXPECT_EQ(drag.alongHull(0.0), 0.0);
  // Re = 100, where the line of 1957 has its pole, is at 3e-6 m/s.
  double before = 0.0;
  for (double u = 1e-9; u < 30.0; u *= 1.1) {
    const double force = drag.alongHull(u);
    EXPECT_LT(force, before) << u;
    EXPECT_EQ(drag.alongHull(-u), -force);
    EXPECT_LE(-force, 0.5 * kSeaWaterDensity * drag.wettedArea() * 1.2 * 0.0084 * u * u);
    before = force;
  }
}

TEST(ResistanceIdentity, WithoutAMeshItIsThatOfTheBox) {
  ShipParticulars bare;
  bare.volume = 1000.0;
  bare.mass = bare.volume * bare.density;
  bare.cog = Vec3(7.0, 0.0, 1.0);
  const double length = bare.length(), beam = bare.beam(), draught = 1000.0 / (length * beam);
  ShipParticulars meshed = afloat({{}, wetBox({length, beam, draught, 1.0}, 16, 4, 3), true}).ship;
  meshed.mass = bare.mass;
  meshed.gyradii = bare.gyradii;
  Resistance a(bare), b(meshed);
  EXPECT_NEAR(a.lateralArea(), length * draught, kRounding * a.lateralArea());
  const Vec6 one = a.evaluate(moving(3.0, 0.4, 0.01)).load;
  const Vec6 other = b.evaluate(moving(3.0, 0.4, 0.01)).load;
  EXPECT_LT((one - other).norm(), 1e-9 * other.norm());
}

// ∫T dx of a hull whose half breadth is a function of x and z: its port side seen from abeam.
TEST(ResistanceIdentity, LateralAreaIsThatOfTheSideSeenFromAbeam) {
  const ShipParticulars ship = frigate();
  double seen = 0.0;
  for (const Face& face : ship.wetSurface.faces) seen += vectorArea(ship.wetSurface, face).y();
  // The profile between stations is straight, but stations lean with the bow: 80 points.
  EXPECT_NEAR(Resistance(ship).lateralArea(), seen, 2e-3 * seen);
}

TEST(ResistanceIdentity, HalvesAndWholeAreTheSameHull) {
  ShipParticulars half = frigate(), whole = half;
  whole.wetSurface = bothHalves(half.wetSurface);
  whole.symmetric = false;
  Resistance a(half), b(whole);
  EXPECT_NEAR(a.wettedArea(), b.wettedArea(), 1e-9 * a.wettedArea());
  EXPECT_NEAR(a.lateralArea(), b.lateralArea(), 1e-9 * a.lateralArea());
}

// However light the ship and long the tick, energy only goes, and no motion turns round.
TEST(ResistanceIdentity, ATickTakesEnergyWhateverTheMotion) {
  ShipParticulars ship = box(Vec3(4.0, 0.0, 0.0));
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  for (int i = 0; i < 2000; ++i) {
    ship.mass = std::exp(4.0 * any(random));
    Resistance drag(ship);
    const double u = 10.0 * any(random), v = 5.0 * any(random), r = any(random);
    const double step = std::exp(any(random) - 3.0);
    const Vec6 load = drag.evaluate(moving(u, v, r, step)).load;
    EXPECT_LE(load[Surge] * u, 0.0);
    EXPECT_LE(load[Sway] * v + load[Yaw] * r, 0.0);
    const double inertia = ship.massMatrix()(Yaw, Yaw);
    const double after = v + step * load[Sway] / ship.mass, turn = r + step * load[Yaw] / inertia;
    EXPECT_LE(ship.mass * after * after + inertia * turn * turn,
              (1.0 + kRounding) * (ship.mass * v * v + inertia * r * r));
    EXPECT_GE((u + step * load[Surge] / ship.mass) * u, -kRounding * u * u);
  }
}

/// A hull that moves in the plane, the water's share of its mass given: semi-implicit, as Bullet.
struct Plane {
  Resistance drag;
  double massSurge, massSway, inertia;
  double u = 0.0, v = 0.0, r = 0.0;
  void run(double duration, double side = 0.0, double step = 0.02) {
    for (double t = 0.0; t < duration - 0.5 * step; t += step) {
      const Vec6 load = drag.evaluate(moving(u, v, r, step)).load;
      u += step * load[Surge] / massSurge;
      v += step * (load[Sway] + side) / massSway;
      r += step * load[Yaw] / inertia;
    }
  }
};

Plane onWater(const ShipParticulars& ship) {
  const double added = ship.mass, turning = 0.8 * ship.massMatrix()(Yaw, Yaw);
  return {Resistance(ship), 1.05 * ship.mass, ship.mass + added,
          ship.massMatrix()(Yaw, Yaw) + turning};
}

// C_D = 1: 300 kN = ½ρ ∫T dx v² (the turning that an uneven profile adds is held).
TEST(ResistanceClosedForm, APushFromAbeamEndsAtTheCrossFlowBalance) {
  const ShipParticulars ship = frigate();
  Plane hull = onWater(ship);
  hull.inertia = 1e30;
  hull.run(400.0, 3e5);
  double seen = 0.0;
  for (const Face& face : ship.wetSurface.faces) seen += vectorArea(ship.wetSurface, face).y();
  const double balance = std::sqrt(2.0 * 3e5 / (kSeaWaterDensity * seen));
  recordResult("free ship", "frigate pushed abeam by 300 kN: speed [m/s]",
               "sqrt(2F/(rho int T dx)) = " + std::to_string(balance), hull.v, "0.1 %");
  EXPECT_NEAR(hull.v, balance, 1e-3 * balance);
}

// I dr/dt = −k r²: r = r₀/(1 + k r₀ t/I), whatever it began with.
TEST(ResistanceClosedForm, ASpunShipComesToRest) {
  Plane spun = onWater(box());
  const double k = 0.5 * kSeaWaterDensity * kDrag * kDraught * std::pow(kLength, 4) / 32.0;
  spun.r = 0.2;
  spun.run(100.0);
  const double expected = 0.2 / (1.0 + k * 0.2 * 100.0 / spun.inertia);
  EXPECT_NEAR(spun.r, expected, 1e-3 * expected);  // Euler's step: h k r₀/I = 2e-3 at the start

  Plane ship = onWater(frigate());
  ship.r = 10.0 * kPi / 180.0;
  ship.run(500.0);
  recordResult("free ship", "frigate spun at 10 deg/s: after 500 s [deg/s]", "at rest",
               ship.r * 180.0 / kPi, "0.1");
  EXPECT_LT(std::abs(ship.r), 0.1 * kPi / 180.0);
}

TEST(Resistance, AShipUnderWayLosesItsSpeed) {
  Plane ship = onWater(frigate());
  ship.u = 8.0;
  double before = ship.u;
  for (int minute = 0; minute < 60; ++minute) {
    ship.run(60.0);
    EXPECT_LT(ship.u, before);
    EXPECT_GT(ship.u, 0.0);
    before = ship.u;
  }
  EXPECT_LT(ship.u, 1.0);
}

}  // namespace
}  // namespace cutwater::test
