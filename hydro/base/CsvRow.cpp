#include "hydro/base/CsvRow.h"

#include <charconv>
#include <cmath>

namespace cutwater {

namespace {

void add(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";  // to_chars writes the sign of a NaN
    return;
  }
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value == 0.0 ? 0.0 : value,
                                 std::chars_format::general, 9);
  text.append(digits, end.ptr);
}

}  // namespace

std::string csvNumber(double value) {
  std::string text;
  add(text, value);
  return text;
}

void addCsvRow(std::string& text, std::span<const double> row) {
  const char* between = "";
  for (const double value : row) {
    text += between;
    add(text, value);
    between = ",";
  }
  text += '\n';
}

}  // namespace cutwater
