#include "demos/cutwater/input/Toml.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "demos/cutwater/output/Messages.h"
#include "demos/cutwater/output/OutputFile.h"
#include "hydro/Errors.h"

namespace cutwater::command {

struct TomlSection::State {
  std::string file;
  std::string name;  // "" for the root
  toml::table table;
  std::set<std::string> asked;
  const toml::node* find(const std::string& key) const { return table.get(key); }
};

namespace {

/// A value as the file could contain it, numbers by their shortest text.
std::string written(const toml::node& node) {
  std::vector<std::string> parts;
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& item : *list) parts.push_back(written(item));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      parts.push_back(fmt::format("{} = {}", key.str(), written(value)));
    return fmt::format("{{ {} }}", fmt::join(parts, ", "));
  }
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream out;
  node.visit([&out](const auto& value) { out << value; });
  return out.str();
}

// Names of tables and keys may have this many parts. toml++ walks deeper ones by recursion, which
// a file of 200 kB could lead to the end of the stack.
constexpr int kMostParts = 32;

// Skips a text in quotes, of one line or of several; `at` is its first quote.
std::size_t endOfText(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool several = text.substr(at, 3) == three;
  const std::string end = several ? three : std::string(1, quote);
  for (std::size_t i = at + end.size(); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text.substr(i, end.size()) == end) {
      return i + end.size() - 1;
    } else if (!several && text[i] == '\n') {
      return i;
    }
  }
  return text.size();
}

void checkDepth(const std::string& path, std::string_view text) {
  int line = 1, dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = endOfText(text, i);
      line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                          text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '.') {
      ++dots;
    } else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) {
      dots = 0;
      if (c == '\n') ++line;
    }
    if (dots < kMostParts) continue;
    throw HydroError(Fault::FileMalformed, fmt::format("{}: line {}: a name of more than {} parts",
                                                       path, line, kMostParts));
  }
}

std::string wholeFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw HydroError(Fault::FileNotReadable, path + ": cannot be read");
  return text.str();
}

std::vector<double> fromToStep(TomlSection range, double low, double high) {
  const double from = range.number("from", low, low, high);
  const double to = range.number("to", high, low, high);
  const double step = range.number("step", 1.0, -high, high);
  for (const char* key : {"from", "to", "step"}) {
    if (!range.has(key)) range.refuse(key, "is missing; a range is { from, to, step }");
  }
  range.finish();
  constexpr double kMostSteps = 99999.0;
  if (!(step > 0.0)) range.refuse("step", "must be above 0");
  if (to < from) range.refuse("to", fmt::format("must not be below from = {}", from));
  const double count = std::round((to - from) / step);
  if (count > kMostSteps)
    range.refuse("step", fmt::format("makes more than 100000 values; {:.6g} is the smallest",
                                     std::ceil(1e9 * (to - from) / kMostSteps) / 1e9));
  if (std::abs(from + count * step - to) > 1e-6 * step) {
    const double nearest = from + count * step;
    range.refuse("to", fmt::format("is not from + n step; the nearest is {:.10g}, or step = {:.6g}",
                                   nearest, (to - from) / std::max(count, 1.0)));
  }
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(count); ++i) values.push_back(from + i * step);
  return values;
}

}  // namespace

bool TomlSection::has(const std::string& key) const {
  state_->asked.insert(key);
  return holds(key);
}

bool TomlSection::holds(const std::string& key) const { return state_->find(key) != nullptr; }

void TomlSection::refuse(const std::string& key, const std::string& reason) const {
  const toml::node* node = state_->find(key);
  const std::string where = state_->name.empty() ? "" : "[" + state_->name + "] ";
  const std::string value = node == nullptr ? "" : " = " + shortened(written(*node));
  throw HydroError(Fault::ValueOutOfRange, fmt::format("{}: {}{}{}: {}", state_->file, where,
                                                       shortened(key), value, reason));
}

double TomlSection::number(const std::string& key, double fallback, double low, double high) {
  state_->asked.insert(key);
  const toml::node* node = state_->find(key);
  if (node == nullptr) return fallback;
  const auto value = node->value<double>();
  if (!node->is_number() || !value) refuse(key, "must be a number");
  if (!(*value >= low && *value <= high)) refuse(key, fmt::format("must be in {}..{}", low, high));
  return *value;
}

int TomlSection::integer(const std::string& key, int fallback, int low, int high) {
  state_->asked.insert(key);
  const toml::node* node = state_->find(key);
  if (node == nullptr) return fallback;
  const auto value = node->value<std::int64_t>();
  if (!node->is_integer() || !value) refuse(key, "must be a whole number");
  if (*value < low || *value > high) refuse(key, fmt::format("must be in {}..{}", low, high));
  return static_cast<int>(*value);
}

bool TomlSection::boolean(const std::string& key, bool fallback) {
  state_->asked.insert(key);
  const toml::node* node = state_->find(key);
  if (node == nullptr) return fallback;
  if (!node->is_boolean()) refuse(key, "must be true or false");
  return *node->value<bool>();
}

std::string TomlSection::text(const std::string& key, const std::string& fallback,
                              const std::vector<std::string>& allowed) {
  state_->asked.insert(key);
  const toml::node* node = state_->find(key);
  if (node == nullptr) return fallback;
  if (!node->is_string()) refuse(key, "must be text in quotes");
  const std::string value = *node->value<std::string>();
  if (allowed.empty()) return value;
  for (const std::string& one : allowed) {
    if (value == one) return value;
  }
  refuse(key, fmt::format("must be one of \"{}\"", fmt::join(allowed, "\", \"")));
}

std::string TomlSection::file(const std::string& key) {
  namespace fs = std::filesystem;
  const std::string name = text(key, "");
  if (name.empty()) refuse(key, "must name a file");
  const std::string path = (fs::path(state_->file).parent_path() / name).string();
  std::error_code none;
  if (fs::is_directory(path, none)) refuse(key, "is a folder, must be a file");
  if (!fs::is_regular_file(path, none)) refuse(key, "there is no file " + shortened(path));
  if (isOutput(path)) refuse(key, "is the file that -o names; it would be written over");
  return path;
}

std::vector<std::string> TomlSection::texts(const std::string& key) {
  state_->asked.insert(key);
  std::vector<std::string> values;
  const toml::node* node = state_->find(key);
  if (node == nullptr) return values;
  if (!node->is_array()) refuse(key, "must be a list of texts in quotes");
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_string()) refuse(key, "must be a list of texts in quotes");
    values.push_back(*item.value<std::string>());
  }
  return values;
}

std::vector<double> TomlSection::numbers(const std::string& key,
                                         const std::vector<double>& fallback, double low,
                                         double high) {
  state_->asked.insert(key);
  const toml::node* node = state_->find(key);
  if (node == nullptr) return fallback;
  if (node->is_number()) return {number(key, 0.0, low, high)};
  if (node->is_table()) return fromToStep(table(key), low, high);
  if (!node->is_array()) refuse(key, "must be a number, a list of numbers or { from, to, step }");
  std::vector<double> values;
  for (const toml::node& item : *node->as_array()) {
    const auto value = item.value<double>();
    if (!item.is_number() || !value) refuse(key, "must hold numbers only");
    if (!(*value >= low && *value <= high)) {
      refuse(key, fmt::format("each value must be in {}..{}", low, high));
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::pair<double, double>> TomlSection::pairs(const std::string& key, double low,
                                                          double high) {
  state_->asked.insert(key);
  std::vector<std::pair<double, double>> values;
  const toml::node* node = state_->find(key);
  if (node == nullptr) return values;
  if (!node->is_array()) refuse(key, "must be a list of pairs of numbers");
  for (const toml::node& item : *node->as_array()) {
    const toml::array* pair = item.as_array();
    if (pair == nullptr || pair->size() != 2) refuse(key, "must be a list of pairs of numbers");
    const auto a = (*pair)[0].value<double>(), b = (*pair)[1].value<double>();
    if (!a || !b || !(*pair)[0].is_number() || !(*pair)[1].is_number()) {
      refuse(key, "must be a list of pairs of numbers");
    }
    if (!(*a >= low && *a <= high && *b >= low && *b <= high)) {
      refuse(key, fmt::format("each value must be in {}..{}", low, high));
    }
    values.emplace_back(*a, *b);
  }
  return values;
}

Vec3 TomlSection::vector(const std::string& key, const Vec3& fallback) {
  constexpr double kFar = 1e6;
  if (!has(key)) return fallback;
  const std::vector<double> values = numbers(key, {}, -kFar, kFar);
  if (!state_->find(key)->is_array() || values.size() != 3) refuse(key, "must be three numbers");
  return {values[0], values[1], values[2]};
}

bool TomlSection::isNumber(const std::string& key) const {
  return has(key) && state_->find(key)->is_number();
}

bool TomlSection::isText(const std::string& key) const {
  return has(key) && state_->find(key)->is_string();
}

std::vector<TomlSection> TomlSection::tables(const std::string& key) {
  state_->asked.insert(key);
  std::vector<TomlSection> sections;
  const toml::node* node = state_->find(key);
  if (node == nullptr) return sections;
  if (!node->is_array()) refuse(key, "must be a list of tables");
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) refuse(key, "must be a list of tables");
    const std::string name = fmt::format("{}{}[{}]", state_->name.empty() ? "" : state_->name + ".",
                                         key, sections.size());
    sections.push_back(
        TomlSection(std::make_shared<State>(State{state_->file, name, *item.as_table(), {}})));
  }
  return sections;
}

TomlSection TomlSection::table(const std::string& key) {
  state_->asked.insert(key);
  const std::string name = state_->name.empty() ? key : state_->name + "." + key;
  const toml::node* node = state_->find(key);
  if (node != nullptr && !node->is_table()) refuse(key, "must be a table");
  return TomlSection(std::make_shared<State>(
      State{state_->file, name, node == nullptr ? toml::table{} : *node->as_table(), {}}));
}

void TomlSection::finish() const {
  for (const auto& [key, value] : state_->table) {
    const std::string name(key.str());
    if (state_->asked.count(name) == 0) {
      refuse(name, fmt::format("unknown key; known here: {}", fmt::join(state_->asked, ", ")));
    }
  }
}

TomlFile::TomlFile(const std::string& path) : path_(path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) {
    const bool folder = std::filesystem::is_directory(path, none);
    throw HydroError(Fault::FileNotReadable,
                     path + (folder ? ": is a folder, must be a file" : ": no such file"));
  }
  if (isOutput(path))
    throw HydroError(Fault::FileNotWritable, path + ": is the file that -o names");
  const std::string text = wholeFile(path);
  checkDepth(path, text);
  try {
    root_ = TomlSection(std::make_shared<TomlSection::State>(
        TomlSection::State{path, "", toml::parse(text, path), {}}));
  } catch (const toml::parse_error& error) {
    throw HydroError(
        Fault::FileMalformed,
        fmt::format("{}: line {}: {}", path, error.source().begin.line, error.description()));
  }
}

}  // namespace cutwater::command
