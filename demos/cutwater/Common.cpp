#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include "demos/cutwater/Commands.h"
#include "hydro/Errors.h"

namespace cutwater::command {

namespace {

double part(const std::string& range, std::size_t from, std::size_t to) {
  double value = 0.0;
  const char *first = range.data() + from, *last = range.data() + to;
  const auto result = std::from_chars(first, last, value);
  if (result.ec != std::errc() || result.ptr != last || !std::isfinite(value)) {
    throw HydroError(Fault::BadArgument,
                     "--omega " + range + ": must be A:B:N, for instance 0.2:2:37");
  }
  return value;
}

}  // namespace

std::vector<double> omegaList(const std::string& range, const std::vector<double>& fallback) {
  if (range.empty()) return fallback;
  const std::size_t first = range.find(':');
  const std::size_t second = first == std::string::npos ? first : range.find(':', first + 1);
  if (second == std::string::npos) part(range, 0, 0);
  const double from = part(range, 0, first), to = part(range, first + 1, second);
  const double count = part(range, second + 1, range.size());
  if (!(from > 0.0) || to < from || count < 1.0 || count > 100000.0 || count != std::floor(count)) {
    throw HydroError(Fault::BadArgument,
                     "--omega " + range + ": needs 0 < A <= B and a whole number N of values");
  }
  std::vector<double> values;
  const int n = static_cast<int>(count);
  for (int i = 0; i < n; ++i) values.push_back(n == 1 ? from : from + (to - from) * i / (n - 1));
  return values;
}

const std::vector<double>& defaultWaveOmega(const Coefficients& coefficients) {
  return coefficients.waveOmega.empty() ? coefficients.omega : coefficients.waveOmega;
}

void requireZeroSpeed(double speed) {
  if (speed == 0.0) return;
  throw HydroError(Fault::BadArgument,
                   fmt::format("--speed {}: only 0 is possible in this version", speed));
}

double headingRadians(double degrees) {
  if (!(std::abs(degrees) <= 720.0)) {
    throw HydroError(Fault::BadArgument,
                     fmt::format("--heading {}: must be in -720..720 degrees", degrees));
  }
  return degrees * kPi / 180.0;
}

void warn(const std::string& line) {
  if (!line.empty()) fmt::print(stderr, "cutwater: warning: {}\n", line);
}

}  // namespace cutwater::command
