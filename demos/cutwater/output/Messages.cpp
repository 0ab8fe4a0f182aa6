#include "demos/cutwater/output/Messages.h"

#include <fmt/format.h>

#include <cstdio>

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

void warn(const std::string& line) {
  if (!line.empty()) fmt::print(stderr, "cutwater: warning: {}\n", line);
}

}  // namespace cutwater::command
