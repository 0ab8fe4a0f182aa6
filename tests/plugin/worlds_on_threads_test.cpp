// Worlds on different threads that share what their ships have in common. `./run test --threads`
// runs this under the thread sanitizer.
#include <gtest/gtest.h>

#include <array>
#include <latch>
#include <thread>

#include "hydro/forces/Hydrodynamics.h"
#include "tests/plugin/TestScene.h"

namespace cutwater::test {
namespace {

constexpr std::size_t kWorlds = 4;

/// What world `i` of four does: both means, both memories, ships that come and go.
/// @return its state at the end, as bytes.
std::vector<std::byte> sail(std::size_t i, const std::shared_ptr<const Hydrodynamics>& ship) {
  TestWorld world(kSphereGravity);
  Seaway seaway(world.world, waves());
  if (i == 3) seaway.setThreads(2);
  const auto run = [&](int ticks) {
    for (int tick = 0; tick < ticks; ++tick) world.world.stepSimulation(kTick, 1, kTick);
  };
  ShipSettings settings;
  const bool follows = i % 2 == 1;  // at speed: for a fixed course the ship lacks diffraction
  settings.start.speed = follows ? 3.0 + 0.5 * static_cast<double>(i) : 0.0;
  settings.start.heading = 0.3 * static_cast<double>(i);
  settings.model.mean = follows ? Mean::Free : Mean::Fixed;
  settings.model.memory = i < 2 ? MemoryModel::Exponential : MemoryModel::Convolution;
  Ship& first = seaway.addShip(ship, settings);
  run(20);
  settings.start.y = 300.0;
  seaway.addShip(ship, settings);
  run(20);
  seaway.removeShip(first);
  settings.start.y = -300.0;
  seaway.addShip(ship, settings).placeAt(0.0, -400.0, 0.4, one(Roll, 0.05), settings.start.speed);
  run(20);
  EXPECT_EQ(seaway.faults(), kStepOk);
  return seaway.save().toBytes();
}

// Hydrodynamics are made anew for each round, so that what they make when first asked is asked for
// by all threads at once.
TEST(WorldsOnThreadsIdentity, GiveTheBitsOfWorldsThatRunOneAfterTheOther) {
  std::array<std::vector<std::byte>, kWorlds> alone;
  const auto own = std::make_shared<const Hydrodynamics>(slenderShip());
  for (std::size_t i = 0; i < kWorlds; ++i) alone[i] = sail(i, own);
  for (int round = 0; round < 3; ++round) {
    const auto shared = std::make_shared<const Hydrodynamics>(slenderShip());
    std::array<std::vector<std::byte>, kWorlds> together;
    std::latch start(kWorlds);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < kWorlds; ++i) {
      threads.emplace_back([&, i] {
        start.arrive_and_wait();
        together[i] = sail(i, shared);
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < kWorlds; ++i) EXPECT_TRUE(together[i] == alone[i]) << i;
  }
}

}  // namespace
}  // namespace cutwater::test
