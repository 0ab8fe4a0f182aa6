#pragma once
#include <string>
#include <vector>

namespace cutwater::command {

/// A table `name,value,unit`: aligned for people where it goes to a terminal, else CSV.
class Listing {
 public:
  struct Row {
    std::string name, value, unit;
  };

  /// Line breaks of `value` are written as "; ", other control characters as \xNN.
  void add(const std::string& name, const std::string& value, const std::string& unit = "");
  void add(const std::string& name, double value, const std::string& unit = "");
  const std::vector<Row>& rows() const noexcept { return rows_; }

  std::string csv() const;      ///< with its line of names; values with commas in quotes
  std::string aligned() const;  ///< for people: three columns, long values folded
  /// The CSV to `path`; to stdout if `path` is empty, aligned if that is a terminal.
  /// @throws HydroError FileNotWritable.
  void write(const std::string& path) const;

 private:
  std::vector<Row> rows_;
};

}  // namespace cutwater::command
