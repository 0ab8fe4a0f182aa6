// The program of the README: run it where boat.h5 is, in the build folder.
// Look for: the height of the centre of gravity after a minute; at rest it is 0.3 m above calm
// water.
#include <iostream>

#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, btScalar(-9.80665)});
  //! [ship]
  cutwater::Seaway seaway(world, cutwater::SeaState({{.omega = 1.5, .amplitude = 0.4}}, 9.80665));
  cutwater::Ship& ship = seaway.addShip(cutwater::readHydrodynamics("boat.h5"));
  for (int frame = 0; frame < 60 * 60; ++frame) world.stepSimulation(btScalar(1) / 60);
  //! [ship]
  std::cout << "height of the centre of gravity: " << ship.position().z() << " m\n";
}
