// A free ship turns by 90 degrees in calm water and in a head sea: turning DATABASE.h5 [OUT.csv]
// Look for: it slows and heels in the turn and settles on the new heading and speed; no force jumps
// from tick to tick. Left alone while yawing (run 2), it coasts; the lift of the hull steadies it,
// and its energy only falls.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "hydro/waves/Spectrum.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kSpeed = 8.0, kDegree = kPi / 180.0;

void record(DemoTable& table, int run, const Seaway& seaway, const Ship& ship) {
  const Vec3 at = ship.position(), attitude = ship.attitude() / kDegree;
  const Vec6 v = ship.velocity();
  table.row({double(run), seaway.time(), at.x(), at.y(), attitude.z(), attitude.x(), v[Surge],
             v[Sway], ship.course().speed(), ship.energy()});
}

// Largest component, of weight or of weight times length.
double size(const Vec6& force, const Ship& ship) {
  const double weight = ship.coefficients().ship.mass * ship.coefficients().ship.gravity;
  return std::max(force.head<3>().cwiseAbs().maxCoeff() / weight,
                  force.tail<3>().cwiseAbs().maxCoeff() / weight / ship.length());
}

double change(const std::vector<Vec6>& a, const std::vector<Vec6>& b, const Ship& ship) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, size(a[i] - b[i], ship));
  return most;
}

// The order moves by 3 degrees a second: a helmsman, and no step in any force.
bool turn(int run, const Coefficients& frigate, const SeaState& sea, double jumps,
          DemoTable& table) {
  BulletWorld bullet(frigate.ship.gravity);
  Seaway seaway(bullet.world, sea);
  ShipSettings settings;
  settings.start.speed = kSpeed;
  settings.model.mean = Mean::Free;
  settings.model.keepSpeed = SpeedKeeper{.speed = kSpeed};
  settings.model.keepCourse = CourseKeeper{};
  Ship& ship = seaway.addShip(frigate, settings);
  double slowest = kSpeed, fastest = kSpeed, largest = 0.0;
  std::vector<Vec6> before = ship.lastTick().loads;
  for (int i = 0; i < 25000; ++i) {
    const double order = std::clamp(3.0 * (seaway.time() - 30.0), 0.0, 90.0) * kDegree;
    ship.keepCourse({.heading = order});
    bullet.world.stepSimulation(kTick, 1, kTick);
    if (i > 0) largest = std::max(largest, change(ship.lastTick().loads, before, ship));
    before = ship.lastTick().loads;
    slowest = std::min(slowest, ship.velocity()[Surge]);
    fastest = std::max(fastest, ship.velocity()[Surge]);
    if (i % 10 == 0) record(table, run, seaway, ship);
  }
  bool good = seaway.faults() == kStepOk;
  good &= agrees("heading [deg]", ship.attitude().z() / kDegree, 90.0, 1.0);
  good &= agrees("mean speed [m/s]", ship.course().speed(), kSpeed, 0.1);
  good &= isBelow("slower than ordered by [m/s]", kSpeed - slowest, 2.5);
  good &= isBelow("faster than ordered by [m/s]", fastest - kSpeed, 2.0);
  good &= isBelow("largest change of a force in a tick [weight]", largest, jumps);
  return good;
}

// Munk's moment would turn the ship; the lift of the hull holds against it.
bool coast(const Coefficients& frigate, DemoTable& table) {
  BulletWorld bullet(frigate.ship.gravity);
  Seaway seaway(bullet.world);
  ShipSettings settings;
  settings.start.speed = kSpeed;
  settings.model.mean = Mean::Free;
  settings.start.velocity[Yaw] = 0.001;
  Ship& ship = seaway.addShip(frigate, settings);
  double before = ship.energy(), gained = 0.0;
  const double first = before;
  while (std::abs(ship.motion()[Yaw]) < 30.0 * kDegree && seaway.time() < 200.0) {
    bullet.world.stepSimulation(kTick, 1, kTick);
    record(table, 2, seaway, ship);
    gained = std::max(gained, ship.energy() / first - 1.0);
  }
  bool good = seaway.faults() == kStepOk;
  good &= isBelow("coasting, energy gained", gained, 1e-6);
  good &= isBelow("coasting, energy left", ship.energy() / first, 1.0);
  return good;
}

bool run(const Coefficients& frigate, DemoTable& table) {
  const SeaState sea = makeSeaState({.hs = 3.0, .tp = 9.0}, {.heading = kPi, .ramp = 20.0});
  const bool calm = turn(0, frigate, SeaState(), 0.0005, table);
  const bool rough = turn(1, frigate, sea, 0.03, table);
  return coast(frigate, table) && calm && rough;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "turning",
                  "run,t,x,y,heading_deg,roll_deg,speed,leeway,mean_speed,energy", run);
}
