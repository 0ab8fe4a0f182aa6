#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cutwater {

/// work(0) … work(count − 1), shared out among threads, the caller's among them; the first exception
/// stops what has not begun and comes out of here. For work that begins now and then: threads are made
/// and ended within. bem's, which needs OpenMP's threads, is bem/Parallel.h.
/// @param threads  0: as many as the machine has.
template <class Work>
void shareOut(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i; (i = next++) < count;) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t all = threads > 0 ? threads : std::thread::hardware_concurrency();
  std::vector<std::thread> pool;
  for (std::size_t t = 1; t < std::min(all, count); ++t) pool.emplace_back(run);
  run();
  for (std::thread& thread : pool) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cutwater
