#pragma once
#include <memory>
#include <string>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/base/EnumNames.h"

namespace cutwater::command {

/// One table of a TOML file, read strictly: every value is checked where it is asked for, and
/// finish() refuses keys nobody asked for. Each error is one HydroError line
/// "file: [table] key = value: reason".
class TomlSection {
 public:
  /// Whether the file gives a value. The key counts as known from then on.
  bool has(const std::string& key) const;
  /// The same of a key that is no more, to be refused by its own message.
  bool holds(const std::string& key) const;
  /// A finite number in [low, high], or `fallback` where the key is absent.
  double number(const std::string& key, double fallback, double low, double high);
  int integer(const std::string& key, int fallback, int low, int high);
  bool boolean(const std::string& key, bool fallback);
  /// One of `allowed` (any text if empty).
  std::string text(const std::string& key, const std::string& fallback,
                   const std::vector<std::string>& allowed = {});
  /// The enumerator whose name, one of `names`, the file gives.
  template <class Enum, class Names>
  Enum choice(const std::string& key, const Names& names, Enum fallback) {
    return *fromName<Enum>(names, text(key, nameOf(names, fallback), {names.begin(), names.end()}));
  }
  /// The file that `key` names, its path relative to this file's folder: it must exist, and not be
  /// what the command writes.
  std::string file(const std::string& key);
  /// A list of texts; empty if the key is absent.
  std::vector<std::string> texts(const std::string& key);
  /// A number, a list of numbers, or { from, to, step } with both ends; each in [low, high].
  std::vector<double> numbers(const std::string& key, const std::vector<double>& fallback,
                              double low, double high);
  /// A list of pairs [a, b], each number in [low, high]; empty if the key is absent.
  std::vector<std::pair<double, double>> pairs(const std::string& key, double low, double high);
  Vec3 vector(const std::string& key, const Vec3& fallback);
  /// True if the value is a number, false if it is text or absent.
  bool isNumber(const std::string& key) const;
  bool isText(const std::string& key) const;
  /// The tables of an array of tables, or an inline table as a section of its own.
  std::vector<TomlSection> tables(const std::string& key);
  TomlSection table(const std::string& key);
  [[noreturn]] void refuse(const std::string& key, const std::string& reason) const;
  /// Refuses the first key that was never asked for.
  void finish() const;

  struct State;

 private:
  friend class TomlFile;
  explicit TomlSection(std::shared_ptr<State> state) : state_(std::move(state)) {}
  std::shared_ptr<State> state_;
};

/// A TOML file of top-level keys and tables.
class TomlFile {
 public:
  /// @throws HydroError FileNotReadable, FileMalformed with the line, FileNotWritable if it is what
  ///         the command writes.
  explicit TomlFile(const std::string& path);
  const std::string& path() const { return path_; }
  /// The keys outside any table; its finish() also refuses tables nobody asked for.
  TomlSection& root() { return root_; }
  /// The table of that name; an empty one if absent.
  TomlSection section(const std::string& name) { return root_.table(name); }

 private:
  std::string path_;
  TomlSection root_{nullptr};
};

}  // namespace cutwater::command
