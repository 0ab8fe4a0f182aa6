#include "demos/cutwater/input/Toml.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

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

std::vector<double> fromToStep(TomlSection range, double low, double high) {
  const double from = range.number("from", low, low, high);
  const double to = range.number("to", high, low, high);
  const double step = range.number("step", 1.0, -high, high);
  for (const char* key : {"from", "to", "step"}) {
    if (!range.has(key)) range.refuse(key, "is missing; a range is { from, to, step }");
  }
  range.finish();
  const double count = std::round((to - from) / step);
  if (!(step > 0.0) || to < from || count > 100000.0) {
    range.refuse("step", "must be positive and divide from..to into at most 100000 values");
  }
  if (std::abs(from + count * step - to) > 1e-6 * step) range.refuse("to", "is not from + n·step");
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(count); ++i) values.push_back(from + i * step);
  return values;
}

}  // namespace

bool TomlSection::has(const std::string& key) const { return state_->find(key) != nullptr; }

void TomlSection::refuse(const std::string& key, const std::string& reason) const {
  const toml::node* node = state_->find(key);
  const std::string where = state_->name.empty() ? "" : "[" + state_->name + "] ";
  const std::string value = node == nullptr ? "" : " = " + written(*node);
  throw HydroError(Fault::ValueOutOfRange,
                   fmt::format("{}: {}{}{}: {}", state_->file, where, key, value, reason));
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
  if (!has(key)) {
    state_->asked.insert(key);
    return fallback;
  }
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
  if (!std::filesystem::is_regular_file(path)) {
    throw HydroError(Fault::FileNotReadable, path + ": no such file");
  }
  try {
    root_ = TomlSection(std::make_shared<TomlSection::State>(
        TomlSection::State{path, "", toml::parse_file(path), {}}));
  } catch (const toml::parse_error& error) {
    throw HydroError(
        Fault::FileMalformed,
        fmt::format("{}: line {}: {}", path, error.source().begin.line, error.description()));
  }
}

std::string TomlFile::beside(const std::string& name) const {
  return (std::filesystem::path(path_).parent_path() / name).string();
}

}  // namespace cutwater::command
