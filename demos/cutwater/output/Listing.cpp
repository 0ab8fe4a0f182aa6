#include "demos/cutwater/output/Listing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "demos/cutwater/output/Messages.h"
#include "demos/cutwater/output/OutputFile.h"
#include "hydro/base/CsvRow.h"

namespace cutwater::command {

namespace {

constexpr std::size_t kValueColumns = 60;  // of a terminal; longer values go on below

// `text` in pieces of at most kValueColumns, parted at blanks where there are some.
std::vector<std::string> folded(std::string_view text) {
  std::vector<std::string> pieces;
  while (text.size() > kValueColumns) {
    const std::size_t blank = text.rfind(' ', kValueColumns);
    const std::size_t end = blank == std::string_view::npos || blank == 0 ? kValueColumns : blank;
    pieces.emplace_back(text.substr(0, end));
    text.remove_prefix(end + (end == blank ? 1 : 0));
  }
  pieces.emplace_back(text);
  return pieces;
}

// Texts of a file, perhaps of another code.
std::string inOneLine(std::string text) {
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2)
    text.replace(i, 1, "; ");
  return printable(text, text.size());
}

// Of 4595557 "4 595 557".
std::string inThousands(std::string digits) {
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  for (std::size_t i = digits.size(); i > first + 3;) digits.insert(i -= 3, 1, ' ');
  return digits;
}

bool isNumber(const std::string& value, double& number) {
  char* end = nullptr;
  number = std::strtod(value.c_str(), &end);
  return !value.empty() && *end == '\0';
}

// Numbers as people read them: six digits tell a ship, and what is left of a zero is none.
std::string forPeople(const std::string& value) {
  double number = 0.0;
  if (!isNumber(value, number) || !std::isfinite(number)) return value;
  constexpr double kNothing = 1e-12, kSmall = 1e-4, kLong = 1e5, kMost = 1e15;
  const double size = std::abs(number);
  if (size < kNothing) return "0";
  if (size >= kLong && size < kMost) return inThousands(fmt::format("{:.0f}", number));
  return size < kSmall ? fmt::format("{:.3g}", number) : fmt::format("{:.6g}", number);
}

}  // namespace

void Listing::add(const std::string& name, const std::string& value, const std::string& unit) {
  rows_.push_back({name, value, unit});
}

void Listing::add(const std::string& name, double value, const std::string& unit) {
  rows_.push_back({name, csvNumber(value), unit});
}

std::string Listing::csv() const {
  std::string text = "name,value,unit\n";
  for (const Row& row : rows_) {
    const bool inQuotes = row.value.find_first_of(",\"\n") != std::string::npos;
    std::string cell = inOneLine(row.value);
    for (std::size_t i = 0; inQuotes && (i = cell.find('"', i)) != std::string::npos; i += 2)
      cell.replace(i, 1, "\"\"");
    if (inQuotes) cell = "\"" + cell + "\"";
    text += row.name + "," + cell + "," + row.unit + "\n";
  }
  return text;
}

std::string Listing::aligned() const {
  std::size_t name = 0;
  for (const Row& row : rows_) name = std::max(name, row.name.size());
  std::string text;
  for (const Row& row : rows_) {
    const std::vector<std::string> pieces = folded(forPeople(inOneLine(row.value)));
    double number = 0.0;  // words have no unit
    const std::string unit = isNumber(row.value, number) && !row.unit.empty() ? " " + row.unit : "";
    for (const std::string& piece : pieces) {
      const bool first = &piece == &pieces.front(), last = &piece == &pieces.back();
      text += fmt::format("{:<{}}  {}{}\n", first ? row.name : "", name, piece, last ? unit : "");
    }
  }
  return text;
}

void Listing::write(const std::string& path) const {
  const bool people = path.empty() && ::isatty(STDOUT_FILENO) != 0;
  writeText(people ? aligned() : csv(), path);
}

}  // namespace cutwater::command
