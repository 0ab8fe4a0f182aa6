#include "hydro/forces/appendages/Rudder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "hydro/geometry/shapes/Shapes.h"
#include "hydro/ship/Afloat.h"
#include "tests/forces/SlowMotion.h"
#include "tests/support/Refusal.h"

namespace cutwater::test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kDegree = kPi / 180.0;
constexpr double kArea = 10.0, kAspect = 2.0, kArm = -48.0;
constexpr double kSlope = 6.13 * kAspect / (kAspect + 2.25);  // [Fujii & Tsuda 1961]
constexpr double kDrag = 0.0065, kPlate = 1.17;
constexpr double kPressure = 0.5 * kSeaWaterDensity * kArea;

ShipParticulars box() {
  return afloat({{}, wetBox({100.0, 14.0, 4.0, 1.0}, 16, 4, 3), true}, {.cog = {2, 0, 1}}).ship;
}

RudderParticulars blade() {
  const Vec3 place(kArm + 2.0, 0.0, 1.0);  // at G's height
  return {.area = kArea,
          .place = place,
          .aspectRatio = kAspect,
          .slipstream = 0.5,
          .flowStraightening = 0.6};
}

struct Steered {
  explicit Steered(const RudderParticulars& particulars = blade())
      : rudder(ship, particulars, helm) {}
  /// Its load with the blade turned to an angle within its limit.
  Vec6 at(double angle, const TickInput& now) {
    rudder.restore(std::array<double, 4>{angle, angle, 0.0, 0.0});
    return rudder.evaluate(now).load;
  }
  ShipParticulars ship = box();
  std::shared_ptr<Helm> helm = std::make_shared<Helm>();
  Rudder rudder;
};

// C_L = C_Lα sin α cos α, C_D = C_D0 + C_L²/(πΛ).
TEST(RudderClosedForm, BelowTheStallItLiftsByItsAspectRatio) {
  Steered s;
  const double u = 7.0, size = kPressure * u * u;
  for (const double delta : {-0.5, -0.02, 0.0, 0.1, 0.3}) {
    const double lift = kSlope * std::sin(delta) * std::cos(delta);
    const Vec6 load = s.at(delta, moving(u, 0.0, 0.0));
    EXPECT_NEAR(load[Sway], -size * lift, kRounding * size);
    EXPECT_NEAR(load[Surge], -size * (kDrag + lift * lift / (kPi * kAspect)), kRounding * size);
    EXPECT_NEAR(load[Yaw], kArm * load[Sway], kRounding * size * 100.0);
    EXPECT_EQ(load[Heave], 0.0);
    EXPECT_NEAR(load[Roll], 0.0, kRounding * size);
  }
  EXPECT_GT(s.at(0.1, moving(u, 0.0, 0.0))[Yaw], 0.0);  // positive: bow to port
}

// Behind the hull a turning stern meets γ of its own incidence.
TEST(RudderClosedForm, AmidshipsItResistsTheTurn) {
  Steered s;
  const double u = 7.0, r = 0.01, v = kArm * r;
  const double alpha = std::atan2(0.6 * v, u), lift = kSlope * std::sin(alpha) * std::cos(alpha);
  const double drag = kDrag + lift * lift / (kPi * kAspect);
  const double side = -kPressure * std::hypot(u, v) * (lift * u + drag * v);
  const Vec6 load = s.at(0.0, moving(u, 0.0, r));
  EXPECT_NEAR(load[Sway], side, 1e-9 * std::abs(side));
  EXPECT_LT(load[Yaw], 0.0);
}

TEST(RudderClosedForm, AcrossTheFlowItIsAPlate) {
  Steered s;
  const double v = -1.5;
  const Vec6 load = s.at(0.0, moving(0.0, v, 0.0));
  EXPECT_NEAR(load[Sway], kPressure * (kDrag + kPlate) * v * v, kRounding * kPressure);
  EXPECT_NEAR(load[Surge], 0.0, kRounding * kPressure);
}

// The water comes from the other side: the same lift, the other way round.
TEST(RudderIdentity, AsternItTurnsTheOtherWay) {
  Steered s;
  const Vec6 ahead = s.at(0.2, moving(4.0, 0.0, 0.0)), astern = s.at(0.2, moving(-4.0, 0.0, 0.0));
  EXPECT_NEAR(astern[Sway], -ahead[Sway], kRounding * std::abs(ahead[Sway]));
  EXPECT_NEAR(astern[Surge], -ahead[Surge], kRounding * std::abs(ahead[Sway]));
  EXPECT_LT(astern[Yaw], 0.0);
}

TEST(RudderClosedForm, TheJetGivesItBiteAtRest) {
  Steered s;
  const double jet = 60.0, delta = 0.3, square = 0.5 * jet;
  s.helm->jet = jet;
  const double lift = kSlope * std::sin(delta) * std::cos(delta);
  EXPECT_NEAR(s.at(delta, moving(0.0, 0.0, 0.0))[Sway], -kPressure * square * lift,
              kRounding * kPressure * square);
  // It was taken: an engine that is switched off leaves none behind.
  EXPECT_EQ(s.at(delta, moving(0.0, 0.0, 0.0)).norm(), 0.0);
}

// Without thrust: F·v of the blade is −½ρA C_D |v|³, at any angle, in any motion.
TEST(RudderIdentity, WithoutThrustItTakesEnergy) {
  RudderParticulars off = blade();
  off.place = Vec3(kArm + 2.0, 3.0, 1.0);
  Steered s(off);
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  for (int i = 0; i < 5000; ++i) {
    const double u = 5.0 * any(random), v = 2.0 * any(random), r = 0.05 * any(random);
    const double angle = 0.6 * std::tanh(any(random));
    const Vec6 load = s.at(angle, moving(u, v, r));
    const double power = load[Surge] * u + load[Sway] * v + load[Yaw] * r;
    const double speed = std::hypot(u - 3.0 * r, v + kArm * r);
    EXPECT_LE(power, -0.999 * kPressure * kDrag * std::pow(speed, 3));
  }
}

// Half the step, half the largest difference: no jump at rest, abeam, at the stall.
TEST(RudderConvergence, LoadsGoSmoothlyThroughRestAndAnyFlow) {
  Steered s;
  const auto largest = [&](int count) {
    double jump = 0.0;
    for (const double jet : {0.0, 30.0}) {
      for (const double v : {0.0, 0.4}) {
        Vec6 before = Vec6::Zero();
        for (int i = 0; i <= count; ++i) {
          s.helm->jet = jet;
          const Vec6 load = s.at(0.4, moving(-8.0 + 16.0 * i / count, v, 0.0));
          if (i > 0) jump = std::max(jump, (load - before).norm());
          before = load;
        }
      }
    }
    return jump;
  };
  EXPECT_NEAR(largest(8000) / largest(4000), 0.5, 0.05);
}

TEST(Rudder, TurnsAtItsRateToItsLimit) {
  RudderParticulars slow = blade();
  slow.rate = 2.0 * kDegree;
  Steered s(slow);
  s.helm->angle = 1.5;
  s.rudder.evaluate(moving(5.0, 0.0, 0.0, 0.5));
  EXPECT_EQ(s.rudder.angle(), 0.0);
  for (int i = 0; i < 10; ++i) s.rudder.evaluate(moving(5.0, 0.0, 0.0, 0.5));
  EXPECT_NEAR(s.rudder.angle(), 10.0 * kDegree, kRounding);
  for (int i = 0; i < 40; ++i) s.rudder.evaluate(moving(5.0, 0.0, 0.0, 0.5));
  EXPECT_EQ(s.rudder.angle(), 35.0 * kDegree);
  s.helm->angle = 34.9 * kDegree;
  s.rudder.evaluate(moving(5.0, 0.0, 0.0, 0.5));
  EXPECT_EQ(s.rudder.angle(), 34.9 * kDegree);
}

TEST(RudderIdentity, SaysHowMuchItTurns) {
  Steered s;
  for (const double u : {6.0, -3.0}) {
    s.helm->jet = 20.0;
    const double more = s.at(1e-4, moving(u, 0.0, 0.0))[Yaw];
    s.helm->jet = 20.0;
    const double less = s.at(-1e-4, moving(u, 0.0, 0.0))[Yaw];
    EXPECT_NEAR(s.helm->momentPerAngle, (more - less) / 2e-4,
                1e-6 * std::abs(s.helm->momentPerAngle));
  }
}

// A tick stops the blade at most, however light the ship.
TEST(RudderIdentity, NoTickTurnsTheBladesMotionRound) {
  ShipParticulars light = box();
  light.mass = 1.0;
  const auto helm = std::make_shared<Helm>();
  Rudder rudder(light, blade(), helm);
  const double v = 3.0, step = 0.1;
  const Vec6 load = rudder.evaluate(moving(0.0, v, 0.0, step)).load;
  const double inertia = light.massMatrix()(Yaw, Yaw);
  EXPECT_GE(v + step * (load[Sway] / light.mass + kArm * load[Yaw] / inertia), -kRounding);
}

TEST(RudderClosedForm, WithoutANumberItIsTwoAndAHalfPercentOfTheSide) {
  const Steered s{RudderParticulars{}};
  EXPECT_NEAR(s.rudder.area(), 0.025 * 100.0 * 4.0, kRounding * 10.0);
  EXPECT_NEAR(s.rudder.rate(), 65.0 / 28.0 * kDegree, kRounding);
  ShipParticulars boat =
      afloat({{}, wetBox({25.0, 6.0, 1.0, 1.0}, 16, 4, 3), true}, {.cog = {0, 0, 1}}).ship;
  const Rudder small(boat, {}, std::make_shared<Helm>());
  EXPECT_NEAR(small.rate(), 2.0 * s.rudder.rate(), kRounding);  // √(100/25)
}

TEST(Rudder, ItsStateIsItsFuture) {
  Steered a, b;
  a.helm->angle = 0.5;
  for (int i = 0; i < 50; ++i) a.rudder.evaluate(moving(6.0, 0.1, 0.01));
  std::array<double, 4> state{};
  ASSERT_EQ(a.rudder.stateSize(), state.size());
  a.rudder.save(state);
  b.rudder.restore(state);
  EXPECT_EQ(a.helm->momentPerAngle, b.helm->momentPerAngle);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(a.rudder.evaluate(moving(6.0, 0.1, 0.01)).load,
              b.rudder.evaluate(moving(6.0, 0.1, 0.01)).load);
  }
  a.rudder.reset();
  EXPECT_EQ(a.rudder.angle(), 0.0);
  EXPECT_EQ(a.helm->angle, 0.5);
}

TEST(Rudder, RefusesWhatNoShipHas) {
  expectRefusal(Fault::ValueOutOfRange, {"Rudder: [rudder] limit_deg = 120: must be in"},
                [] { Steered s{{.limit = 120.0 * kDegree}}; });
}

}  // namespace
}  // namespace cutwater::test
