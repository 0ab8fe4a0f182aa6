// A ship in a plain Bullet scene: hello_ship [DATABASE.h5 [OUT.csv]]
// Without a database it takes the boat of 12 m that the build has solved.
// Look for: it sails for a minute at 3 m/s along +x through a short sea, pitches and rolls.
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <string>

#include "demos/scenes/BoatDatabase.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Seaway.h"

int main(int argc, char** argv) try {
  const std::string database = argc > 1 ? argv[1] : cutwater::boatDatabase();

  // A Bullet world as in every Bullet program, z up.
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-9.80665)));

  // The sea: 0.6 m waves of 4.5 s, from port and ahead.
  const double heading = 2.0;  // of the waves, relative to the ship's: 0 is following, π head seas
  const cutwater::SeaState sea =
      cutwater::makeSeaState({.hs = 0.6, .tp = 4.5}, {.heading = heading, .ramp = 10.0});
  cutwater::Seaway seaway(world, sea);

  // The ship: one file that `cutwater solve` made.  It keeps its speed and course.
  cutwater::ShipSettings settings;
  settings.start.speed = 3.0;  // m/s
  settings.model.keepSpeed = {.speed = 3.0};
  settings.model.keepCourse = {.heading = 0.0};
  cutwater::Ship& ship = seaway.addShip(cutwater::readHydrodynamics(database), settings);

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
  std::fprintf(stderr, "hello_ship: %s sailed %.0f m in a minute\n", database.c_str(),
               ship.position().x());
  return seaway.faults() == cutwater::kStepOk ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "hello_ship: %s\n", error.what());
  return 1;
}
