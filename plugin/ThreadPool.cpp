#include "plugin/ThreadPool.h"

CUTWATER_PLUGIN_BEGIN

ThreadPool::ThreadPool(unsigned threads) {
  for (unsigned i = 1; i < threads; ++i) workers_.emplace_back([this] { wait(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  begin_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::takeAll() noexcept {
  for (std::size_t i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;)
    work_(context_, i);
}

void ThreadPool::wait() {
  std::size_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    begin_.wait(lock, [&] { return stopping_ || round_ != seen; });
    if (stopping_) return;
    seen = round_;
    lock.unlock();
    takeAll();
    lock.lock();
    if (--busy_ == 0) end_.notify_one();
  }
}

void ThreadPool::run(std::size_t count, void (*work)(void*, std::size_t), void* context) noexcept {
  work_ = work;
  context_ = context;
  count_ = count;
  next_.store(0, std::memory_order_relaxed);
  if (workers_.empty() || count < 2) {
    takeAll();
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    busy_ = workers_.size();
    ++round_;
  }
  begin_.notify_all();
  takeAll();
  std::unique_lock lock(mutex_);
  end_.wait(lock, [this] { return busy_ == 0; });
}

CUTWATER_PLUGIN_END
