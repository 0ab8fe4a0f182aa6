#include "hydro/files/TextScanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace cutwater {
namespace {

constexpr std::string_view kBetweenWords = " \t\r,";

std::optional<double> number(std::string word) {
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == 'd' || c == 'D' || c == 'E'; }, 'e');
  if (word.starts_with("+-")) return std::nullopt;
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* last = word.data() + word.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (end != last || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc()) return value;
  const bool tooSmall = word.find("e-") != std::string::npos;
  return tooSmall ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace

bool TextScanner::nextLine() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  if (comment_ != '\0') line_ = line_.substr(0, line_.find(comment_));
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++lineNumber_;
  return true;
}

std::string TextScanner::wordInLine() {
  const std::size_t begin = line_.find_first_not_of(kBetweenWords);
  if (begin == std::string_view::npos) return {};
  line_.remove_prefix(begin);
  const std::size_t end = std::min(line_.find_first_of(kBetweenWords), line_.size());
  const std::string word(line_.substr(0, end));
  line_.remove_prefix(end);
  return word;
}

std::string TextScanner::nextWord() {
  std::string word = wordInLine();
  while (word.empty() && nextLine()) word = wordInLine();
  return word;
}

double TextScanner::next(const char* what) {
  const std::string word = nextWord();
  if (word.empty()) fail(std::string("the file ends before ") + what);
  const std::optional<double> value = number(word);
  if (!value) {
    std::string shown = word.substr(0, 40);
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    fail("'" + shown + "' is not a number (" + what + ")");
  }
  return *value;
}

double TextScanner::nextRecord(const char* what) {
  if (!nextLine()) fail(std::string("the file ends before ") + what);
  return next(what);
}

int TextScanner::nextCount(const char* what, double most) {
  const double value = next(what);
  if (!(value >= 0 && value <= most) || value != std::floor(value))
    fail(std::string(what) + " is " + std::to_string(value) +
         ", not a count, or more than the file can hold");
  return static_cast<int>(value);
}

void TextScanner::fail(const std::string& what, Fault fault) const {
  throw HydroError(fault, name_ + ": line " + std::to_string(lineNumber_) + ": " + what);
}

}  // namespace cutwater
