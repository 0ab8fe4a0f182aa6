#include "demos/report_page/Json.h"

#include <fmt/format.h>

#include <cmath>

#include "hydro/base/CsvRow.h"

namespace cutwater::page {

namespace {

std::string quoted(std::string_view words) {
  std::string text = "\"";
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text += {'\\', c};
    } else if (byte < 0x20 || c == '<') {
      text += fmt::format("\\u{:04x}", byte);
    } else {
      text += c;
    }
  }
  return text + '"';
}

}  // namespace

void Json::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

Json& Json::begin(char open, char close) {
  separate();
  text_ += open;
  ends_.push_back(close);
  first_ = true;
  return *this;
}

Json& Json::end() {
  text_ += ends_.back();
  ends_.pop_back();
  first_ = false;
  return *this;
}

Json& Json::key(std::string_view name) {
  separate();
  text_ += quoted(name) + ':';
  first_ = true;  // no comma before its value
  return *this;
}

Json& Json::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

Json& Json::value(double number) {
  return raw(std::isfinite(number) ? csvNumber(number) : std::string("null"));
}

Json& Json::value(std::string_view words) { return raw(quoted(words)); }

Json& Json::list(std::span<const double> numbers) {
  beginArray();
  for (const double number : numbers) value(number);
  return end();
}

}  // namespace cutwater::page
