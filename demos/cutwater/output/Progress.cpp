#include "demos/cutwater/output/Progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace cutwater::command {

namespace {

// A line that is too long for the terminal would go on below, and each one after it too.
std::string cutToTerminal(std::string line) {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 &&
      line.size() >= size.ws_col)
    line.resize(size.ws_col - 1U);
  return line;
}

}  // namespace

Progress::Progress(std::string what, Elsewhere elsewhere)
    : what_(std::move(what)),
      terminal_(::isatty(STDERR_FILENO) != 0),
      silent_(!terminal_ && elsewhere == Elsewhere::Nothing) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputc('\n', stderr);
}

bool Progress::due(bool last, Clock::time_point now) const {
  const std::chrono::duration<double> sinceLast = now - last_;
  return last || sinceLast.count() >= (terminal_ ? 0.2 : 10.0);
}

void Progress::show(int done, int total, const Line& line) {
  if (silent_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = Clock::now();
  if (before_ < 0) {
    before_ = done;
    start_ = last_ = now;
  }
  if (!due(done >= total, now)) return;
  last_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const int since = done - before_;
  const double left = since > 0 ? elapsed * (total - done) / since : 0.0;
  const std::string text =
      line ? line(elapsed, left)
           : fmt::format("{}: {}/{}, {:.0f} s, {:.0f} s left", what_, done, total, elapsed, left);
  // A stderr that is closed or full stops no work.
  std::fputs((terminal_ ? "\r\x1b[K" + cutToTerminal(text) : text + "\n").c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace cutwater::command
