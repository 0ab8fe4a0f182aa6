// A ship in a lock: calm water rises by 6 m in five minutes, and falls again:
// lock DATABASE.h5 [OUT.csv]
// Look for: the ship follows within centimetres, at the water's speed, without a jump where it
// begins or ends; against the water it ends where it was. z in the table is that of the world, the
// draught is kept.
#include <algorithm>
#include <cmath>

#include "demos/scenes/DemoShip.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kRise = 6.0, kRate = 0.02, kPhase = 400.0;

bool run(const Coefficients& coefficients, DemoTable& table) {
  BulletWorld bullet(coefficients.ship.gravity);
  Seaway seaway(bullet.world);
  Ship& ship = seaway.addShip(coefficients);
  const double rest = ship.position().z(), draught = ship.draught(0.0);
  double farthest = 0.0, jump = 0.0, before = 0.0, following = 0.0;
  const auto height = [&] { return double(ship.body().getWorldTransform().getOrigin().z()); };
  bool good = true;
  int ticks = 0;
  for (const double level : {kRise, 0.0}) {
    seaway.setCalmLevel(level, kRate);
    const double until = seaway.time() + kPhase;
    while (seaway.time() < until) {
      bullet.world.stepSimulation(kTick, 1, kTick);
      const double speed = double(ship.body().getLinearVelocity().z());
      farthest = std::max(farthest, std::abs(ship.position().z() - rest));
      jump = std::max(jump, std::abs(speed - before));
      before = speed;
      if (ticks++ % 25 == 0)
        table.row(
            {seaway.time(), seaway.calmLevel(), height(), speed, ship.draught(seaway.time())});
      if (std::abs(seaway.calmLevel() - 0.5 * kRise) < kRate * kTick) following = std::abs(speed);
    }
    good &= agrees("calm level [m]", seaway.calmLevel(), level, 0.0);
    good &= agrees("G in the world [m]", height(), rest + level, 0.005);
  }
  good &= agrees("speed half-way [m/s]", following, kRate, 0.1 * kRate);
  good &= isBelow("farthest from its place in the water [m]", farthest, 0.05);
  // A ship left behind by water of speed v heaves at its frequency: no faster than v ω, and that is
  // without added mass.
  const double omega =
      std::sqrt(coefficients.ship.restoring(Heave, Heave) / coefficients.ship.mass);
  good &= isBelow("largest change of speed in a tick [m/s]", jump, kRate * omega * kTick);
  good &= agrees("draught [m]", ship.draught(seaway.time()), draught, 0.005);
  return good && seaway.faults() == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "lock", "t,calm_level,z,speed,draught", run);
}
