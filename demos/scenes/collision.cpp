// A ship at 2 m/s runs into the side of another: collision DATABASE.h5 [OUT.csv]
// Look for: momentum (M + A∞)v passes from one to the other, with the water's share, and energy
// only falls. The solver's iterations (5 to 100) change only the first digits of what is lost.
#include <algorithm>

#include "demos/scenes/DemoShip.h"
#include "plugin/ShipAxes.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 64.0, kSpeed = 2.0;

struct Result {
  std::uint32_t faults = kStepOk;
  // Momentum of both less what the water gave, at worst, of the momentum at first.
  double lost = 0.0;
  double lostInTick = 0.0;  // the same of one tick
  double bodies = 0.0;      // what is missing if only bodies are counted
  double energy = 0.0;      // the most there is, of that at first
  double left = 0.0;        // and what is left
};

// ∫ of the hydrodynamic force in a tick, in E; A∞ is on the other side of the balance.
Vec3 impulse(const Ship& ship) {
  const Vec6 load = ship.load("gravity") + ship.load("restoring") + ship.load("radiation") +
                    ship.load("supplementary");
  return kTick * rotationZ(ship.course().heading()) * load.head<3>();
}

Result collide(const std::shared_ptr<const Hydrodynamics>& frigate, int iterations,
               DemoTable& table) {
  BulletWorld bullet(frigate->ship().gravity);
  bullet.world.getSolverInfo().m_numIterations = iterations;
  Seaway calm(bullet.world);
  ShipSettings settings;
  settings.start.x = -78.0;  // the bow 1.8 m off the other's side
  settings.start.velocity[Surge] = kSpeed;
  Ship& runs = calm.addShip(frigate, settings);
  settings = {};
  settings.start.y = 2.0;
  settings.start.heading = kPi / 2.0;
  Ship& lies = calm.addShip(frigate, settings);
  runs.body().setFriction(0);
  const double first = runs.momentum().x(), energyAtFirst = runs.energy();
  const double mass = frigate->ship().mass;

  Result result;
  Vec3 water = Vec3::Zero();
  for (int i = 0; i < 30 * 64; ++i) {
    const double before = runs.momentum().x() + lies.momentum().x();
    bullet.world.stepSimulation(kTick, 1, kTick);
    const Vec3 now = impulse(runs) + impulse(lies);
    water += now;
    const double a = runs.momentum().x(), b = lies.momentum().x();
    const double left = runs.energy() + lies.energy();
    result.lost = std::max(result.lost, std::abs(a + b - first - water.x()) / first);
    result.lostInTick = std::max(result.lostInTick, std::abs(a + b - before - now.x()) / first);
    result.energy = std::max(result.energy, left / energyAtFirst);
    if (i == 3 * 64) {  // halfway
      const double bodies = mass * static_cast<double>(runs.body().getLinearVelocity().x() +
                                                       lies.body().getLinearVelocity().x());
      result.bodies = std::abs(bodies - mass * kSpeed - water.x()) / first;
    }
    result.left = left / energyAtFirst;
    if (i % 8 == 0) {
      table.row({double(iterations), calm.time(), runs.velocity()[Surge], -lies.velocity()[Sway],
                 a / first, b / first, water.x() / first, left / energyAtFirst,
                 lies.attitude().x() * 180.0 / kPi});
    }
  }
  result.faults = calm.faults();
  return result;
}

bool run(const Coefficients& database, DemoTable& table) {
  Coefficients bare = database;
  bare.ship.supplementary = {};
  const auto frigate = std::make_shared<const Hydrodynamics>(std::move(bare));
  bool good = true;
  std::puts("iterations  momentum lost  in one tick  energy at most  energy left");
  for (const int iterations : {5, 10, 20, 50, 100}) {
    const Result r = collide(frigate, iterations, table);
    std::printf("%10d %14.2e %12.2e %15.6f %12.6f\n", iterations, r.lost, r.lostInTick, r.energy,
                r.left);
    good &=
        r.faults == kStepOk && r.energy < 1.0 + 1e-6 && r.lost < (iterations < 10 ? 1e-3 : 1e-4);
    if (iterations < 100) continue;
    good &= isBelow("momentum lost", r.lost, 1e-4);
    good &= isBelow("energy at most, of that before", r.energy, 1.0 + 1e-6);
    std::printf("bodies alone, without the water's share: %.3f of the momentum is missing\n",
                r.bodies);
    good &= r.bodies > 0.05;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "collision",
                  "iterations,t,speed_a,speed_b,momentum_a,momentum_b,momentum_from_water,energy,"
                  "roll_b_deg",
                  run);
}
