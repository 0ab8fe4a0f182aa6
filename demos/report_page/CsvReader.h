#pragma once
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cutwater::page {

/// Reads a CSV of numbers line by line, in the memory of a line, however long the file:
///     CsvReader csv("run.csv");
///     std::vector<double> row(csv.columns().size());
///     while (csv.next(row)) ...
/// Errors are HydroErrors of one line that names file, line, column and value.
class CsvReader {
 public:
  /// Opens the file and reads its first line.
  /// @throws HydroError FileNotReadable, FileMalformed.
  explicit CsvReader(const std::string& path);

  const std::vector<std::string>& columns() const noexcept { return columns_; }
  /// The next row; false at the end. @pre row.size() == columns().size().
  /// @throws HydroError FileMalformed: not as many numbers as columns, or no number.
  bool next(std::span<double> row);
  /// Ends with the line last read and this reason.
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool readLine();

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::string> columns_;
  std::string buffer_, line_;
  std::size_t at_ = 0, number_ = 0;
};

}  // namespace cutwater::page
