// A ship is holed in the side, settles and heels; then its bulkheads give way, and it founders:
// flooding DATABASE.h5 [OUT.csv]
// Look for: the first room fills until the water in it is as high as the sea; the ship comes to
// rest where its hull and that water have no righting lever together. With all rooms open it
// settles until its deck is under, and goes down: said by kFoundered, and by Ship::foundered.
#include <algorithm>
#include <cmath>

#include "demos/scenes/DemoShip.h"
#include "demos/scenes/SceneRuns.h"
#include "hydro/forces/Compartment.h"

using namespace cutwater;

namespace {

constexpr double kTick = 0.02, kDegree = kPi / 180.0;
constexpr double kHoled = 10.0, kBulkheads = 400.0, kEnd = 1500.0;  // [s]

struct Flooding {
  explicit Flooding(const Coefficients& coefficients)
      : bullet(coefficients.ship.gravity),
        seaway(bullet.world),
        ship(seaway.addShip(coefficients)),
        length(coefficients.ship.length()),
        beam(coefficients.ship.beam()),
        draught(-ship.hydrodynamics().keel()) {
    wing = &ship.addCompartment({.name = "wing",
                                 .centre = {0.0, -0.18 * beam, -0.2 * draught},
                                 .size = {0.12 * length, 0.25 * beam, 1.2 * draught},
                                 .permeability = 0.85});
    // Over most of the hull; amidships beside the wing.
    for (int i = -2; i <= 2; ++i) {
      const double across = i == 0 ? 0.55 : 0.8;
      holds.push_back(&ship.addCompartment(
          {.name = "hold" + std::to_string(i + 3),
           .centre = {0.15 * length * i, i == 0 ? 0.22 * beam : 0.0, 0.15 * draught},
           .size = {0.14 * length, across * beam, 2.0 * draught},
           .permeability = 0.95}));
    }
  }
  void tick(DemoTable& table) {
    bullet.world.stepSimulation(kTick, 1, kTick);
    if (ticks++ % 25 != 0) return;
    double water = wing->volume();
    for (const Compartment* hold : holds) water += hold->volume();
    table.row({seaway.time(), ship.position().z(), ship.attitude().x() / kDegree,
               ship.attitude().y() / kDegree, wing->volume(), wing->inflow(), wing->level(), water,
               ship.foundered() ? 1.0 : 0.0});
  }

  BulletWorld bullet;
  Seaway seaway;
  Ship& ship;
  double length, beam, draught;
  Compartment* wing = nullptr;
  std::vector<Compartment*> holds;
  long ticks = 0;
};

// Where hull and water have no righting lever, the water as a weight where it lies.
bool settlesWhereItShould(Flooding& scene) {
  const Coefficients& c = scene.ship.coefficients();
  const Vec6 rest = carrying(c.ship, scene.wing->mass(), scene.wing->centre() - c.ship.cog);
  const double height = scene.ship.position().z() - c.ship.cog.z();
  bool good = agrees("wing filled to the sea's level [m]", scene.wing->level(), 0.0, 0.02);
  good &= agrees("height of G against that at rest [m]", height, rest[Heave], 0.01);
  good &= agrees("heel [deg]", scene.ship.attitude().x() / kDegree, rest[Roll] / kDegree, 0.1);
  good &= agrees("trim [deg]", scene.ship.attitude().y() / kDegree, rest[Pitch] / kDegree, 0.02);
  return good;
}

bool run(const Coefficients& coefficients, DemoTable& table) {
  Flooding scene(coefficients);
  SceneRuns runs(table, scene.seaway, kTick, 25);
  runs.ship("ship", scene.ship, {});
  while (scene.seaway.time() < kHoled) scene.tick(table);
  const Vec3 middle = scene.wing->box().centre, half = 0.5 * scene.wing->box().size;
  scene.wing->openTo({.place = middle - Vec3(0.0, half.y(), 0.5 * half.z()), .area = 1.0});
  while (scene.seaway.time() < kBulkheads) scene.tick(table);
  bool good = settlesWhereItShould(scene);
  for (Compartment* hold : scene.holds)
    hold->openTo({.place = hold->box().centre - Vec3(0.0, 0.0, 0.3 * scene.draught), .area = 2.0});
  while (scene.seaway.time() < kEnd && !scene.ship.foundered()) scene.tick(table);
  good &= agrees("it founders", scene.ship.foundered() ? 1.0 : 0.0, 1.0, 0.0);
  std::printf("at %.0f s, heeled by %.1f deg\n", scene.seaway.time(),
              std::abs(scene.ship.attitude().x()) / kDegree);
  const double under = scene.ship.position().z(), until = scene.seaway.time() + 30.0;
  while (scene.seaway.time() < until) scene.tick(table);
  good &= isBelow("height of G after 30 s more [m]", scene.ship.position().z(), under - 10.0);
  good &= (scene.seaway.faults() & ~kWarningBits) == 0;
  runs.write();
  return good && (scene.seaway.faults() & kFoundered) != 0;
}

}  // namespace

int main(int argc, char** argv) {
  return demoMain(argc, argv, "flooding",
                  "t,z,roll_deg,pitch_deg,wing_volume,wing_inflow,wing_level,water,foundered", run);
}
