#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include "demos/cutwater/commands/Commands.h"
#include "hydro/Errors.h"
#include "hydro/base/EnumNames.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::command {

namespace {

constexpr double kFarthest = 1e6;  // [m]

/// The finite number that text[from, to) is.
std::optional<double> number(const std::string& text, std::size_t from, std::size_t to) {
  double value = 0.0;
  const char *first = text.data() + from, *last = text.data() + to;
  const auto result = std::from_chars(first, last, value);
  if (result.ec != std::errc() || result.ptr != last || !std::isfinite(value)) return {};
  return value;
}

/// "A:B:N" of an option.
struct Range {
  double from, to, count;
  /// N values with both ends, if N is a whole number and A <= B.
  std::optional<std::vector<double>> values() const {
    if (to < from || count < 1.0 || count > 100000.0 || count != std::floor(count)) return {};
    std::vector<double> list;
    const int n = static_cast<int>(count);
    for (int i = 0; i < n; ++i) list.push_back(n == 1 ? from : from + (to - from) * i / (n - 1));
    return list;
  }
};

Range rangeOf(const std::string& option, const std::string& text, const std::string& example) {
  const auto part = [&](std::size_t from, std::size_t to) {
    const auto value = number(text, from, to);
    if (!value)
      throw UsageError(option + " " + shortened(text) + ": must be A:B:N, for instance " + example);
    return *value;
  };
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos) part(0, 0);
  return {part(0, first), part(first + 1, second), part(second + 1, text.size())};
}

// The report's form needs x-derivatives, and holds ahead only.
void requireReportForm(const std::string& path, const SpeedOptions& moving,
                       const Coefficients& coefficients) {
  if (moving.speed < 0.0) {
    throw UsageError(
        fmt::format("--speed {}: astern with --form tuck only, as the report's form of "
                    "the speed terms drives a ship astern",
                    moving.speed));
  }
  if (coefficients.addedMassX.empty() && moving.speed != 0.0) {
    throw HydroError(Fault::DatabaseIncomplete,
                     path +
                         ": --form report needs x-derivatives, which are not in the file; solve "
                         "with forward_speed = \"report\"");
  }
}

}  // namespace

ForwardSpeedForm SpeedOptions::form(const CoefficientTables& coefficients) const {
  return fromName<ForwardSpeedForm>(kForwardSpeedNames, formName)
      .value_or(coefficients.forwardSpeed);
}

std::vector<double> omegaList(const std::string& range, const std::vector<double>& fallback) {
  if (range.empty()) return fallback;
  const Range omega = rangeOf("--omega", range, "0.2:2:37");
  const auto values = omega.values();
  if (!values || !(omega.from > 0.0))
    throw UsageError("--omega " + shortened(range) +
                     ": needs 0 < A <= B and a whole number N of values");
  return *values;
}

std::vector<double> rangeOption(const std::string& option, const std::string& text, double largest,
                                const std::string& example) {
  const Range range = rangeOf(option, text, example);
  const auto values = range.values();
  if (!values || range.from < -largest || range.to > largest)
    throw UsageError(fmt::format("{} {}: needs {} <= A <= B <= {} and a whole number N of values",
                                 option, shortened(text), -largest, largest));
  return *values;
}

Coefficients readDatabase(const std::string& path, const SpeedOptions& moving) {
  if (!(std::abs(moving.speed) <= 100.0)) {
    throw UsageError(fmt::format("--speed {}: must be in -100..100 m/s", moving.speed));
  }
  std::string warning;
  Coefficients coefficients = readCoefficients(path, &warning);
  warn(warning);
  if (moving.form(coefficients) == ForwardSpeedForm::Report)
    requireReportForm(path, moving, coefficients);
  return coefficients;
}

Vec3 vectorOption(const std::string& option, const std::string& text) {
  const std::size_t first = text.find(',');
  const std::size_t second = first == std::string::npos ? first : text.find(',', first + 1);
  const auto refuse = [&] {
    throw UsageError(option + " " + shortened(text) +
                     ": must be three numbers X,Y,Z, for instance -2.4,0,1.3");
  };
  if (second == std::string::npos) refuse();
  const std::size_t from[] = {0, first + 1, second + 1}, to[] = {first, second, text.size()};
  Vec3 vector;
  for (int i = 0; i < 3; ++i) {
    const auto value = number(text, from[i], to[i]);
    if (!value) refuse();
    if (std::abs(*value) > kFarthest)
      throw UsageError(
          fmt::format("{} {}: must be within {} m", option, shortened(text), kFarthest));
    vector[i] = *value;
  }
  return vector;
}

void requireMemory(const std::string& what, double bytes) {
  const double here =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (here <= 0.0 || bytes <= 0.75 * here) return;
  throw HydroError(Fault::ValueOutOfRange,
                   fmt::format("{}: needs about {:.3g} GB of memory, this machine has {:.3g} GB",
                               what, 1e-9 * bytes, 1e-9 * here));
}

double headingRadians(double degrees) {
  if (!(std::abs(degrees) <= 720.0)) {
    throw UsageError(fmt::format("--heading {}: must be in -720..720 degrees", degrees));
  }
  return degrees * kPi / 180.0;
}

}  // namespace cutwater::command
