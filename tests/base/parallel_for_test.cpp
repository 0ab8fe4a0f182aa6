#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>

#include "hydro/base/ParallelFor.h"

namespace cutwater {
namespace {

TEST(ParallelFor, DoesEveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> calls(100);
    parallelFor(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1) << threads << " threads";
  }
}

TEST(ParallelFor, NothingToDoIsNoCall) {
  parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, NoMoreWorkersThanAskedFor) {
  EXPECT_EQ(workersFor(3), 3u);
  EXPECT_GE(workersFor(0), 1u);
  EXPECT_EQ(workersFor(-1), workersFor(0));
}

// A worker's number is the place of its workspace: no two calls at one time may have the same.
TEST(ParallelFor, AWorkerDoesOneThingAtATime) {
  constexpr int kThreads = 4;
  std::vector<std::atomic<bool>> busy(workersFor(kThreads));
  std::atomic<int> clashes{0};
  parallelFor(200, kThreads, [&](std::size_t, std::size_t worker) {
    ASSERT_LT(worker, busy.size());
    if (busy[worker].exchange(true)) ++clashes;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    busy[worker] = false;
  });
  EXPECT_EQ(clashes, 0);
}

TEST(ParallelFor, OnOneThreadTheOrderIsThatOfTheIndices) {
  std::vector<std::size_t> order;
  parallelFor(5, 1, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(ParallelFor, TheFirstExceptionStopsTheRestAndIsThrown) {
  for (const int threads : {1, 3}) {
    std::atomic<int> begun{0};
    const auto work = [&](std::size_t i) {
      ++begun;
      if (i == 5) throw std::runtime_error("index 5");
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    };
    try {
      parallelFor(100000, threads, work);
      FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "index 5");
    }
    EXPECT_LT(begun, 100000) << threads << " threads";
  }
}

}  // namespace
}  // namespace cutwater
