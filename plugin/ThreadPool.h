#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Shares the ships of a tick among threads that wait between ticks. Debian's Bullet is built
/// without threads of its own. run() allocates nothing.
class ThreadPool {
 public:
  /// @param threads  in all, the caller's among them; ≥ 1.
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned threads() const noexcept { return static_cast<unsigned>(workers_.size()) + 1; }
  /// work(context, i) for i = 0 … count − 1, each once, on any thread; returns when all are done.
  void run(std::size_t count, void (*work)(void* context, std::size_t i), void* context) noexcept;

 private:
  void wait();
  void takeAll() noexcept;

  std::mutex mutex_;
  std::condition_variable begin_, end_;
  std::size_t round_ = 0;  // guarded by mutex_
  std::size_t busy_ = 0;   // workers that have not finished the round; guarded by mutex_
  bool stopping_ = false;  // guarded by mutex_
  std::size_t count_ = 0;  // of the round; set while no worker is busy
  void (*work_)(void*, std::size_t) = nullptr;
  void* context_ = nullptr;
  std::atomic<std::size_t> next_{0};
  std::vector<std::thread> workers_;
};

CUTWATER_PLUGIN_END
