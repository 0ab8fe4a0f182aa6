#pragma once
#include <string>
#include <string_view>

#include "hydro/Errors.h"

namespace cutwater {

/// Reads words and numbers from a text, and names the line of whatever is wrong. Commas count as
/// blanks, Fortran's 1.0D+00 as a number; one too small for a double is 0, one too large infinite.
class TextScanner {
 public:
  /// @param text     must outlive the scanner.  @param name  of the file, for messages.
  /// @param comment  the rest of a line after this character is skipped; '\0': none.
  TextScanner(std::string_view text, std::string name, char comment = '\0')
      : rest_(text), name_(std::move(name)), comment_(comment) {}

  /// False at the end of the file.
  bool nextLine();
  /// The next word of this or later lines; empty at the end of the file.
  std::string nextWord();
  /// The next word of this line; empty at its end.
  std::string wordInLine();
  /// The next number of this or later lines.  @param what  is named if there is none.
  double next(const char* what);
  /// The next number from a new line.
  double nextRecord(const char* what);
  /// A whole number from 0 to `most`.
  int nextCount(const char* what, double most);
  /// Skips what is left of this line.
  void endRecord() { line_ = {}; }
  /// All that follows this line.
  std::string_view rest() const { return rest_; }
  [[noreturn]] void fail(const std::string& what, Fault fault = Fault::FileMalformed) const;

 private:
  std::string_view rest_, line_;
  std::string name_;
  char comment_;
  int lineNumber_ = 0;
};

}  // namespace cutwater
