#include "hydro/files/ColladaCheck.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

constexpr std::string_view kXmlBlank = " \t\r\n";

struct Tag {
  std::string_view name, attributes;
  std::string_view content;  ///< up to the next tag
  std::size_t byte = 0;
  bool closes = false;  ///< </name>, whose name is left empty, or <name/>
};

class ColladaChecker {
 public:
  ColladaChecker(const std::string& text, const std::string& name) : text_(text), name_(name) {}

  void check() {
    Tag tag;
    while (next(tag)) {
      if (tag.name == "float_array") addArray(tag);
      if (tag.name == "accessor") accessors_.push_back(tag);
      if (tag.name == "polylist" || tag.name == "triangles" || tag.name == "polygons" ||
          tag.name == "vcount")
        attribute(tag, "count", 0);
      if (tag.closes) continue;
      if (tag.name == "p" || tag.name == "vcount" || tag.name == "v" || tag.name == "h")
        checkNumbers(tag, "0123456789- \t\r\n");
    }
    for (const Tag& a : accessors_) checkAccessor(a);
  }

 private:
  [[noreturn]] void fail(const Tag& tag, const std::string& what) const {
    throw HydroError(Fault::FileMalformed, name_ + ": <" + std::string(tag.name.substr(0, 40)) +
                                               "> at byte " + std::to_string(tag.byte) + " " +
                                               what);
  }

  bool next(Tag& tag) {
    const std::size_t open = text_.find('<', at_);
    if (open == std::string::npos) return false;
    const std::size_t close = text_.find('>', open);
    if (close == std::string::npos) return false;
    std::string_view inside = std::string_view(text_).substr(open + 1, close - open - 1);
    tag.byte = open;
    tag.closes = inside.starts_with('/') || inside.ends_with('/');
    const std::size_t end = std::min(inside.find_first_of(" \t\r\n/"), inside.size());
    tag.name = inside.substr(0, end);
    tag.attributes = inside.substr(end);
    at_ = close + 1;
    const std::size_t stop = std::min(text_.find('<', at_), text_.size());
    tag.content = std::string_view(text_).substr(at_, stop - at_);
    return true;
  }

  /// Only these characters up to the closing tag itself.
  void checkNumbers(const Tag& tag, std::string_view allowed) const {
    const std::size_t end = at_ + tag.content.size();
    if (tag.content.find_first_not_of(allowed) != std::string_view::npos ||
        text_.compare(end, 2, "</") != 0)
      fail(tag, "holds something else than numbers");
  }

  /// Value of a whole-number attribute, `otherwise` if it is not there.
  double attribute(const Tag& tag, std::string_view name, double otherwise) const {
    const std::string text = attributeText(tag, name);
    if (text.empty()) return otherwise;
    if (text.find_first_not_of("0123456789") != std::string::npos || text.size() > 9)
      fail(tag, std::string(name) + " = \"" + text.substr(0, 40) + "\" is not a count");
    return std::stod(text);
  }

  std::string attributeText(const Tag& tag, std::string_view name) const {
    for (std::size_t at = tag.attributes.find(name); at != std::string_view::npos;
         at = tag.attributes.find(name, at + 1)) {
      std::string_view after = tag.attributes.substr(at + name.size());
      if (at == 0 || kXmlBlank.find(tag.attributes[at - 1]) == std::string_view::npos) continue;
      after.remove_prefix(std::min(after.find_first_not_of(kXmlBlank), after.size()));
      if (!after.starts_with('=')) continue;
      after.remove_prefix(1);
      after.remove_prefix(std::min(after.find_first_not_of(kXmlBlank), after.size()));
      if (after.empty() || (after[0] != '"' && after[0] != '\'')) continue;
      const std::size_t end = after.find(after[0], 1);
      if (end != std::string_view::npos) return std::string(after.substr(1, end - 1));
    }
    return {};
  }

  void addArray(const Tag& tag) {
    if (!tag.closes) checkNumbers(tag, "0123456789+-.eEdDnNaAiIfFtTyY \t\r\n");
    double words = 0;
    bool inWord = false;
    for (const char c : tag.closes ? std::string_view() : tag.content) {
      const bool blank = kXmlBlank.find(c) != std::string_view::npos;
      words += !blank && !inWord;
      inWord = !blank;
    }
    const double count = attribute(tag, "count", -1);
    if (count != words)
      fail(tag, "says count = " + std::to_string(count) + " and holds " + std::to_string(words));
    const std::string id = attributeText(tag, "id");
    if (!arrays_.emplace(id, words).second) fail(tag, "has an id that is not its own");
  }

  void checkAccessor(const Tag& tag) const {
    const std::string source = attributeText(tag, "source");
    const auto array = arrays_.find(source.empty() ? source : source.substr(1));
    if (array == arrays_.end()) return;  // of names, which no mesh uses
    const double count = attribute(tag, "count", 0), stride = attribute(tag, "stride", 1);
    const double offset = attribute(tag, "offset", 0);
    if (stride < 1 || offset + count * stride > array->second)
      fail(tag, "reaches beyond its array of " + std::to_string(array->second));
  }

  const std::string& text_;
  std::string name_;
  std::size_t at_ = 0;
  std::map<std::string, double> arrays_;
  std::vector<Tag> accessors_;
};

}  // namespace

void checkCollada(const std::string& text, const std::string& name) {
  ColladaChecker(text, name).check();
}

}  // namespace cutwater
