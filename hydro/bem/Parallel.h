#pragma once
#include <exception>
#include <functional>
#include <mutex>

namespace cutwater {

/// work(0) … work(count − 1), shared out among threads; the first exception stops what has not
/// begun and comes out of here.  @param threads ≥ 1.
inline void parallelFor(int count, int threads, const std::function<void(int)>& work) {
  std::exception_ptr failure;
  std::mutex guard;
  const auto stopped = [&] {
    const std::lock_guard lock(guard);
    return failure != nullptr;
  };
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (int i = 0; i < count; ++i) {
    if (stopped()) continue;
    try {
      work(i);
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cutwater
