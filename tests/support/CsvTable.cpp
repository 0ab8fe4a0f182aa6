#include "tests/support/CsvTable.h"

#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace cutwater::test {

namespace {
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}
}  // namespace

CsvTable::CsvTable(const std::string& path) {
  std::ifstream file(std::string(CUTWATER_TEST_DATA) + "/" + path);
  if (!file) throw std::runtime_error("no reference table tests/" + path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto row = split(line);
    if (columns_.empty()) {
      for (std::size_t i = 0; i < row.size(); ++i) columns_[row[i]] = i;
    } else {
      cells_.push_back(row);
    }
  }
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  return cells_.at(row).at(columns_.at(column));
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  const auto& cells = cells_.at(row);
  const std::size_t index = columns_.at(column);
  if (index >= cells.size() || cells[index].empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::stod(cells[index]);
}

}  // namespace cutwater::test
