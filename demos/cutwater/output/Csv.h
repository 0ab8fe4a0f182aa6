#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "demos/cutwater/output/OutputFile.h"
#include "hydro/Conventions.h"
#include "hydro/base/CsvRow.h"

namespace cutwater::command {

/// A CSV table in memory: one header line, then rows; written whole or not at all.
class Csv {
 public:
  explicit Csv(const std::string& header) : text_(header + "\n") {}
  /// A line of numbers, 9 significant digits; `prefix` (with its comma) goes before them.
  void row(const std::vector<double>& values, const std::string& prefix = "");
  /// A line as it is.
  void line(const std::string& text) { text_ += text + "\n"; }
  /// writeText of the whole.
  void write(const std::string& path) const { writeText(text_, path); }

 private:
  std::string text_;
};

/// arg z in degrees, in (-180, 180] as csvNumber writes it.
double phaseDegrees(Complex z);

}  // namespace cutwater::command
