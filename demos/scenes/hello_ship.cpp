// A ship in a plain Bullet scene: hello_ship DATABASE.h5 [OUT.csv]
// Look for: it rolls and heaves in the beam sea for a minute and stays about where it is.
#include <btBulletDynamicsCommon.h>

#include <cstdio>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Seaway.h"

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::puts("usage: hello_ship DATABASE.h5 [OUT.csv]");
    return 2;
  }

  // A Bullet world as in every Bullet program, z up.
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-9.80665)));

  // The sea: 2 m waves of 8 s from port.  The ship: one file that `cutwater solve` made.
  const cutwater::SeaState sea =
      cutwater::makeSeaState({.hs = 2.0, .tp = 8.0}, {.heading = cutwater::kPi / 2, .ramp = 10.0});
  cutwater::Seaway seaway(world, sea);
  const auto frigate = cutwater::readHydrodynamics(argv[1]);
  cutwater::Ship& ship = seaway.addShip(frigate);

  std::FILE* csv = argc > 2 ? std::fopen(argv[2], "w") : stdout;
  if (csv == nullptr) {
    std::perror(argv[2]);
    return 1;
  }
  std::fprintf(csv, "t,x,y,z,roll_deg,pitch_deg,yaw_deg,wave\n");
  for (int frame = 0; frame <= 60 * 60; ++frame) {
    const cutwater::Vec3 p = ship.position(), a = ship.attitude() * 180.0 / cutwater::kPi;
    std::fprintf(csv, "%.3f,%.4f,%.4f,%.4f,%.3f,%.3f,%.3f,%.4f\n", seaway.time(), p.x(), p.y(),
                 p.z(), a.x(), a.y(), a.z(), sea.elevation(seaway.time(), p.x(), p.y()));
    world.stepSimulation(btScalar(1) / 60, 1, btScalar(1) / 60);
  }
  if (csv != stdout) std::fclose(csv);
  return seaway.faults() == cutwater::kStepOk ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "hello_ship: %s\n", error.what());
  return 1;
}
