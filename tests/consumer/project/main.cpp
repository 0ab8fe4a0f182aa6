// A ship in a user's own Bullet program: consumer_float SPHERE.h5
// Lifted by h and let go, the sphere starts to fall with C33 h / (m + A33(inf)).
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <exception>

#include "hydro/database/CoefficientsFile.h"
#include "plugin/Seaway.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);

  const cutwater::Coefficients sphere = cutwater::readCoefficients(argv[1]);
  world.setGravity(btVector3(0, 0, btScalar(-sphere.ship.gravity)));
  cutwater::Seaway seaway(world);
  cutwater::ShipSettings settings;
  const double lift = 0.5;  // [m]
  settings.start.offset[2] = lift;
  cutwater::Ship& ship = seaway.addShip(sphere, settings);

  const double step = 0.005;  // [s]
  const int ticks = 10;
  for (int i = 0; i < ticks; ++i) world.stepSimulation(btScalar(step), 1, btScalar(step));

  const double reached = ship.velocity()[2] / (ticks * step);
  const double expected =
      -sphere.ship.restoring(2, 2) * lift / (sphere.ship.mass + sphere.addedMassInf(2, 2));
  std::printf("%zu bytes a btScalar: %.4f m/s2, expected %.4f\n", sizeof(btScalar), reached,
              expected);
  // 5 %: in 0.05 s the waves it radiates and the change of C33 z are still of second order.
  const bool right = std::abs(reached / expected - 1.0) < 0.05;
  return right && seaway.faults() == cutwater::kStepOk ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
