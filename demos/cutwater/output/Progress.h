#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace cutwater::command {

/// Progress of long work with the time left, on stderr: on a terminal one line, rewritten at most
/// five times a second. Any thread may call.
///     Progress progress("sweep", Progress::Elsewhere::Nothing);
///     for (...) progress.show(++done, total);
/// The line ends with the object, before anything else is said.
class Progress {
 public:
  /// What a stderr that is no terminal gets.
  enum class Elsewhere {
    Lines,   ///< a line every ten seconds, as the log of work of minutes wants
    Nothing  ///< of work that seldom takes so long
  };
  explicit Progress(std::string what, Elsewhere elsewhere);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done  of `total`; the first call says what was done before.
  /// @param line  the whole line instead of "what: done/total, 3 s, 5 s left", of the seconds spent
  ///              and left; asked only when it is written.
  using Line = std::function<std::string(double elapsed, double left)>;
  void show(int done, int total, const Line& line = {});

 private:
  using Clock = std::chrono::steady_clock;
  bool due(bool last, Clock::time_point now) const;

  std::string what_;
  bool terminal_, silent_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  int before_ = -1;
  bool shown_ = false;
};

}  // namespace cutwater::command
