#include "demos/report_page/CsvReader.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <filesystem>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"

namespace cutwater::page {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    parts.push_back(line.substr(from, comma - from));
    from = comma + 1;
  }
  return parts;
}

}  // namespace

CsvReader::CsvReader(const std::string& path) : path_(path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))
    throw HydroError(Fault::FileNotReadable, path + ": no such file");
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) throw HydroError(Fault::FileNotReadable, path + ": cannot be read");
  if (!readLine()) throw HydroError(Fault::FileMalformed, path + ": is empty, must be a CSV");
  columns_ = split(line_);
}

bool CsvReader::readLine() {
  line_.clear();
  for (;;) {
    const std::size_t end = buffer_.find('\n', at_);
    if (end != std::string::npos) {
      line_.append(buffer_, at_, end - at_);
      at_ = end + 1;
      break;
    }
    line_.append(buffer_, at_, std::string::npos);
    buffer_.resize(1 << 18);
    buffer_.resize(std::fread(buffer_.data(), 1, buffer_.size(), file_.get()));
    at_ = 0;
    if (std::ferror(file_.get()) != 0)
      throw HydroError(Fault::FileNotReadable, path_ + ": cannot be read");
    if (buffer_.empty()) {
      if (line_.empty()) return false;
      break;  // a last line without its end
    }
  }
  if (line_.ends_with('\r')) line_.pop_back();
  ++number_;
  return true;
}

void CsvReader::refuse(const std::string& reason) const {
  throw HydroError(Fault::FileMalformed, fmt::format("{}: line {}: {}", path_, number_, reason));
}

bool CsvReader::next(std::span<double> row) {
  do {
    if (!readLine()) return false;
  } while (line_.empty());
  const char *at = line_.data(), *const end = at + line_.size();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto [after, error] = std::from_chars(at, end, row[i]);
    const bool last = i + 1 == row.size();
    const bool ends = last ? after == end : after < end && *after == ',';
    if (error == std::errc() && ends) {
      at = after + (last ? 0 : 1);
      continue;
    }
    const std::vector<std::string> values = split(line_);
    if (values.size() != row.size())
      refuse(fmt::format("{} values, the first line names {} columns", values.size(), row.size()));
    refuse(fmt::format("{} = {}: must be a number", columns_[i], command::shortened(values[i])));
  }
  return true;
}

}  // namespace cutwater::page
