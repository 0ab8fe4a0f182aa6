// Counts every allocation of this program, ours (operator new) and Bullet's.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "hydro/forces/nonlinear/CarriedLoad.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "plugin/Recorder.h"
#include "tests/plugin/TestShip.h"
#include "tests/plugin/TestWorld.h"
#include "tests/support/BareHull.h"
#include "tests/support/Results.h"

namespace {
std::atomic<long> allocations{0};  // ours and Bullet's
std::atomic<long> bullets{0};

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace cutwater::test {
namespace {

void* countedForBullet(size_t size) {
  ++allocations;
  ++bullets;
  return std::malloc(size);
}

TEST(Allocation, NoneInATickOnceAllIsWarm) {
  btAlignedAllocSetCustom(countedForBullet, std::free);
  {
    TestWorld world(kSphereGravity);
    btSphereShape shape(5);
    const Coefficients coefficients = hemisphere();
    Seaway seaway(world.world, SeaState({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}},
                                        kSphereGravity, 5.0));
    for (int i = 0; i < 5; ++i) {
      seaway.addShip(coefficients, {.start = {.x = 64.0 * i}, .collision = {.shape = &shape}});
    }
    Recorder recorder(seaway, *seaway.ships().front(), {.forces = true});
    recorder.reserve(1000);
    const btScalar tick = btScalar(1) / 64;
    for (int i = 0; i < 10; ++i) world.world.stepSimulation(tick, 1, tick);
    const long before = allocations;
    for (int i = 0; i < 500; ++i) world.world.stepSimulation(tick, 1, tick);
    EXPECT_EQ(allocations - before, 0);
    recordResult("Plugin", withPrecision("allocations in 500 ticks of 5 ships"), "0",
                 static_cast<double>(allocations - before), "0");
  }
  btAlignedAllocSetCustom(nullptr, nullptr);
}

// Another sea comes and the old one goes without an allocation in any tick, once its tables are
// made.
TEST(Allocation, NoneWhereSeasChange) {
  btAlignedAllocSetCustom(countedForBullet, std::free);
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    TestWorld world(kSphereGravity);
    btSphereShape shape(5);
    Seaway seaway(world.world,
                  SeaState({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}}, kSphereGravity));
    seaway.addShip(hemisphere(), {.model = {.mean = mean}, .collision = {.shape = &shape}});
    const btScalar tick = btScalar(1) / 64;
    for (int i = 0; i < 10; ++i) world.world.stepSimulation(tick, 1, tick);
    seaway.setSea(SeaState({{.omega = 0.8, .amplitude = 0.7, .heading = 1.0}}, kSphereGravity),
                  2.0);
    seaway.waitForSea();
    const long before = allocations;
    for (int i = 0; i < 200; ++i) world.world.stepSimulation(tick, 1, tick);
    EXPECT_EQ(allocations - before, 0);
    EXPECT_FALSE(seaway.seaIsChanging());
  }
  btAlignedAllocSetCustom(nullptr, nullptr);
}

// Bodies that float, in waves: some of them fall in, one is held, one asleep.
TEST(Allocation, NoneInATickOfFloats) {
  btAlignedAllocSetCustom(countedForBullet, std::free);
  {
    TestWorld world(kSphereGravity);
    btBoxShape shape(btVector3(1, 1, 1));
    Seaway seaway(world.world, SeaState({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}},
                                        kSphereGravity, 5.0));
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    for (int i = 0; i < 5; ++i) {
      bodies.push_back(
          std::make_unique<btRigidBody>(btScalar(4000), nullptr, &shape, btVector3(3e3, 3e3, 3e3)));
      bodies.back()->setCenterOfMassTransform(
          btTransform(btQuaternion::getIdentity(), btVector3(btScalar(8 * i), 0, btScalar(i))));
      world.world.addRigidBody(bodies.back().get());
      seaway.addFloat(*bodies.back());
    }
    bodies[3]->forceActivationState(DISABLE_SIMULATION);
    bodies[4]->forceActivationState(ISLAND_SLEEPING);
    const btScalar tick = btScalar(1) / 64;
    const auto ours = [] { return allocations - bullets; };
    const long first = ours();
    for (int i = 0; i < 10; ++i) world.world.stepSimulation(tick, 1, tick);
    EXPECT_EQ(ours() - first, 0);
    Seaway::Snapshot snapshot = seaway.save();
    const long before = ours();
    for (int i = 0; i < 500; ++i) world.world.stepSimulation(tick, 1, tick);
    seaway.save(snapshot);
    seaway.restore(snapshot);
    EXPECT_EQ(ours() - before, 0);  // Bullet's own lists grow when a body wakes
    for (const auto& body : bodies) world.world.removeRigidBody(body.get());
  }
  btAlignedAllocSetCustom(nullptr, nullptr);
}

// Bullet makes its own lists in the first ticks. Of ours there is nothing to make, neither in the
// first tick nor in a ship that begins anew.
TEST(Allocation, NoneOfOursInTheFirstTickNorInAReset) {
  btAlignedAllocSetCustom(countedForBullet, std::free);
  for (const Mean mean : {Mean::Fixed, Mean::Free}) {
    TestWorld world(kSphereGravity);
    btSphereShape shape(5);
    Seaway seaway(world.world, SeaState({{.omega = 1.0, .amplitude = 0.5, .heading = 2.0}},
                                        kSphereGravity, 5.0));
    Ship& ship =
        seaway.addShip(hemisphere(), {.model = {.mean = mean}, .collision = {.shape = &shape}});
    const auto ours = [] { return allocations - bullets; };
    const long before = ours();
    world.world.stepSimulation(btScalar(1) / 64, 1, btScalar(1) / 64);
    EXPECT_EQ(ours() - before, 0);
    const long all = allocations;
    ship.reset({.x = 5, .offset = Vec6::Constant(0.1)});
    EXPECT_EQ(allocations - all, 0);
  }
  btAlignedAllocSetCustom(nullptr, nullptr);
}

// Of a ship that is flooded, with cargo, while the water rises, and of its snapshot.
TEST(Allocation, NoneInATickOfAShipThatFloods) {
  TestWorld world(9.81);
  Seaway seaway(world.world);
  Ship& ship = seaway.addShip(bareShip({.closed = closedBox({12.0, 4.0, 0.8, 1.2}, 12, 2, 2),
                                        .cog = Vec3(0.0, 0.0, 0.2),
                                        .gyradii = Vec3(1.4, 3.4, 3.4)}));
  Compartment& hold = ship.addCompartment({.name = "hold", .size = {4.0, 3.0, 1.0}});
  hold.openTo({.place = {0.0, 1.5, -0.4}, .area = 0.02});
  ship.setWeights({{.name = "crate", .mass = 500.0, .place = {2.0, 0.5, 1.0}}});
  seaway.setCalmLevel(1.0, 0.05);
  const btScalar tick = btScalar(1) / 64;
  for (int i = 0; i < 10; ++i) world.world.stepSimulation(tick, 1, tick);
  Seaway::Snapshot snapshot = seaway.save();
  const long before = allocations;
  for (int i = 0; i < 500; ++i) world.world.stepSimulation(tick, 1, tick);
  seaway.save(snapshot);
  seaway.restore(snapshot);
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace cutwater::test
