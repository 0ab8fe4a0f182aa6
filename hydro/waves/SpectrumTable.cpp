#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "hydro/Errors.h"
#include "hydro/waves/Spectrum.h"

namespace cutwater {

namespace {

constexpr std::size_t kMostShown = 40;  // characters of a line that a message quotes

// Without blanks at its ends, a line end of other systems among them.
std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

[[noreturn]] void refuseLine(const std::string& path, std::size_t line, const std::string& what) {
  throw HydroError(Fault::FileMalformed, path + ": line " + std::to_string(line) + ": " + what);
}

std::optional<double> numberIn(std::string_view text) {
  text = trimmed(text);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
  return value;
}

void readPoint(const std::string& path, std::size_t line, std::string_view text,
               SpectrumTable& table) {
  const std::string shown(text.substr(0, kMostShown));
  const auto comma = text.find(',');
  const auto omega = numberIn(text.substr(0, comma));
  const auto density =
      comma == std::string_view::npos ? std::optional<double>() : numberIn(text.substr(comma + 1));
  if (!omega || !density)
    refuseLine(path, line, "\"" + shown + "\": must be two numbers, omega [rad/s] and S [m2 s]");
  if (!(*omega >= 0.0 && std::isfinite(*omega)))
    refuseLine(path, line, "\"" + shown + "\": omega must be finite and 0 or more");
  if (!table.omega.empty() && !(*omega > table.omega.back()))
    refuseLine(path, line, "\"" + shown + "\": omega must be above that of the line before");
  if (!(*density >= 0.0 && std::isfinite(*density)))
    refuseLine(path, line, "\"" + shown + "\": S must be finite and 0 or more");
  table.omega.push_back(*omega);
  table.density.push_back(*density);
}

}  // namespace

SpectrumTable readSpectrumTable(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw HydroError(Fault::FileNotReadable, path + ": cannot be read");
  SpectrumTable table;
  bool named = false, energy = false;
  std::size_t line = 0;
  for (std::string read; std::getline(in, read);) {
    ++line;
    const std::string_view text = trimmed(read);
    if (text.empty() || text.front() == '#') continue;
    if (!named) {
      const auto comma = text.find(',');
      named = comma != std::string_view::npos && trimmed(text.substr(0, comma)) == "omega" &&
              trimmed(text.substr(comma + 1)) == "S";
      if (!named)
        refuseLine(path, line,
                   "\"" + std::string(text.substr(0, kMostShown)) +
                       "\": must be the names of the columns, omega,S");
      continue;
    }
    readPoint(path, line, text, table);
    energy = energy || table.density.back() > 0.0;
  }
  if (table.omega.size() < 2) refuseLine(path, line, "ends; a spectrum needs two points or more");
  if (!energy) refuseLine(path, line, "ends; all S are 0");
  return table;
}

}  // namespace cutwater
