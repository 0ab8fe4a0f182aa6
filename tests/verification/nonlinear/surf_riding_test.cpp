#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/appendages/Engine.h"
#include "hydro/forces/manoeuvring/Resistance.h"
#include "tests/support/Results.h"
#include "tests/verification/nonlinear/NonlinearShip.h"

// Surf-riding in following seas: a wave that pushes more than the ship lacks of thrust at the
// wave's speed carries it along; a lower one goes by.
namespace cutwater::test {
namespace {

constexpr double kGravity = 9.80665;  // [m/s²] of the frigate's database
constexpr double kThrottle = 0.5, kTick = 0.05;

std::shared_ptr<const Hydrodynamics> frigate() {
  static const auto ship = readHydrodynamics(CUTWATER_SOLVED "/frigate.h5");
  return ship;
}

// A following wave as long as the ship, and what it does to the ship at its own speed.
struct FollowingWave {
  double k = 2.0 * kPi / frigate()->length(), omega = std::sqrt(k * kGravity), speed = omega / k;
  Complex surge =
      frigate()->excitation(ForwardSpeedForm::Tuck).at(omega, 0.0, speed).total()[Surge];
  /// Where it pushes most, Re(F e^{−ikx}) = |F| [m].
  double pushesMostAt() const { return std::arg(surge) / k; }
};

// No time is lost until the propeller turns.
constexpr EngineParticulars kEngine{.timeConstant = 0.0};

// Resistance less thrust at a speed [N].
double lacksAt(double speed) {
  const ShipParticulars& ship = frigate()->ship();
  const Resistance resistance(ship);
  const Engine engine(ship, kEngine, -resistance.alongHull(Engine::hullSpeed(ship)),
                      std::make_shared<Helm>());
  return -resistance.alongHull(speed) - engine.thrust(kThrottle, speed);
}

struct Ride {
  double lowest = 0.0, highest = 0.0;  // place on the wave, from that at first, of its length
};

// From the wave's speed where it pushes most, for 400 s. Bullet holds the heading: whether a ship
// that is carried along also turns is another question.
Ride ride(const FollowingWave& wave, double amplitude) {
  ShipSettings settings;
  settings.model.mode = HullPressure::Nonlinear;
  settings.model.engine = kEngine;
  settings.start.speed = wave.speed;
  settings.start.x = wave.pushesMostAt();
  const SeaState sea({{.omega = wave.omega, .amplitude = amplitude}}, kGravity);
  OneShip run(frigate(), sea, settings);
  run.ship.body().setAngularFactor(btVector3(1, 1, 0));
  run.ship.setThrottle(kThrottle);
  Ride ride;
  while (run.seaway.time() < 400.0) {
    run.tick(kTick);
    const double goneBy = wave.speed * run.seaway.time();
    const double place =
        (run.ship.position().x() - settings.start.x - goneBy) * wave.k / (2.0 * kPi);
    ride.lowest = std::min(ride.lowest, place);
    ride.highest = std::max(ride.highest, place);
  }
  EXPECT_EQ(run.seaway.faults(), kStepOk);
  return ride;
}

// At the wave's speed the force of the wave is |F| a cos(k(x − x₀)) against what is lacking of
// thrust, D. A ship that begins where it is greatest is carried along where |F| a > D, and swings
// about the place where the two are equal; where |F| a < D there is no such place, and the wave
// goes by. The threshold is found to 5 %: D and |F| are of linear theory, waves of 1/270 high.
TEST(SurfRidingVerification, AWaveCarriesAShipAlongThatItPushesMoreThanItLacksOfThrust) {
  const FollowingWave wave;
  const double threshold = lacksAt(wave.speed) / std::abs(wave.surge);
  ASSERT_GT(threshold, 0.0);
  const Ride low = ride(wave, 0.95 * threshold), high = ride(wave, 1.05 * threshold);
  recordResult(kTopic,
               "surf-riding, a 5 % below the threshold: place on the wave after 400 s, least",
               "the wave goes by", low.lowest, "< -1");
  recordResult(kTopic, "surf-riding, a 5 % above the threshold: place on the wave in 400 s, least",
               "carried along", high.lowest, "> -0.25");
  EXPECT_LT(low.lowest, -1.0);
  EXPECT_GT(high.lowest, -0.25);
  EXPECT_LT(high.highest, 0.5);
}

}  // namespace
}  // namespace cutwater::test
