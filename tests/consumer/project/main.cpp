// A ship in a user's own Bullet program: consumer_float SPHERE.h5
// Lifted by h and let go, the sphere starts to fall with (C33 h - F) / (m + A33(inf)), F a load of
// the user's own.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "hydro/forces/Hydrodynamics.h"
#include "plugin/Seaway.h"

namespace {

// A crane that takes a steady share of the weight.
class Crane final : public cutwater::ForceGenerator {
 public:
  explicit Crane(double pull) : pull_(pull) {}
  std::string_view name() const noexcept override { return "crane"; }
  cutwater::Wrench evaluate(const cutwater::TickInput&) noexcept override {
    cutwater::Wrench wrench{.axes = cutwater::Axes::Earth};
    wrench.load[cutwater::Heave] = pull_;
    return wrench;
  }

 private:
  double pull_;  // [N]
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);

  const auto hydrodynamics = cutwater::readHydrodynamics(argv[1]);
  const cutwater::Coefficients& sphere = hydrodynamics->coefficients();
  world.setGravity(btVector3(0, 0, btScalar(-sphere.ship.gravity)));
  cutwater::Seaway seaway(world);
  cutwater::ShipSettings settings;
  const double lift = 0.5;  // [m]
  settings.start.offset[2] = lift;
  cutwater::Ship& ship = seaway.addShip(hydrodynamics, settings);
  const double pull = 0.2 * sphere.ship.restoring(2, 2) * lift;  // [N]
  ship.addForce(std::make_unique<Crane>(pull));

  const double step = 0.005;  // [s]
  const int ticks = 10;
  for (int i = 0; i < ticks; ++i) world.stepSimulation(btScalar(step), 1, btScalar(step));

  const double reached = ship.velocity()[2] / (ticks * step);
  const double expected = (pull - sphere.ship.restoring(2, 2) * lift) /
                          (sphere.ship.mass + sphere.addedMass.atInfinity(2, 2));
  std::printf("%zu bytes a btScalar: %.4f m/s2, expected %.4f\n", sizeof(btScalar), reached,
              expected);
  // 5 %: in 0.05 s the waves it radiates and the change of C33 z are still of second order.
  const bool right =
      std::abs(reached / expected - 1.0) < 0.05 && ship.load("crane")[cutwater::Heave] == pull;
  return right && seaway.faults() == cutwater::kStepOk ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
