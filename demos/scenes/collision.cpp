// A ship at 2 m/s runs into the side of another: collision DATABASE.h5 [OUT.csv]
// Look for: momentum passes from one to the other, with the water's share, ahead and sideways,
// on any heading of the scene, and energy only falls. More iterations of the solver lose less.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"
#include "plugin/ShipAxes.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kSpeed = 2.0;

struct Result {
  std::uint32_t faults = kStepOk;
  double lost = 0.0;    // momentum of both, at worst, of that at first; sideways too
  double bodies = 0.0;  // what is missing if only bodies are counted
  double energy = 0.0;  // the most there is, of that at first
  double left = 0.0;    // and what is left
};

/// Two frigates, one abeam of the other's way, the whole scene turned by `heading`.
struct Scene {
  Scene(const std::shared_ptr<const Hydrodynamics>& frigate, double heading, int iterations,
        const DemoTable& table)
      : bullet(frigate->ship().gravity),
        calm(bullet.world),
        along(rotationZ(heading)),
        shown(table, calm, kTick, 4) {
    bullet.world.getSolverInfo().m_numIterations = iterations;
    // The bow 1.8 m off the other's side.
    runs = &add(frigate, "striking", along * Vec3(-78.0, 0.0, 0.0), heading, kSpeed);
    lies = &add(frigate, "struck", along * Vec3(0.0, 2.0, 0.0), heading + kPi / 2.0, 0.0);
    runs->body().setFriction(0);
  }
  Ship& add(const std::shared_ptr<const Hydrodynamics>& frigate, const char* name, const Vec3& at,
            double heading, double speed) {
    ShipSettings settings;
    settings.start = {.x = at.x(), .y = at.y(), .heading = heading, .speed = speed};
    // Linear, where the water's momentum is A∞ v and that of the waves. Otherwise a hull that comes
    // out of the water leaves its share behind.
    settings.model.mode = HullPressure::Linear;
    settings.model.hullLift = settings.model.resistance = false;
    Ship& ship = calm.addShip(frigate, settings);
    shown.ship(name, ship, settings);
    return ship;
  }
  // Along the way of the first, to its port.
  Vec3 momentum(const Ship& ship) const {
    return along.transpose() * Vec3(ship.momentum().head<3>());
  }
  Vec3 velocity(const Ship& ship) const {
    const btVector3& v = ship.body().getLinearVelocity();
    return along.transpose() * Vec3(double(v.x()), double(v.y()), double(v.z()));
  }
  BulletWorld bullet;
  Seaway calm;
  Mat3 along;
  SceneRuns shown;
  Ship *runs = nullptr, *lies = nullptr;
};

Result collide(const std::shared_ptr<const Hydrodynamics>& frigate, double heading, int iterations,
               DemoTable& table) {
  Scene scene(frigate, heading, iterations, table);
  const Ship &runs = *scene.runs, &lies = *scene.lies;
  // The first tick finds the water's momentum about a ship that has long had its speed.
  scene.bullet.world.stepSimulation(kTick, 1, kTick);
  const double energyAtFirst = runs.energy() + lies.energy();
  const Vec3 atFirst = scene.momentum(runs) + scene.momentum(lies);
  const double first = atFirst.norm();
  Result result;
  for (int i = 0; i < 30 * 64 - 1; ++i) {
    scene.bullet.world.stepSimulation(kTick, 1, kTick);
    const Vec3 a = scene.momentum(runs), b = scene.momentum(lies);
    result.left = (runs.energy() + lies.energy()) / energyAtFirst;
    result.lost = std::max(result.lost, (a + b - atFirst).head<2>().norm() / first);
    result.energy = std::max(result.energy, result.left);
    const double speed = scene.velocity(runs).x(), struck = scene.velocity(lies).x();
    if (i == 3 * 64) {  // halfway
      result.bodies = std::abs(1.0 - (speed + struck) * frigate->ship().mass / first);
    }
    if (i % 8 == 0) {
      table.row({heading / kPi * 180.0, double(iterations), scene.calm.time(), speed, struck,
                 a.x() / first, b.x() / first, a.y() / first, b.y() / first, result.left,
                 lies.attitude().x() * 180.0 / kPi});
    }
  }
  result.faults = scene.calm.faults();
  if (heading == 0.0) scene.shown.write();  // the last one, of most iterations, stays
  return result;
}

bool run(const Coefficients& database, DemoTable& table) {
  Coefficients bare = database;
  bare.ship.supplementary = {};
  const auto frigate = std::make_shared<const Hydrodynamics>(std::move(bare));
  bool good = true;
  Result r;
  std::puts("heading  iterations  momentum lost  energy at most  energy left");
  for (const double heading : {0.0, 0.7, 4.0}) {
    for (const int iterations : {5, 10, 20, 50, 100}) {
      if (heading != 0.0 && iterations < 100) continue;
      r = collide(frigate, heading, iterations, table);
      std::printf("%7.1f %11d %14.2e %15.6f %12.6f\n", heading, iterations, r.lost, r.energy,
                  r.left);
      good &=
          r.faults == kStepOk && r.energy < 1.0 + 1e-6 && r.lost < (iterations < 10 ? 1e-3 : 1e-5);
    }
  }
  good &= isBelow("momentum lost, ahead and sideways", r.lost, 1e-5);
  good &= isBelow("energy at most, of that before", r.energy, 1.0 + 1e-6);
  std::printf("bodies alone, without the water's share: %.3f of the momentum is missing\n",
              r.bodies);
  return good && r.bodies > 0.05;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "collision",
                  "heading_deg,iterations,t,speed_a,speed_b,momentum_a,momentum_b,sideways_a,"
                  "sideways_b,energy,roll_b_deg",
                  run);
}
