// A storm builds up while a ship sails: calm water, a sea of 2 m, one of 8 m, and calm water again,
// without a stop: storm_builds DATABASE.h5 [OUT.csv]
// Look for: waves and motions grow smoothly over each change; the ship keeps its course and speed;
// no tick waits for the tables of the coming sea.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/PressureHull.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Recorder.h"

namespace {

using namespace cutwater;

struct Stage {
  const char* name;
  double begins, fade, ends;  // [s]: its sea is asked for, takes that long to come, is over
  Spectrum spectrum;
  double measured() const { return ends - begins - fade; }
};

SeaState seaOf(const Stage& stage, double gravity, std::uint64_t seed) {
  if (stage.spectrum.hs == 0.0) return {};
  Spectrum spectrum = stage.spectrum;
  spectrum.gravity = gravity;
  return makeSeaState(spectrum,
                      {.heading = 2.6, .spreading = 10.0, .components = 100, .seed = seed});
}

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::puts("usage: storm_builds DATABASE.h5 [OUT.csv]");
    return 2;
  }
  const auto frigate = readHydrodynamics(argv[1]);
  const double gravity = frigate->ship().gravity, speed = 6.0;
  BulletWorld bullet(gravity);
  Seaway seaway(bullet.world);
  ShipSettings settings{.start = {.speed = speed}};
  settings.model.mean = Mean::Free;
  settings.model.keepSpeed = {.speed = speed};
  settings.model.keepCourse = {.heading = 0.0};
  Ship& ship = seaway.addShip(frigate, settings);
  Recorder recorder(seaway, ship, {.every = 5});

  const Stage stages[] = {
      {"calm", 0.0, 0.0, 30.0, {.hs = 0.0}},
      {"2 m", 30.0, 60.0, 390.0, {.hs = 2.0, .tp = 8.0}},
      {"8 m", 390.0, 120.0, 1110.0, {.hs = 8.0, .tp = 12.0}},
      {"calm again", 1110.0, 90.0, 1320.0, {.hs = 0.0}},
  };
  const double tick = 0.02;
  bool good = true;
  double usual = 0.0, slowest = 0.0, ticks = 0.0, before = 0.0, jump = 0.0, steepest = 0.0;
  std::printf("sea          4 std of the waves   roll std   pitch std   speed\n");
  for (const Stage& stage : stages) {
    if (stage.fade > 0.0) {
      seaway.setSea(seaOf(stage, gravity, 3 + static_cast<std::uint64_t>(stage.begins)),
                    stage.fade);
      seaway.waitForSea();  // for the same bits in each run
    }
    double count = 0.0, waves = 0.0, roll = 0.0, pitch = 0.0, way = 0.0;
    for (int i = 0; seaway.time() < stage.ends; ++i) {
      const auto begins = std::chrono::steady_clock::now();
      bullet.world.stepSimulation(tick, 1, tick);
      const double took = milliseconds(std::chrono::steady_clock::now() - begins);
      const double height = seaway.waveHeight(ship.position().x(), ship.position().y());
      if (i == 0) {
        jump = std::max(jump, std::abs(height - before));
        slowest = std::max(slowest, took);
      } else {
        steepest = std::max(steepest, std::abs(height - before));
        usual += took;
        ticks += 1.0;
      }
      before = height;
      if (seaway.time() < stage.begins + stage.fade) continue;
      count += 1.0;
      waves += height * height;
      roll += std::pow(ship.attitude()[0], 2);
      pitch += std::pow(ship.attitude()[1], 2);
      way += ship.velocity()[Surge];
    }
    const double hs = 4.0 * std::sqrt(waves / count);
    const double degrees = 180.0 / kPi;
    std::printf("%-12s %8.2f m %18.2f deg %8.2f deg %8.2f m/s\n", stage.name, hs,
                degrees * std::sqrt(roll / count), degrees * std::sqrt(pitch / count), way / count);
    // Some minutes are fifty waves: their height is known to a tenth, 15 % in most draws.
    good = good && std::abs(hs - stage.spectrum.hs) <= 0.2 * stage.spectrum.hs + 1e-9;
    good = good && std::abs(way / count - speed) < 1.0;
  }
  std::printf(
      "over its triangles the ship of the calm takes the pressure of the storm to %.1f %%\n",
      100.0 * ship.pressureHull()->pressureErrorIn(seaOf(stages[2], gravity, 3)));
  std::printf("a tick takes %.3f ms, those in which a sea comes at most %.3f ms\n", usual / ticks,
              slowest);
  std::printf("the surface at the ship moves %.3f m in a tick at most, %.3f m where a sea comes\n",
              steepest, jump);
  good = good && jump <= steepest && !seaway.seaIsChanging();
  good = good && (seaway.faults() & ~kWarningBits) == kStepOk;
  recorder.write(argc > 2 ? argv[2] : "storm_builds.csv");
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "storm_builds: %s\n", error.what());
  return 1;
}
