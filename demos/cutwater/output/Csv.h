#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/base/CsvRow.h"

namespace cutwater::command {

/// Writes `text` to stdout if `path` is empty; to a regular file (or what a link points at) under a
/// temporary name first, then renamed; to a device or pipe as it is.
/// @throws HydroError FileNotWritable.
void writeText(const std::string& text, const std::string& path);

/// Refuses a file that cannot be written, before work whose result it is to hold. @throws as
/// writeText.
void requireWritable(const std::string& path);

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
