// A thousand frigates on eight courses in one irregular sea: fleet DATABASE.h5 [OUT.csv]
// Look for: the real-time factor that is printed. Ships of one course differ only by where the
// waves meet them. One thread or two evaluate their loads to the same bits. Linear, for speed:
// nonlinear mode would take the pressure of 200 waves all over each hull, at each tick.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"
#include "hydro/waves/Spectrum.h"

using namespace cutwater;

namespace {

constexpr double kTick = 1.0 / 60.0, kSpeed = 6.0, kApart = 300.0, kDuration = 5.0;
constexpr int kColumns = 40, kRows = 25, kShown = 4;

struct Outcome {
  std::vector<btScalar> state;  // place and velocity of every ship
  std::uint32_t faults = kStepOk;
  double factor = 0.0, farthest = 0.0;
};

Outcome sail(const std::shared_ptr<const Hydrodynamics>& frigate, const SeaState& sea,
             unsigned threads, DemoTable* table) {
  BulletWorld bullet(frigate->ship().gravity);
  Seaway seaway(bullet.world, sea);
  seaway.setThreads(threads);
  btBoxShape hull(btVector3(60, 7, 5));
  std::optional<SceneRuns> runs;
  if (table != nullptr) runs.emplace(*table, seaway, kTick, 3);
  for (int i = 0; i < kColumns * kRows; ++i) {
    ShipSettings settings;
    settings.start.x = kApart * (i % kColumns);
    settings.start.y = kApart * (i / kColumns);
    settings.start.heading = i % 8 * kPi / 4.0;
    settings.start.speed = kSpeed;
    settings.model.mean = Mean::Free;
    settings.model.mode = HullPressure::Linear;
    settings.model.keepSpeed = SpeedKeeper{.speed = kSpeed};
    settings.model.keepCourse = CourseKeeper{.heading = settings.start.heading};
    settings.collision.shape = &hull;
    Ship& ship = seaway.addShip(frigate, settings);
    ship.prepare(kTick);
    // The corner of the fleet that a page can show.
    if (runs && i % kColumns < kShown && i / kColumns < kShown)
      runs->ship(std::to_string(i), ship, settings);
  }
  const auto begun = std::chrono::steady_clock::now();
  while (seaway.time() < kDuration - 0.5 * kTick) {
    bullet.world.stepSimulation(kTick, 1, kTick);
    if (table == nullptr) continue;
    for (const std::size_t i : {0u, 8u, 500u, 999u}) {
      const Ship& ship = *seaway.ships()[i];
      table->row({double(i), seaway.time(), ship.position().x(), ship.position().y(),
                  ship.motion()[Heave], ship.motion()[Roll] * 180.0 / kPi,
                  ship.motion()[Pitch] * 180.0 / kPi, ship.velocity()[Surge]});
    }
  }
  Outcome outcome;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun;
  if (runs) runs->write();
  outcome.factor = kDuration / spent.count();
  outcome.faults = seaway.faults();
  for (const auto& ship : seaway.ships()) {
    outcome.farthest = std::max(outcome.farthest, ship->motion().head<3>().norm());
    for (const btVector3& v :
         {ship->body().getWorldTransform().getOrigin(), ship->body().getLinearVelocity(),
          ship->body().getAngularVelocity()}) {
      outcome.state.insert(outcome.state.end(), {v.x(), v.y(), v.z()});
    }
  }
  return outcome;
}

bool run(const Coefficients& database, DemoTable& table) {
  const auto frigate = std::make_shared<const Hydrodynamics>(database);
  const SeaState sea =
      makeSeaState({.hs = 3.0, .tp = 9.0}, {.heading = 2.6, .components = 200, .ramp = 2.0});
  const Outcome one = sail(frigate, sea, 1, &table), two = sail(frigate, sea, 2, nullptr);
  std::printf("1000 ships, 200 waves: %.2f times real time on one thread, %.2f on two\n",
              one.factor, two.factor);
  const bool same =
      one.state.size() == two.state.size() &&
      std::memcmp(one.state.data(), two.state.data(), one.state.size() * sizeof(btScalar)) == 0;
  std::printf("the same bits on both: %s\n", same ? "yes" : "NO");
  return isBelow("farthest from its slow place [m]", one.farthest, 10.0) && same &&
         one.faults == kStepOk && two.faults == kStepOk;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "fleet", "ship,t,x,y,heave,roll_deg,pitch_deg,speed", run);
}
