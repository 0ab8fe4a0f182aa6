#include <gtest/gtest.h>

#include <cmath>

#include "hydro/forces/FreeResponse.h"
#include "tests/support/Results.h"
#include "tests/verification/free_ship/FreeFrigate.h"

// What a steady push, a turn and a spin do to a free ship in calm water: the laws of mechanics with
// the water's added mass at rest.
namespace cutwater::test {
namespace {

const SeaState& calm() {
  static const SeaState sea({}, kGravity);
  return sea;
}

btVector3 bullet(const Vec3& v) { return btVector3(v.x(), v.y(), v.z()); }

constexpr double kPush = 1e4, kPushFor = 600.0;  // [N], [s]

// No filter cheats: after ten minutes of 10 kN the ship has F t/(M + A(0)) within 1 %. The water's
// memory reaches its A(0) as the square of the time; after 600 s some 1e-3 is left. Munk's moment
// and the couplings would turn a ship that is pushed sideways: Bullet's angular factor holds its
// heading, which does no work and pushes nowhere.
TEST(FreeShipPushIdentity, ASteadyPushMovesTheShipAndTheWaterAtRest) {
  for (const Mode mode : {Surge, Sway}) {
    OneShip run(coarseFrigate(), calm(), freeShip(0.0, false));
    run.ship.body().setAngularFactor(btVector3(1, 1, 0));
    Vec3 push = Vec3::Zero();
    push[mode] = kPush;
    while (run.time() < kPushFor - 0.5 * kTick) {
      run.ship.body().applyCentralForce(bullet(push));
      run.tick();
    }
    const Mat6 added = coarseFrigate()->freeResponse().addedMassAtRest();
    const double theory = kPush * kPushFor / (coarseFrigate()->ship().mass + added(mode, mode));
    const double ratio = run.ship.velocity()[mode] / theory;
    recordResult(kTopic,
                 std::string("10 kN for 600 s, ") + kModeNames[mode] + ": speed, of F t/(M + A(0))",
                 "1", ratio, "1 +- 0.01");
    EXPECT_NEAR(ratio, 1.0, 0.01) << kModeNames[mode];
  }
}

// Free to turn it has F t as well: all that acts on ship and water. The water's loads are
// differences of momenta: round-off of 3e4 ticks is left.
TEST(FreeShipPushIdentity, AFreePushedShipHasTheWholeMomentum) {
  for (const double degrees : {0.0, 60.0, 90.0}) {
    OneShip run(coarseFrigate(), calm(), freeShip(0.0, false));
    const Vec3 push = kPush * Vec3(std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0.0);
    while (run.time() < kPushFor - 0.5 * kTick) {
      run.ship.body().applyCentralForce(bullet(push));
      run.tick();
    }
    const Vec3 missing = run.ship.momentum().head<3>() - kPushFor * push;
    const double share = missing.head<2>().norm() / (kPush * kPushFor);
    recordResult(kTopic,
                 "10 kN for 600 s at " + std::to_string(int(degrees)) +
                     " deg, free to turn: momentum missed, of F t",
                 "0", share, "1e-9");
    EXPECT_LE(share, 1e-9) << degrees;
  }
}

// KE + PE, with A(∞), and what a moment about the vertical has done.
struct Turned {
  double most = 0.0, mostAtRest = 0.0;  // energy less work, with A(∞) and with A(0), of `unit` [J]
  double work = 0.0;                    // [J]
};

// Work of a tick is moment times the mean of the rates before and after: Bullet's velocity jumps by
// the tick's impulse, whose work is that times the mean.
Turned turnAndLeave(OneShip& run, double moment, double seconds, double until, double unit) {
  Turned turned;
  while (run.time() < until - 0.5 * kTick) {
    const double before = run.ship.body().getAngularVelocity().z();
    const bool acts = run.time() < seconds - 0.5 * kTick;
    if (acts) run.ship.body().applyTorque(btVector3(0, 0, moment));
    run.tick();
    const double rate = 0.5 * (before + run.ship.body().getAngularVelocity().z());
    if (acts) turned.work += moment * rate * kTick;
    const Vec6 velocity = run.ship.velocity();
    const double slow = steadyEnergy(run.ship.hydrodynamics(), velocity);
    turned.most = std::max(turned.most, (run.ship.energy() - turned.work) / unit);
    turned.mostAtRest = std::max(turned.mostAtRest, (slow - turned.work) / unit);
  }
  return turned;
}

// Acceptance: 4 m/s, turned by 2 MN m for 20 s, left for 400 s; ahead and astern. Energy with A(∞)
// stays below what there was at first and the work. With A(0) in the place of the memory it is what
// a slow motion has, to ω²L/g: 1 % at the 0.03 rad/s with which the ship turns. Wrong ways give
// four times.
TEST(FreeShipEnergyIdentity, ACoastingShipThatIsTurnedGainsNothing) {
  for (const bool lift : {false, true}) {
    for (const double speed : {4.0, -4.0}) {
      OneShip run(coarseFrigate(), calm(), freeShip(speed, lift));
      const double atFirst = steadyEnergy(*coarseFrigate(), steadyWay(speed));
      const Turned turned = turnAndLeave(run, 2e6, 20.0, 420.0, atFirst);
      const std::string what = std::string("frigate at ") + (speed > 0.0 ? "4" : "-4") +
                               " m/s, turned, lift " + (lift ? "on" : "off") +
                               ": most energy less work, of that at first, ";
      recordResult(kTopic, what + "with A(inf)", "<= 1", turned.most, "1");
      recordResult(kTopic, what + "with A(0)", "<= 1", turned.mostAtRest, "1.01");
      EXPECT_LE(turned.most, 1.0) << what;
      EXPECT_LE(turned.mostAtRest, 1.01) << what;
    }
  }
}

// Acceptance: from rest KE + PE never exceed the work. What ticks of h leave is of the order h²:
// 2e-7 at 0.02 s, 7e-6 at 0.1 s.
TEST(FreeShipEnergyIdentity, ASpunShipHasNoMoreThanTheWork) {
  OneShip run(coarseFrigate(), calm(), freeShip(0.0, false));
  double most = 0.0, work = 0.0;
  while (run.time() < 500.0) {
    const double before = run.ship.body().getAngularVelocity().z();
    const double moment = run.time() < 60.0 - 0.5 * kTick ? 5e6 : 0.0;
    run.ship.body().applyTorque(btVector3(0, 0, moment));
    run.tick();
    work += moment * 0.5 * (before + run.ship.body().getAngularVelocity().z()) * kTick;
    most = std::max(most, run.ship.energy() / work);
  }
  recordResult(kTopic, "frigate spun by 5 MN m for 60 s: most energy, of the work", "<= 1", most,
               "1 + 1e-6");
  EXPECT_LE(most, 1.0 + 1e-6);
}

// A buoy of radius 5 m that makes 0.5 m/s at any angle to its heading.
struct Drifted {
  double aside = 0.0, shortBy = 0.0;  // [m] of 200
  double yaw = 0.0;                   // [rad]
  double most = 0.0;                  // energy of that at first
};

Drifted driftABuoy(const std::shared_ptr<const Hydrodynamics>& buoy, double angle, double spin,
                   bool lift) {
  constexpr double kSpeed = 0.5, kFor = 400.0;  // [m/s], [s]
  ShipSettings settings = freeShip(kSpeed * std::cos(angle), lift);
  settings.start.velocity[Sway] = kSpeed * std::sin(angle);
  settings.start.velocity[Yaw] = spin;
  const double gravity = buoy->ship().gravity;
  OneShip run(buoy, SeaState({}, gravity), settings, gravity);
  const double atFirst =
      steadyEnergy(*buoy, steadyWay(kSpeed * std::cos(angle), kSpeed * std::sin(angle), spin));
  Drifted drifted;
  while (run.time() < kFor - 0.5 * kTick) {
    run.tick();
    drifted.most = std::max(drifted.most, run.ship.energy() / atFirst);
  }
  const Vec3 at = run.ship.position();
  drifted.aside = std::abs(at.y() * std::cos(angle) - at.x() * std::sin(angle));
  drifted.shortBy = kSpeed * kFor - at.y() * std::sin(angle) - at.x() * std::cos(angle);
  drifted.yaw = run.ship.attitude().z();
  return drifted;
}

// Acceptance: a round buoy goes straight on, spun or not, wherever its bow points. Its panels are
// round to 1e-4: A11 and A22 differ by that, and Munk's moment of the difference turns it in 400 s
// by the angle that is compared, of the steady moment. Spun, it has waves of the rate of spin in
// its own axes, which in truth stand still; 1e-3 of its way is what they may cost.
TEST(FreeShipEnergyIdentity, ARoundBuoyStaysStraight) {
  const auto buoy = readHydrodynamics(CUTWATER_SOLVED "/sphere.h5");
  const Mat6 added = buoy->freeResponse().addedMassAtRest();
  const double inertia = buoy->ship().massMatrix()(Yaw, Yaw) + added(Yaw, Yaw);
  double aside = 0.0, shortBy = 0.0, most = 0.0;
  for (const double angle : {0.0, 0.6, 0.5 * kPi}) {
    for (const double spin : {0.0, 0.05}) {
      const Drifted drifted = driftABuoy(buoy, angle, spin, false);
      aside = std::max(aside, drifted.aside);
      shortBy = std::max(shortBy, std::abs(drifted.shortBy));
      most = std::max(most, drifted.most);
      if (spin > 0.0) continue;
      const double munk =
          -(added(Sway, Sway) - added(Surge, Surge)) * 0.25 * std::cos(angle) * std::sin(angle);
      const double turned = 0.5 * munk / inertia * 400.0 * 400.0;
      EXPECT_NEAR(drifted.yaw, turned, 0.1 * std::abs(turned) + 1e-3) << angle;
    }
  }
  // With the lift of a hull it holds its bow ahead, and nothing is gained.
  for (const double spin : {0.0, 0.05}) {
    const Drifted drifted = driftABuoy(buoy, 0.0, spin, true);
    if (spin == 0.0) aside = std::max(aside, drifted.aside);
    most = std::max(most, drifted.most);
  }
  recordResult(kTopic, "round buoy, 0.5 m/s for 400 s: aside of its way [m]", "0", aside, "0.2");
  recordResult(kTopic, "round buoy, 0.5 m/s for 400 s: short of its way [m]", "0", shortBy, "0.2");
  recordResult(kTopic, "round buoy: most energy, of that at first", "<= 1", most, "1");
  EXPECT_LE(aside, 0.2);
  EXPECT_LE(shortBy, 0.2);
  EXPECT_LE(most, 1.0);
}

}  // namespace
}  // namespace cutwater::test
