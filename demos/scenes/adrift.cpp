// What calm water does to a ship without an engine: adrift DATABASE.h5 [OUT.csv]
// Look for: pushed from abeam by 0.65 % of its weight (300 kN of a frigate) it ends at the speed at
// which the drag of the flow across it balances the push; spun at 6 degrees a second it comes to
// rest; with way on it slows and does not stop dead.
#include <algorithm>

#include "demos/scenes/DemoShip.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kDegree = kPi / 180.0;

/// What the ship shows to a flow from abeam [m²]: its wet port side, seen from there.
double lateralArea(const ShipParticulars& ship) {
  double area = 0.0;
  for (const Face& face : ship.wetSurface.faces)
    area += std::max(0.0, vectorArea(ship.wetSurface, face).y());
  return area;
}

template <class Push>
void sail(int run, Seaway& seaway, BulletWorld& bullet, double seconds, DemoTable& table,
          Push push) {
  const Ship& ship = *seaway.ships().front();
  for (int i = 0; i * kTick < seconds; ++i) {
    push();
    bullet.world.stepSimulation(kTick, 1, kTick);
    const Vec6 v = ship.velocity();
    if (i % 50 == 0) table.row({double(run), seaway.time(), v[Surge], v[Sway], v[Yaw] / kDegree});
  }
}

bool pushed(const Coefficients& coefficients, DemoTable& table) {
  const ShipParticulars& hull = coefficients.ship;
  BulletWorld bullet(hull.gravity);
  Seaway seaway(bullet.world);
  // Its course is held: the push would turn it, as its side has not its middle at G.
  const ShipModel held{.restrained = {true, false, false, false, false, true}};
  Ship& ship = seaway.addShip(coefficients, {.model = held});
  const double force = 0.0065 * hull.mass * hull.gravity;
  sail(0, seaway, bullet, 1200.0, table,
       [&] { ship.body().applyCentralForce(btVector3(0, force, 0)); });
  const double balance =
      std::sqrt(2.0 * force / (hull.density * hull.drag.crossFlow * lateralArea(hull)));
  return agrees("pushed from abeam: speed [m/s]", ship.velocity()[Sway], balance, 2e-3 * balance) &&
         seaway.faults() == kStepOk;
}

bool spun(const Coefficients& coefficients, DemoTable& table) {
  BulletWorld bullet(coefficients.ship.gravity);
  Seaway seaway(bullet.world);
  Ship& ship = seaway.addShip(coefficients);
  ship.resetVelocity(Vec3::Zero(), Vec3(0.0, 0.0, 6.0 * kDegree));
  sail(1, seaway, bullet, 500.0, table, [] {});
  return isBelow("spun: left after 500 s [deg/s]", std::abs(ship.velocity()[Yaw]) / kDegree, 0.1) &&
         seaway.faults() == kStepOk;
}

bool underWay(const Coefficients& coefficients, DemoTable& table) {
  BulletWorld bullet(coefficients.ship.gravity);
  Seaway seaway(bullet.world);
  const double speed = 0.2 * std::sqrt(coefficients.ship.gravity * coefficients.ship.length());
  Ship& ship = seaway.addShip(coefficients, {.start = {.speed = speed}});
  sail(2, seaway, bullet, 900.0, table, [] {});
  return isBelow("with way on: left after 900 s", ship.velocity()[Surge] / speed, 0.6) &&
         isBelow("with way on: it does not go astern", -ship.velocity()[Surge], 0.0);
}

// A rudder amidships would have a share in the drag.
bool run(Coefficients coefficients, DemoTable& table) {
  coefficients.ship.engine.reset();
  coefficients.ship.rudder.reset();
  const bool ends = pushed(coefficients, table), rests = spun(coefficients, table);
  return underWay(coefficients, table) && ends && rests;
}

}  // namespace

int main(int argc, char** argv) { return demoMain(argc, argv, "adrift", "run,t,u,v,r_deg", run); }
