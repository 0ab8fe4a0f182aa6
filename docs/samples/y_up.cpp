// The plugin's README: a free ship with a helmsman, in a world with y up.
#include <cstdio>

#include "demos/scenes/BulletWorld.h"
//! [includes]
#include "hydro/forces/Hydrodynamics.h"  // readHydrodynamics
#include "hydro/waves/Spectrum.h"        // makeSeaState
#include "plugin/Seaway.h"
//! [includes]

namespace {

// A game runs until somebody ends it; this one for 20 s.
struct Running {
  int left = 20 * 60;
  explicit operator bool() { return left-- > 0; }
};

}  // namespace

int main() {
  cutwater::BulletWorld bullet;
  btDiscreteDynamicsWorld& world = bullet.world;
  world.setGravity({0, btScalar(-9.80665), 0});
  const btScalar frame = btScalar(1) / 60;
  Running running;
  //! [ship]
  const auto frigate = cutwater::readHydrodynamics("frigate.h5");  // shared by all of this database
  const cutwater::SeaState sea = cutwater::makeSeaState({.hs = 2.0, .tp = 8.0}, {.heading = 2.0});
  cutwater::Seaway seaway(world, sea, {.up = cutwater::WorldFrame::Up::Y});  // usual: z up, metres
  cutwater::ShipSettings settings;
  settings.start.speed = 8.0;  // m/s; heading 0: along +x
  settings.model.keepSpeed = {.speed = 8.0};
  settings.model.keepCourse = {.heading = 0.0};
  cutwater::Ship& ship = seaway.addShip(frigate, settings);
  while (running) world.stepSimulation(frame, 4, btScalar(1) / 60);  // draw at modelTransform()
  //! [ship]
  std::printf("%.1f m ahead, %.2f m up\n", ship.position().x(), ship.position().z());
  return ship.position().x() > 140.0 && seaway.faults() == cutwater::kStepOk ? 0 : 1;
}
