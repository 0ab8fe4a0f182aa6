#pragma once
#include <initializer_list>
#include <span>
#include <string>

namespace cutwater {

/// Numbers as all CSV files write them: 9 significant digits, `inf`, `nan`, no `-0`, and a point in
/// every locale.
///     std::string text = "t,heave\n";
///     addCsvRow(text, {0.02, -1.5});  // "0.02,-1.5\n"
std::string csvNumber(double value);

/// Adds one line.
void addCsvRow(std::string& text, std::span<const double> row);
inline void addCsvRow(std::string& text, std::initializer_list<double> row) {
  addCsvRow(text, std::span(row.begin(), row.size()));
}

}  // namespace cutwater
