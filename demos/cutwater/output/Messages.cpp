#include "demos/cutwater/output/Messages.h"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <set>

#include "hydro/Errors.h"
#include "hydro/memory/Resonances.h"

namespace cutwater::command {

void naming(const std::string& file, const std::function<void()>& work) {
  try {
    work();
  } catch (const HydroError& error) {
    throw HydroError(error.fault(), file + ": " + error.what());
  }
}

void warnIfUnresolved(const std::string& file, const Coefficients& coefficients, double omega) {
  const double resolved = coefficients.resolvedOmega;
  if (!(resolved > 0.0) || omega <= resolved * (1.0 + 1e-9)) return;
  warn(fmt::format("{}: panels resolve waves up to {:.2f} rad/s, these go up to {:.2f}", file,
                   resolved, omega));
}

void warnOfResonances(const std::string& file, const Coefficients& coefficients) {
  const std::string line = resonanceWarning(coefficients);
  if (!line.empty()) warn(file + ": " + line);
}

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  for (std::size_t i = 0; i < text.size() && i < most; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    // In UTF-8 the control characters from U+0080 on are C2 80 to C2 9F.
    const bool control = byte < 0x20 || byte == 0x7F || (byte == 0xC2 && next < 0xA0);
    shown += control ? fmt::format("\\x{:02x}", byte) : std::string(1, text[i]);
  }
  if (text.size() > most) shown += fmt::format("... ({} characters)", text.size());
  return shown;
}

void say(const std::string& line) {
  const std::string shown = printable(line) + "\n";
  std::fputs(shown.c_str(), stderr);
}

void warn(const std::string& line) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard<std::mutex> lock(mutex);
  if (!line.empty() && said.insert(line).second) say("cutwater: warning: " + line);
}

}  // namespace cutwater::command
