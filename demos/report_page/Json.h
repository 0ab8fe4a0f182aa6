#pragma once
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cutwater::page {

/// JSON text, written from front to back:
///     Json json;
///     json.beginObject().field("n", 3).key("omega").list(omega).end();
///     json.text();  // {"n":3,"omega":[0.1,0.2,0.3]}
/// `<` is written as \u003c, so that the text may stand inside a script element. Numbers have 9
/// significant digits, as in CSV; what is not finite is null.
class Json {
 public:
  Json& beginObject() { return begin('{', '}'); }
  Json& beginArray() { return begin('[', ']'); }
  /// Ends the innermost object or array.
  Json& end();
  Json& key(std::string_view name);

  Json& value(double number);
  Json& value(std::integral auto number) { return raw(std::to_string(number)); }
  Json& value(bool truth) { return raw(truth ? "true" : "false"); }
  Json& value(std::string_view words);
  Json& value(const char* words) { return value(std::string_view(words)); }
  Json& value(const std::string& words) { return value(std::string_view(words)); }
  Json& null() { return raw("null"); }
  /// Text that is JSON already.
  Json& raw(std::string_view json);
  Json& list(std::span<const double> numbers);

  template <class Value>
  Json& field(std::string_view name, const Value& value) {
    return key(name).value(value);
  }

  const std::string& text() const noexcept { return text_; }

 private:
  Json& begin(char open, char close);
  void separate();

  std::string text_;
  std::vector<char> ends_;  // what closes the objects and arrays that are open
  bool first_ = true;       // nothing stands yet in the innermost one
};

}  // namespace cutwater::page
