// The manual's saving and rollback: what is restored goes on with the same bits.
#include <cstdio>
#include <fstream>

#include "demos/scenes/BulletWorld.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/waves/Spectrum.h"
#include "plugin/Seaway.h"

namespace {

void sail(btDiscreteDynamicsWorld& world, int ticks) {
  for (int i = 0; i < ticks; ++i) world.stepSimulation(btScalar(1) / 60, 1, btScalar(1) / 60);
}

}  // namespace

int main() {
  cutwater::BulletWorld bullet(9.80665);
  btDiscreteDynamicsWorld& world = bullet.world;
  cutwater::Seaway seaway(world, cutwater::makeSeaState({.hs = 0.8, .tp = 5.0}, {}));
  cutwater::Ship& ship = seaway.addShip(cutwater::readHydrodynamics("boat.h5"));
  sail(world, 600);
  //! [rollback]
  cutwater::Seaway::Snapshot snapshot = seaway.save();
  seaway.forgetContacts();  // where bodies touch: Bullet's warm start is part of the future
  sail(world, 300);
  const cutwater::Vec3 first = ship.position();

  seaway.restore(snapshot);
  seaway.forgetContacts();
  sail(world, 300);
  const bool same = ship.position() == first;  // to the last bit
  seaway.save(snapshot);                       // again: allocates nothing
  //! [rollback]

  //! [file]
  const std::vector<std::byte> bytes = snapshot.toBytes();
  std::ofstream("sail.save", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  // Later, in another process with the same sea and the same ships:
  seaway.restore(cutwater::Seaway::Snapshot::fromBytes(bytes));
  //! [file]
  std::printf("the same bits: %s\n", same ? "yes" : "no");
  return same ? 0 : 1;
}
