#include "demos/cutwater/output/Listing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

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

// Numbers as people read them: six digits tell a ship.
std::string shortNumber(const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const bool whole = value.find_first_of(".e") == std::string::npos;
  if (value.empty() || *end != '\0' || whole) return value;
  return fmt::format("{:.6g}", number);
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
    const std::vector<std::string> pieces = folded(shortNumber(inOneLine(row.value)));
    for (const std::string& piece : pieces) {
      const bool first = &piece == &pieces.front(), last = &piece == &pieces.back();
      text += fmt::format("{:<{}}  {}{}\n", first ? row.name : "", name, piece,
                          last && !row.unit.empty() ? " " + row.unit : "");
    }
  }
  return text;
}

void Listing::write(const std::string& path) const {
  const bool people = path.empty() && ::isatty(STDOUT_FILENO) != 0;
  writeText(people ? aligned() : csv(), path);
}

}  // namespace cutwater::command
