#include "plugin/Ship.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "hydro/response/FrequencyResponse.h"
#include "tests/plugin/TestScene.h"
#include "tests/support/Results.h"

namespace cutwater::test {
namespace {

TEST(ShipIdentity, AtRestInCalmWaterNothingMoves) {
  Scene scene({.start = {.x = 30, .y = -12, .heading = 0.7}});
  const btTransform start = scene.sphere->body().getWorldTransform();
  scene.run(640);
  EXPECT_EQ(scene.sphere->body().getWorldTransform().getOrigin(), start.getOrigin());
  EXPECT_EQ(scene.sphere->body().getLinearVelocity(), btVector3(0, 0, 0));
  // A heading of 0.7 rad is not exact: the attitude about the mean course is of one rounding.
  EXPECT_LT(velocityOf(scene.sphere->body()).norm(), 10 * kEpsilon);
}

TEST(ShipClosedForm, AUsersForceMovesMassPlusAddedMass) {
  Scene scene;
  scene.sphere->body().applyCentralForce(btVector3(3e5, 0, 2e5));
  scene.run(1);
  const double m = 261800.0, displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const Vec6 v = velocityOf(scene.sphere->body());
  // Heave also carries Bullet's gravity and what cancels it, 0.15 m/s each way.
  EXPECT_NEAR(v[Surge], 3e5 / 64 / (m + 0.2732 * displaced), 2 * kEpsilon);
  EXPECT_NEAR(v[Heave], 2e5 / 64 / (m + 0.5 * displaced), 2 * kEpsilon);
}

TEST(ShipClosedForm, ABlowBetweenTicksMovesMassPlusAddedMass) {
  Scene scene;
  scene.run(3);
  scene.sphere->body().applyCentralImpulse(btVector3(2e5, 0, 0));
  scene.run(1);
  const double expected = 2e5 / (261800.0 + 0.2732 * 1000.0 * 2.0 / 3.0 * kPi * 125.0);
  EXPECT_NEAR(velocityOf(scene.sphere->body())[Surge], expected, 4 * kEpsilon);
  Scene set;
  set.run(3);
  set.sphere->resetVelocity(Vec3(0.5, 0, 0), Vec3::Zero());
  set.run(1);
  // Set, not struck: the one tick's radiation force, K(0) h v, is all that slows it.
  EXPECT_NEAR(velocityOf(set.sphere->body())[Surge], 0.5, 2e-4);
}

// M dv/dt is the sum of the parts, added mass among them, and nothing else.
TEST(ShipIdentity, PartsOfTheLoadAddUpToNewtonsLaw) {
  // On a fixed course: the axes of the parts are known to the last bit.
  Scene scene(
      {.start = {.heading = 0.4, .offset = one(Heave, 0.5)}, .model = {.mean = Mean::Fixed}},
      waves());
  scene.run(200);
  const Vec6 before = velocityOf(scene.sphere->body());
  scene.run(1);
  const Ship& sphere = *scene.sphere;
  Vec6 sum = Vec6::Zero();
  for (const Vec6& load : sphere.lastTick().loads) sum += load;
  const Vec3 change = (velocityOf(scene.sphere->body()) - before).head<3>();
  const Mat3 toCourse = Eigen::AngleAxisd(-0.4, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 inertial = toCourse * (261800.0 * 64.0 * change);
  // Velocities of 1 m/s are stored to ε; through m/h that is the resolution of this sum.
  EXPECT_LT((inertial - sum.head<3>()).norm(), 4 * kEpsilon * 261800.0 * 64.0);
  EXPECT_GT(sphere.load("added_mass").head<3>().norm(), 1e3);
  EXPECT_GT(sphere.load("radiation").norm(), 1e2);
  EXPECT_GT(sphere.load("diffraction").norm(), 1e2);
}

TEST(ShipIdentity, TicksPerStepSimulationDoNotMatterToTheLastBit) {
  const ShipSettings start{.start = {.heading = 0.4, .offset = one(Heave, 0.5)}};
  Scene single(start, waves());
  single.run(256, kTick, 1);
  int different = 0;
  for (const int perCall : {2, 4}) {
    Scene many(start, waves());
    many.run(256, kTick, perCall);
    if (!sameBits(single.sphere->body(), many.sphere->body())) ++different;
    EXPECT_EQ(single.seaway.time(), many.seaway.time());
  }
  EXPECT_EQ(different, 0);
  recordResult("Plugin", withPrecision("2 and 4 ticks per stepSimulation: runs that differ from 1"),
               "0", different, "0");
}

// Height after 8 s of a sphere let go from 1 m, `start` its velocity.
double heightAfterEightSeconds(int ticksPerSecond, double start) {
  Scene scene({.start = {.offset = one(Heave, 1.0)}});
  scene.sphere->resetVelocity(Vec3(0, 0, start), Vec3::Zero());
  scene.run(8 * ticksPerSecond, btScalar(1) / static_cast<btScalar>(ticksPerSecond));
  return scene.sphere->motion()[Heave];
}

// x_{n+1} = x_n + h v_{n+1} takes the velocity given at the start for that of half a tick before
// it. Where that is what it is, v(−h/2) = v(0) − a(0) h/2, the scheme is a leapfrog: second order.
// Given v(0) instead it is first order, by a shift in time of h/2, which is the engine's and
// constant.
TEST(ShipConvergence, SecondOrderInTheTickWithAConsistentStartFirstFromRest) {
  const double displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const double fall = -7.695e5 / (261800.0 + 0.5 * displaced);  // a(0)
  const auto order = [&](bool consistent) {
    double z[3];
    for (int i = 0; i < 3; ++i) {
      const int rate = (consistent ? 16 : 64) << i;
      z[i] = heightAfterEightSeconds(rate, consistent ? -0.5 * fall / rate : 0.0);
    }
    return std::log2((z[0] - z[1]) / (z[1] - z[2]));
  };
  const double second = order(true), first = order(false);
  // The next term of the error is smaller by h over the time scale of the motion, 0.35 s = 1/ω: 0.2
  // of the second-order one's square at 1/16 s, 0.05 of the first-order one at 1/64 s.
  EXPECT_NEAR(second, 2.0, 0.1);
  EXPECT_NEAR(first, 1.0, 0.1);
  recordResult("Plugin", withPrecision("order of convergence in the tick, consistent start"), "2",
               second, "1.9..2.1");
  recordResult("Plugin", withPrecision("order of convergence in the tick, start from rest"), "1",
               first, "0.9..1.1");
}

// An impulse first meets A(∞), then, its waves gone, A(0): Ogilvie's A(0) = A(∞) − ∫τK dτ as
// momentum. After that nothing slows it: ∫K dτ = 0 must hold in the sum of ticks, too.
TEST(ShipIdentity, PushedOffItSettlesAtTheSpeedOfZeroFrequencyAddedMassAndKeepsIt) {
  Scene scene({.model = {.mean = Mean::Fixed}});
  scene.sphere->resetVelocity(Vec3(10, 0, 0), Vec3::Zero());
  scene.run(2000 * 64);  // the slowest of the poles of the memory dies as e^{−t/30 s}
  const double settled = scene.sphere->velocity()[0];
  const double expected = 10.0 * (1.0 + 0.2732) / (1.0 + 0.5);
  // 0.5 %: the table's grid in ω, first point Ka = 0.02.
  EXPECT_NEAR(settled, expected, 0.005 * expected);
  scene.run(600 * 64);
  const double drift = std::abs(scene.sphere->velocity()[0] - settled);
  EXPECT_LT(drift, 20 * kEpsilon);
  recordResult("Plugin", withPrecision("coasting 600 s with radiation memory, change [m/s]"), "0",
               drift, kDouble ? "4.4e-15" : "2.4e-6");
  recordResult("Plugin", withPrecision("pushed off at 10 m/s, speed kept [m/s]"),
               "8.488 = 10 (m + A(inf))/(m + A(0))", settled, "0.5 %");
}

// A free ship has always had the way that it is given: at once the water of A(0) moves with it. A
// blow is met by A(∞) and ends at P/(M + A(0)).
TEST(ShipIdentity, AFreeShipKeepsTheWayItIsGivenAndABlowMovesZeroFrequencyAddedMass) {
  const ShipModel noDrag{.resistance = false};
  Scene given({.model = noDrag}), struck({.model = noDrag});
  given.sphere->resetVelocity(Vec3(10, 0, 0), Vec3::Zero());
  given.run(600 * 64);
  EXPECT_NEAR(given.sphere->velocity()[0], 10.0, 40 * kEpsilon);
  const double displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  const double blow = 10.0 * (261800.0 + 0.2732 * displaced);
  struck.run(1);
  struck.sphere->body().applyCentralImpulse(btVector3(static_cast<btScalar>(blow), 0, 0));
  struck.run(1);
  EXPECT_NEAR(struck.sphere->velocity()[0], 10.0, 0.05);  // a tick's radiation
  struck.run(2000 * 64);  // the slowest of the poles of the memory dies as e^{−t/30 s}
  // 0.5 %: the table's grid in ω, first point Ka = 0.02.
  const double expected = blow / (261800.0 + 0.5 * displaced);
  EXPECT_NEAR(struck.sphere->velocity()[0], expected, 0.005 * expected);
  EXPECT_NEAR(struck.sphere->momentum()[0], blow, 1e4 * kEpsilon * blow);  // 10⁵ ticks of rounding
}

TEST(ShipVerification, HeaveInARegularWaveIsThatOfTheFrequencyDomain) {
  const double omega = 1.2, amplitude = 0.5;
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    Scene scene(
        {.start = {.x = 7.0, .y = -3.0}, .model = {.mean = mean}},
        SeaState({{.omega = omega, .amplitude = amplitude, .heading = kPi}}, kSphereGravity, 10.0));
    const double periods = 4.0 * 2.0 * kPi / omega, k = omega * omega / kSphereGravity;
    scene.run(150 * 64);
    Complex sum = 0.0;
    const int samples = static_cast<int>(std::lround(periods * 64));
    for (int i = 0; i < samples; ++i) {
      // The crest is over G's mean place, x = 7, later than over the origin of E: e^{+ikx} at
      // β = π. A free ship's is where its slow motion has taken it since the waves grew.
      const double phase = omega * scene.seaway.time() + k * scene.sphere->course().x();
      sum += scene.sphere->motion()[Heave] * std::polar(1.0, -phase);
      scene.run(1);
    }
    const Complex found = 2.0 / samples * sum / amplitude;
    const FrequencyResponse fixed(scene.coefficients),
        free(scene.coefficients, FrequencyResponse::Free{});
    const Complex expected = (mean == Mean::Fixed ? fixed : free).at(omega, kPi)[Heave];
    // The acceptance of the whole chain, 1 % and 3°; here well inside it: the window is not quite
    // four periods (0.2 %), the tick is 1/340 of one.
    EXPECT_NEAR(std::abs(found) / std::abs(expected), 1.0, 5e-3);
    EXPECT_NEAR(std::arg(found / expected), 0.0, 5e-3);
  }
}

// The physics does not know where E's axes point.
TEST(ShipIdentity, TurnedSceneGivesTurnedMotion) {
  const double turn = 1.1;
  SeaState straight({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}}, kSphereGravity);
  SeaState turned({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0 - turn}}, kSphereGravity);
  Scene a({.start = {.offset = one(Heave, 0.5)}}, straight);
  Scene b({.start = {.heading = turn, .offset = one(Heave, 0.5)}}, turned);
  a.run(320);
  b.run(320);
  // Rounding of 320 ticks of positions and velocities of order one.
  EXPECT_LT((a.sphere->motion() - b.sphere->motion()).norm(), 320 * 4 * kEpsilon);
  EXPECT_GT(std::abs(a.sphere->motion()[Sway]), 1e-2);
}

}  // namespace
}  // namespace cutwater::test
