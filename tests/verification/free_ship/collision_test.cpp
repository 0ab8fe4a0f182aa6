#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/Results.h"
#include "tests/verification/free_ship/FreeFrigate.h"

// Two free ships that collide keep their momentum, the water's share counted.
namespace cutwater::test {
namespace {

struct Meeting {
  double heading, off, angle;  // [rad] of the one that runs; [m] off centre; [rad] beyond abeam
  double sideways;             // [m/s] leeway of the one that runs
};

struct Outcome {
  bool touched = false;
  double lost = 0.0;              // of the momentum at first
  double most = 0.0, left = 0.0;  // energy, of that at first
};

// Two ships 80 m apart, the first at 5 m/s.
Outcome collide(const Meeting& meeting) {
  constexpr double kStep = 0.01, kSpeed = 5.0, kApart = 80.0;
  const double c = std::cos(meeting.heading), s = std::sin(meeting.heading);
  ShipSettings settings = freeShip(kSpeed, false);
  settings.start.heading = meeting.heading;
  settings.start.velocity[Sway] = meeting.sideways;
  OneShip run(coarseFrigate(), SeaState({}, kGravity), settings);
  run.bullet.world.getSolverInfo().m_numIterations = 60;
  settings = freeShip(0.0, false);
  settings.start.heading = meeting.heading + 0.5 * kPi + meeting.angle;
  settings.start.x = kApart * c - meeting.off * s;
  settings.start.y = kApart * s + meeting.off * c;
  Ship& other = run.seaway.addShip(coarseFrigate(), settings);
  Vec3 first = Vec3::Zero();
  const double atFirst = steadyEnergy(*coarseFrigate(), steadyWay(kSpeed, meeting.sideways));
  Outcome outcome;
  for (int i = 0; i < 3000; ++i) {
    run.tick(kStep);
    Vec3 momentum = run.ship.momentum().head<3>() + other.momentum().head<3>();
    momentum.z() = 0.0;  // heave has stiffness
    if (i == 0) first = momentum;
    outcome.left = (run.ship.energy() + other.energy()) / atFirst;
    outcome.most = std::max(outcome.most, outcome.left);
    outcome.lost = std::max(outcome.lost, (momentum - first).norm() / first.norm());
    outcome.touched = outcome.touched || other.velocity().head<2>().norm() > 0.01;
  }
  return outcome;
}

// Acceptance 1e-5: the loads are differences of momenta, so that only round-off is left, some 1e-16
// times the ticks and the forces' size. Energy of bodies and A(∞), of what ship and water held at
// first with A(0): never above 1.
TEST(FreeShipCollisionIdentity, MomentumStaysAtAnyHeadingAndEnergyNeverRises) {
  double lost = 0.0, most = 0.0, left = 0.0;
  for (const double heading : {0.0, 0.7, 2.0}) {
    for (const double off : {0.0, 25.0}) {
      for (const double angle : {0.0, 1.2}) {
        for (const double sideways : {0.0, 2.0}) {
          const Outcome outcome = collide({heading, off, angle, sideways});
          EXPECT_TRUE(outcome.touched) << heading << ' ' << off << ' ' << angle << ' ' << sideways;
          EXPECT_LE(outcome.lost, 1e-5) << heading << ' ' << off << ' ' << angle;
          EXPECT_LE(outcome.most, 1.0) << heading << ' ' << off << ' ' << angle << ' ' << sideways;
          lost = std::max(lost, outcome.lost);
          most = std::max(most, outcome.most);
          left = std::max(left, outcome.left);
        }
      }
    }
  }
  recordResult(kTopic, "two free ships collide, any heading: momentum lost, of all", "0", lost,
               "1e-5");
  recordResult(kTopic, "two free ships collide, any heading: most energy, of all", "<= 1", most,
               "1");
  recordResult(kTopic, "two free ships collide, any heading: energy left, of all", "< 1", left,
               "1");
}

}  // namespace
}  // namespace cutwater::test
