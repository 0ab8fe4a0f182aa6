// A free ship turns by 90 degrees in calm water (run 0) and by 360 degrees in a sea that is a head
// sea at first (run 1): turning DATABASE.h5 [OUT.csv]
// Look for: it slows and heels in the turn and settles on the new heading and speed; no force jumps
// from tick to tick. In the full turn it meets the waves from all sides, and overtakes some: heave
// follows the wave at the ship. Left alone while yawing (run 2), it coasts; the lift of the hull
// steadies it, and its energy only falls.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "hydro/waves/Spectrum.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kSpeed = 8.0, kDegree = kPi / 180.0;

void record(DemoTable& table, int run, const Seaway& seaway, const Ship& ship) {
  const double atRest = ship.coefficients().ship.cog.z();
  const Vec3 at = ship.position(), attitude = ship.attitude() / kDegree;
  const Vec6 v = ship.velocity();
  table.row({double(run), seaway.time(), at.x(), at.y(), attitude.z(), attitude.x(), v[Surge],
             v[Sway], ship.course().speed(), ship.energy(), at.z() - atRest,
             seaway.waveHeight(at.x(), at.y())});
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

// How far, and how fast the order moves there: a helmsman, and no step in any force.
struct Order {
  double degrees = 90.0, perSecond = 3.0;
};

bool turn(int run, const Coefficients& frigate, const SeaState& sea, const Order& order,
          double jumps, DemoTable& table) {
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
  // Half a minute before and 440 s after: the engine's order, raised in the turn, has to come back.
  const double duration = 30.0 + order.degrees / order.perSecond + 440.0;
  for (int i = 0; i < duration / kTick; ++i) {
    const double now = std::clamp(order.perSecond * (seaway.time() - 30.0), 0.0, order.degrees);
    ship.keepCourse({.heading = now * kDegree});
    bullet.world.stepSimulation(kTick, 1, kTick);
    if (i > 0) largest = std::max(largest, change(ship.lastTick().loads, before, ship));
    before = ship.lastTick().loads;
    slowest = std::min(slowest, ship.velocity()[Surge]);
    fastest = std::max(fastest, ship.velocity()[Surge]);
    if (i % 10 == 0) record(table, run, seaway, ship);
  }
  bool good = seaway.faults() == kStepOk;
  const double off = std::remainder(ship.attitude().z() - order.degrees * kDegree, 2.0 * kPi);
  good &= agrees("heading less the order [deg]", off / kDegree, 0.0, 1.0);
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
  bullet.world.stepSimulation(kTick, 1, kTick);  // energy is that of a tick
  const double first = ship.energy();
  double gained = 0.0;
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
  const bool calm = turn(0, frigate, SeaState(), {}, 0.0005, table);
  const bool rough = turn(1, frigate, sea, {360.0, 1.0}, 0.03, table);
  return coast(frigate, table) && calm && rough;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "turning",
                  "run,t,x,y,heading_deg,roll_deg,speed,leeway,mean_speed,energy,"
                  "heave,wave",
                  run);
}
