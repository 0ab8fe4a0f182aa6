#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace cutwater::command {

/// Progress of long work with the time left, on stderr: one line rewritten on a terminal, else a
/// line every ten seconds. Any thread may call.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}
  ~Progress();
  /// @param done  of `total`; the first call says what was done before.
  void show(int done, int total);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  int before_ = -1;
  bool shown_ = false;
};

}  // namespace cutwater::command
