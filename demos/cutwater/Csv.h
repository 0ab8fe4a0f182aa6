#pragma once
#include <initializer_list>
#include <string>
#include <vector>

namespace cutwater::command {

/// A CSV table in memory: one header line, then rows; written whole or not at all.
class Csv {
 public:
  explicit Csv(const std::string& header) : text_(header + "\n") {}
  /// A line of numbers, 9 significant digits; `prefix` (with its comma) goes before them.
  void row(const std::vector<double>& values, const std::string& prefix = "");
  /// A line as it is.
  void line(const std::string& text) { text_ += text + "\n"; }
  /// To `path` through a temporary name beside it, or to stdout if `path` is empty.
  /// @throws HydroError FileNotWritable.
  void write(const std::string& path) const;

 private:
  std::string text_;
};

/// A number as all our CSV files write it: 9 significant digits, `inf`, `nan`.
std::string csvNumber(double value);

}  // namespace cutwater::command
