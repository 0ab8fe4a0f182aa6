#include <gtest/gtest.h>

#include <array>

#include "plugin/ThreadPool.h"

CUTWATER_PLUGIN_BEGIN
namespace {

struct Counts {
  std::array<std::atomic<int>, 1000> done{};
};

TEST(ThreadPool, DoesEachPieceOfWorkOnceInEveryRound) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    Counts counts;
    for (int round = 0; round < 50; ++round) {
      pool.run(
          counts.done.size(),
          [](void* context, std::size_t i) { ++static_cast<Counts*>(context)->done[i]; }, &counts);
      for (const auto& count : counts.done) ASSERT_EQ(count.load(), round + 1);
    }
  }
}

TEST(ThreadPool, NoWorkReturnsAtOnce) {
  ThreadPool pool(3);
  pool.run(
      0, [](void*, std::size_t) { FAIL(); }, nullptr);
}

}  // namespace
CUTWATER_PLUGIN_END
