#include "hydro/forces/appendages/Engine.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hydro/forces/manoeuvring/Resistance.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

constexpr double kRounding = 1e-12;

ShipParticulars frigate() {
  return afloat({{}, wetFrigate(40, 10), true}, {.cog = {0, 0, 1.29}, .level = true}).ship;
}

TickInput at(double speed, double step = 0.02) {
  TickInput now;
  now.step = now.lastStep = step;
  now.speed = speed;
  return now;
}

struct Driven {
  explicit Driven(const EngineParticulars& engine = {.maxThrust = 4e5,
                                                     .astern = 0.6,
                                                     .noThrustSpeed = 20.0,
                                                     .timeConstant = 5.0,
                                                     .diameter = 3.0})
      : engine(ship, engine, -Resistance(ship).alongHull(Engine::hullSpeed(ship)), helm) {}
  ShipParticulars ship = frigate();
  std::shared_ptr<Helm> helm = std::make_shared<Helm>();
  Engine engine;
};

TEST(EngineClosedForm, ThrustFallsLinearlyWithTheSpeedThatItMakes) {
  const Driven d;
  EXPECT_EQ(d.engine.thrust(1.0, 0.0), 4e5);
  EXPECT_NEAR(d.engine.thrust(1.0, 5.0), 3e5, kRounding * 4e5);
  EXPECT_NEAR(d.engine.thrust(0.5, 10.0), 1e5, kRounding * 4e5);
  EXPECT_EQ(d.engine.thrust(1.0, 20.0), 0.0);
  EXPECT_EQ(d.engine.thrust(1.0, 25.0), 0.0);
  EXPECT_EQ(d.engine.thrust(-1.0, 0.0), -0.6 * 4e5);
  EXPECT_NEAR(d.engine.thrust(-1.0, -5.0), -0.6 * 3e5, kRounding * 4e5);
  // Against the motion, as in a crash stop, it is that at rest.
  EXPECT_EQ(d.engine.thrust(-1.0, 8.0), -0.6 * 4e5);
  EXPECT_EQ(d.engine.thrust(1.0, -8.0), 4e5);
  EXPECT_EQ(d.engine.thrust(0.0, 3.0), 0.0);
}

// x = 1 − e^{−t/τ}, to the last digits: the lag is solved, not stepped. In ticks of any length.
TEST(EngineClosedForm, ItFollowsItsOrderWithItsTimeConstant) {
  Driven d;
  d.helm->throttle = 1.0;
  d.engine.evaluate(at(0.0));  // at t = 0 nothing has passed
  EXPECT_EQ(d.engine.share(), 0.0);
  double t = 0.0;
  for (const double step : {0.02, 0.5, 0.013, 3.0, 0.2}) {
    t += step;
    const double push = d.engine.evaluate(at(0.0, step)).load[Surge];
    EXPECT_NEAR(push, 4e5 * (1.0 - std::exp(-t / 5.0)), kRounding * 4e5);
  }
}

TEST(Engine, AnOrderBeyondFullIsFull) {
  Driven d;
  d.helm->throttle = -7.0;
  d.engine.evaluate(at(0.0));
  d.engine.evaluate(at(0.0, 1e4));
  EXPECT_NEAR(d.engine.share(), -1.0, kRounding);
}

TEST(EngineClosedForm, ThrustActsAtItsPlace) {
  const ShipParticulars ship = frigate();
  const auto helm = std::make_shared<Helm>();
  Engine engine(ship,
                {.maxThrust = 2e5, .timeConstant = 0.0, .place = ship.cog + Vec3(-50.0, 3.0, -4.0)},
                0.0, helm);
  helm->throttle = 1.0;
  engine.evaluate(at(0.0));
  Vec6 expected;  // r × (T, 0, 0) = (0, zT, −yT)
  expected << 2e5, 0.0, 0.0, 0.0, -4.0 * 2e5, -3.0 * 2e5;
  EXPECT_LT((engine.evaluate(at(0.0)).load - expected).norm(), kRounding * 1e6);
}

// Momentum theory at rest: T = ½ρA_p w² for a jet of speed w; astern none meets the rudder.
TEST(EngineClosedForm, TheJetIsThatOfMomentumTheory) {
  Driven d;
  d.helm->throttle = 1.0;
  d.engine.evaluate(at(0.0));
  const double push = d.engine.evaluate(at(0.0, 100.0)).load[Surge];
  EXPECT_NEAR(d.helm->jet, 2.0 * push / (kSeaWaterDensity * kPi * 9.0 / 4.0), kRounding * 1e3);
  d.helm->throttle = -1.0;
  d.engine.evaluate(at(0.0, 100.0));
  EXPECT_EQ(d.helm->jet, 0.0);
}

// m du/dt = T(u) − R(u): both are R(u_h) at hull speed.
TEST(EngineIdentity, WithoutANumberItReachesHullSpeed) {
  Driven d{EngineParticulars{}};
  Resistance drag(d.ship);
  const double hullSpeed = 0.4 * std::sqrt(d.ship.gravity * d.ship.length());
  EXPECT_NEAR(Engine::hullSpeed(d.ship), hullSpeed, kRounding * hullSpeed);
  EXPECT_EQ(d.helm->thrustAhead, -2.0 * drag.alongHull(hullSpeed));
  EXPECT_EQ(d.helm->thrustAstern, 0.5 * d.helm->thrustAhead);
  d.helm->throttle = 1.0;
  double u = 0.0;
  for (double t = 0.0; t < 3600.0; t += 0.1) {
    const TickInput now = at(u, 0.1);
    u += 0.1 * (d.engine.evaluate(now).load[Surge] + drag.evaluate(now).load[Surge]) / d.ship.mass;
  }
  EXPECT_NEAR(u, hullSpeed, 1e-3 * hullSpeed);  // an hour is ten times the last approach's own time
}

TEST(Engine, ItsStateIsItsFuture) {
  Driven a, b;
  a.helm->throttle = 0.7;
  for (int i = 0; i < 50; ++i) a.engine.evaluate(at(2.0));
  std::array<double, 3> state{};
  ASSERT_EQ(a.engine.stateSize(), state.size());
  a.engine.save(state);
  b.engine.restore(state);
  EXPECT_EQ(b.helm->throttle, 0.7);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(a.engine.evaluate(at(2.0)).load, b.engine.evaluate(at(2.0)).load);
  a.engine.reset();
  EXPECT_EQ(a.engine.share(), 0.0);
  EXPECT_EQ(a.helm->throttle, 0.7);
}

TEST(Engine, RefusesWhatNoShipHas) {
  expectRefusal(Fault::ValueOutOfRange, {"Engine: [engine] astern = 2: must be in 0..1"},
                [] { Driven d{{.astern = 2.0}}; });
}

}  // namespace
}  // namespace cutwater::test
