#include "demos/cutwater/output/Progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace cutwater::command {

Progress::~Progress() {
  if (shown_ && isatty(STDERR_FILENO) != 0) std::fputc('\n', stderr);
}

void Progress::show(int done, int total) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (before_ < 0) {
    before_ = done;
    start_ = last_ = Clock::now();
  }
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto now = Clock::now();
  const std::chrono::duration<double> sinceLast = now - last_, elapsed = now - start_;
  if (done < total && sinceLast.count() < (terminal ? 0.2 : 10.0)) return;
  last_ = now;
  shown_ = true;
  const int since = done - before_;
  const double left = since > 0 ? elapsed.count() * (total - done) / since : 0.0;
  const std::string line =
      fmt::format("{}{}: {}/{}, {:.0f} s, {:.0f} s left{}", terminal ? "\r\x1b[K" : "", what_, done,
                  total, elapsed.count(), left, terminal ? "" : "\n");
  std::fputs(line.c_str(), stderr);  // a stderr that is closed or full stops no work
  std::fflush(stderr);
}

}  // namespace cutwater::command
