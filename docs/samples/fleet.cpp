// The manual's fleet: one database, many ships, a tick that is prepared before it comes.
#include <algorithm>
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Seaway.h"

int main() {
  cutwater::BulletWorld bullet(9.80665);
  btDiscreteDynamicsWorld& world = bullet.world;
  //! [fleet]
  const auto boat = cutwater::readHydrodynamics("boat.h5");  // read once, shared by all
  cutwater::Seaway seaway(world,
                          cutwater::makeSeaState({.hs = 0.8, .tp = 5.0}, {.components = 50}));
  seaway.setThreads(2);  // the same bits for any number
  for (int i = 0; i < 20; ++i) {
    cutwater::ShipSettings settings;
    settings.start.x = 40.0 * (i % 5);
    settings.start.y = 40.0 * (i / 5);
    settings.start.speed = 3.0;
    settings.model.hullTriangles = 500;  // a third of the cost of 2000
    settings.model.keepSpeed = cutwater::SpeedKeeper{.speed = 3.0};
    settings.model.keepCourse = cutwater::CourseKeeper{};
    seaway.addShip(boat, settings);
  }
  seaway.prepare(1.0 / 60.0);  // now, so that the first tick takes no longer than others
  for (int frame = 0; frame < 20 * 60; ++frame) world.stepSimulation(btScalar(1) / 60);
  if (seaway.faults() != cutwater::kStepOk)
    std::printf("%s\n", cutwater::faultText(seaway.faults()).c_str());
  //! [fleet]
  double slowest = 1e9;
  for (const auto& ship : seaway.ships()) slowest = std::min(slowest, ship->position().x());
  std::printf("the last boat has made %.1f m in 20 s\n", slowest);
  return slowest > 40.0 && slowest < 75.0 ? 0 : 1;
}
