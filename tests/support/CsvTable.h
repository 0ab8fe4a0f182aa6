#pragma once
#include <map>
#include <string>
#include <vector>

namespace cutwater::test {

/// A reference table: `#` lines are comments, then one header line, then rows. Text cells stay
/// text.
class CsvTable {
 public:
  /// @param path  relative to tests/.
  explicit CsvTable(const std::string& path);
  std::size_t rows() const { return cells_.size(); }
  const std::string& text(std::size_t row, const std::string& column) const;
  /// Not-a-number for an empty cell.
  double number(std::size_t row, const std::string& column) const;

 private:
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace cutwater::test
