#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

namespace cutwater {

/// How many threads parallelFor uses at most: `asked`, or as many as the machine has if 0 or less.
inline std::size_t workersFor(int asked) {
  const unsigned all =
      asked > 0 ? static_cast<unsigned>(asked) : std::thread::hardware_concurrency();
  return std::max(1u, all);
}

/// Does work(0) … work(count − 1), shared among threads, the caller's among them; each takes the
/// next one that nobody has begun.
///     parallelFor(ships.size(), 0, [&](std::size_t i) { evaluate(ships[i]); });
/// work(i, worker) is called instead where it can be: worker < workersFor(threads) is the number of
/// the thread, the place of its own workspace. The first exception stops what has not begun and is
/// thrown to the caller when all threads have ended. Threads are made and ended within, some 20 µs
/// each: for work of milliseconds or more.
/// @param threads  as of workersFor.
template <class Work>
void parallelFor(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](std::size_t worker) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        if constexpr (std::is_invocable_v<const Work&, std::size_t, std::size_t>)
          work(i, worker);
        else
          work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t t = 1; t < std::min(workersFor(threads), count); ++t)
      others.emplace_back(run, t);
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do the work.
  }
  run(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cutwater
