// A sphere of 5 m radius dropped from 1 m above its rest: free_decay DATABASE.h5 [OUT.csv]
// Look for: each swing is 0.73 of the one before; the first low is -0.867 m at 2.21 s (IEA OES Task
// 10), by linear theory.
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
#include "hydro/database/CoefficientsFile.h"
#include "plugin/Recorder.h"

int main(int argc, char** argv) try {
  using namespace cutwater;
  if (argc < 2) {
    std::puts("usage: free_decay DATABASE.h5 [OUT.csv]");
    return 2;
  }
  const Coefficients sphere = readCoefficients(argv[1]);
  BulletWorld bullet(sphere.ship.gravity);
  Seaway calm(bullet.world);
  ShipSettings dropped;
  dropped.start.offset[Heave] = 1.0;
  dropped.model.mode = HullPressure::Linear;
  Ship& ship = calm.addShip(sphere, dropped);
  Recorder recorder(calm, ship);

  double before = 1.0, now = 1.0;
  int swings = 0;
  const double tick = 0.01;
  for (int i = 1; i <= 2000; ++i) {
    bullet.world.stepSimulation(tick, 1, tick);
    const double next = ship.motion()[Heave];
    if (i > 2 && (now - before) * (next - now) < 0.0) {
      std::printf("swing %d: %+.4f m at %.2f s\n", ++swings, now, calm.time() - tick);
    }
    before = now;
    now = next;
  }
  if (argc > 2) recorder.write(argv[2]);
  return calm.faults() == kStepOk && swings >= 8 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "free_decay: %s\n", error.what());
  return 1;
}
