#include <gtest/gtest.h>

#include <cmath>

#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/linear/Restoring.h"
#include "hydro/forces/linear/SupplementaryForce.h"
#include "tests/excitation/BoxShip.h"
#include "tests/forces/WaveLoads.h"

namespace cutwater {
namespace {

using test::boxShip, test::kBoxDensity, test::kBoxGravity;

TEST(WaveForceIdentity, AgreesWithTheComplexAmplitudeAnywhereAndAtAnyTime) {
  const Coefficients ship = boxShip();
  const double omega = 1.1, beta = 0.4, course = 0.9, a = 0.7, epsilon = 0.3, x = 30.0, y = -12.0,
               t = 4.4;
  test::WaveLoads loads(ship, SeaState({{omega, a, epsilon, beta}}, kBoxGravity), {course, 0.0});
  TickInput now;
  now.time = t;
  now.meanX = x;
  now.meanY = y;
  const Vec6 load = loads.evaluate(now);
  const double k = omega * omega / kBoxGravity;
  const Complex phasor =
      std::polar(a, omega * t - k * (x * std::cos(beta) - y * std::sin(beta)) + epsilon);
  const CVec6 amplitude = WaveExcitation(ship).at(omega, beta + course).total();
  EXPECT_LT((load - (phasor * amplitude).real()).norm(), 1e-9 * amplitude.norm());
}

TEST(WaveForceIdentity, AWaveFromTheBowIsAHeadSeaWhateverTheCourse) {
  // Course 120° to port; the wave travels against it. In H the ship must see β = 180°.
  const Coefficients ship = boxShip();
  const double course = 2.0 * kPi / 3.0;
  // Direction of travel (cos β, −sin β) = −(cos ψ, sin ψ): β = π − ψ.
  test::WaveLoads loads(ship, SeaState({{1.0, 1.0, 0.0, kPi - course}}, kBoxGravity),
                        {course, 0.0});
  const Vec6 load = loads.evaluate({});
  const CVec6 head = WaveExcitation(ship).at(1.0, kPi).total();
  EXPECT_LT((load - head.real()).norm(), 1e-9 * head.norm());
}

TEST(Restoring, OpposesHeaveByTheWaterplane) {
  const Coefficients ship = boxShip();
  TickInput now;
  now.eta[Heave] = 0.1;
  // Moment about G half a metre forward of the waterplane's centre: C53 = −ρg∫x dA = +ρgA·0.5.
  const Vec6 force = Restoring(ship.ship).evaluate(now).load;
  EXPECT_NEAR(force[Heave], -kBoxDensity * kBoxGravity * 120.0 * 0.1, 1e-6);
  EXPECT_NEAR(force[Pitch], -kBoxDensity * kBoxGravity * 120.0 * 0.5 * 0.1, 1e-6);
}

TEST(SupplementaryForce, QuadraticRollDampingAlwaysTakesEnergy) {
  Supplementary terms;
  terms.rollDampingQuadratic = 3.0;
  terms.damping[Sway] = 2.0;
  terms.stiffness[Yaw] = 5.0;
  TickInput now;
  for (const double rate : {-2.0, 2.0}) {
    now.etaDotNow << 0, 1, 0, rate, 0, 0;
    now.eta[Yaw] = 0.1;
    const Vec6 force = SupplementaryForce(terms).evaluate(now).load;
    EXPECT_DOUBLE_EQ(force[Roll], -3.0 * std::abs(rate) * rate);
    EXPECT_DOUBLE_EQ(force[Sway], -2.0);
    EXPECT_DOUBLE_EQ(force[Yaw], -0.5);
  }
}

}  // namespace
}  // namespace cutwater
