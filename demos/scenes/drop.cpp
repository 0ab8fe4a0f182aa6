// A ship falls into calm water: drop DATABASE.h5 [OUT.csv]
// Look for: with its keel 3 m above the water and level (run 0) it feels the blow that von Kármán
// gives for wedges, here by strips of its own hull (run -1). Bow first (run 1) the blow is at the
// bow. From 50 m (run 2) and 100 m under water (run 3) it comes to rest afloat as well; the latter
// leaps out first, as nothing resists its rise but added mass. Energy only falls.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/Sections.h"
#include "hydro/ship/StillWater.h"

using namespace cutwater;

namespace {

constexpr double kDegree = kPi / 180.0, kTick = 0.005;
constexpr double kDuration = 150.0, kEntry = 0.4;  // [s]; after the first touch

// What a ship feels as it meets the water: the water's force over its weight, in a tick's mean.
struct Blow {
  double felt = 0.0;   // most [g]
  double at = 0.0;     // when, after the first touch [s]
  double speed = 0.0;  // upward, left at the end of the entry [m/s]

  void take(double nowFelt, double time, double nowSpeed) {
    if (nowFelt > felt) at = time;
    felt = std::max(felt, nowFelt);
    speed = nowSpeed;
  }
};

// Keel level, by strips [vonKarman29]: d((M + m) v)/dt = ρgV − Mg, ten steps to a tick.
Blow vonKarman(const ShipParticulars& ship, double clear, DemoTable& table) {
  const Sections sections(ship);
  StillWater water(ship);
  Blow blow;
  const double step = 0.1 * kTick, g = ship.gravity;
  double height = ship.cog.z() - bounds(ship.hull).low.z(), momentum = 0.0;
  blow.speed = -std::sqrt(2.0 * g * clear);
  momentum = ship.mass * blow.speed;
  for (double t = 0.0; t < kEntry; t += kTick) {
    const double before = blow.speed;
    for (int i = 0; i < 10; ++i) {
      momentum += step * (ship.density * g * water.at({.height = height}).volume - ship.mass * g);
      height += step * blow.speed;
      blow.speed = momentum / (ship.mass + sections.addedMass(ship.density, ship.cog.z() - height));
    }
    const double felt = (blow.speed - before) / (kTick * g) + 1.0;
    table.row({-1.0, t, t, height, 0.0, blow.speed, felt, felt, 0.0, 0.0});
    blow.take(felt, t, blow.speed);
  }
  return blow;
}

// A fall to the end, and whether it ended as falls do.
struct Fall {
  Blow blow;
  double bow = 0.0;  // most that the bow feels meanwhile [g]
  bool good = false;
};

Fall fall(int run, const Coefficients& coefficients, const Vec6& offset, DemoTable& table) {
  const ShipParticulars& particulars = coefficients.ship;
  const Vec3 bow(bounds(particulars.hull).high.x(), 0.0, 0.0);
  BulletWorld bullet(particulars.gravity);
  Seaway calm(bullet.world);
  Ship& ship = calm.addShip(coefficients, {.start = {.offset = offset}});
  Fall fall;
  double first = 0.0, gained = 0.0, touched = 1e9;
  for (int i = 0; i * kTick < kDuration; ++i) {
    const double before = ship.body().getLinearVelocity().z();
    bullet.world.stepSimulation(kTick, 1, kTick);
    const double speed = ship.body().getLinearVelocity().z();
    const double felt = (speed - before) / (kTick * particulars.gravity) + 1.0;
    const double atBow = ship.pointMotion(bow).acceleration.z() / particulars.gravity + 1.0;
    if (i == 0) first = ship.energy();
    const Wetted wet = ship.wetted().value_or(Wetted{});
    if (wet.area > 0.0) touched = std::min(touched, ship.lastTick().time);
    const double t = ship.lastTick().time - std::min(touched, ship.lastTick().time);
    if (wet.area > 0.0 && t < kEntry) {
      fall.blow.take(felt, t, speed);
      fall.bow = std::max(fall.bow, atBow);
    }
    gained = std::max(gained, ship.energy() - first);
    if (t < 3.0 || i % 20 == 0)
      table.row({double(run), ship.lastTick().time, t, ship.position().z(),
                 ship.attitude().y() / kDegree, speed, felt, atBow, wet.immersion, ship.energy()});
  }
  std::printf("run %d: %.2f g, %.2f g at the bow\n", run, fall.blow.felt, fall.bow);
  const double rest = particulars.cog.z();
  fall.good = (calm.faults() & ~kWarningBits) == 0;
  // A blow changes the velocity within the tick of which energy takes the mean.
  fall.good &= isBelow("  energy gained, of what it fell with", gained / std::abs(first), 1e-3);
  fall.good &= agrees("  floats in the end: height of G [m]", ship.position().z(), rest, 0.02);
  fall.good &= agrees("  and upright: roll [deg]", ship.attitude().x() / kDegree, 0.0, 1.0);
  return fall;
}

bool run(const Coefficients& coefficients, DemoTable& table) {
  const ShipParticulars& ship = coefficients.ship;
  const Bounds hull = bounds(ship.hull);
  const double clear = 3.0, impact = std::sqrt(2.0 * ship.gravity * clear);
  const Blow theory = vonKarman(ship, clear, table);
  Vec6 offset = Vec6::Zero();
  offset[Heave] = clear - hull.low.z();
  const Fall level = fall(0, coefficients, offset, table);
  // Added mass is whole at 0.9 of the beam (PressureHull.h), 1/0.81 of von Kármán's.
  bool good = level.good;
  good &= agrees("  felt / von Karman's", level.blow.felt / theory.felt, 1.0, 0.25);
  good &= agrees("  speed lost / von Karman's",
                 (impact + level.blow.speed) / (impact + theory.speed), 1.0, 0.25);
  offset[Pitch] = 10.0 * kDegree;
  offset[Heave] += hull.high.x() * std::sin(offset[Pitch]);
  const Fall bowFirst = fall(1, coefficients, offset, table);
  good &= isBelow("  felt by the whole ship / at the bow", bowFirst.blow.felt / bowFirst.bow, 0.7);
  for (const double height : {50.0, -100.0}) {
    offset.setZero();
    offset[Heave] = height;
    good &= fall(height > 0.0 ? 2 : 3, coefficients, offset, table).good;
  }
  return good && bowFirst.good;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(
      argc, argv, "drop",
      "run,t,since_touch,z,pitch_deg,vertical_speed,felt_g,felt_at_bow_g,immersion,energy", run);
}
