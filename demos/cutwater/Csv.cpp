#include "demos/cutwater/Csv.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "hydro/Errors.h"

namespace cutwater::command {

std::string csvNumber(double value) {
  if (std::isnan(value)) return "nan";
  return fmt::format("{:.9g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

void Csv::row(const std::vector<double>& values, const std::string& prefix) {
  text_ += prefix;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text_ += ',';
    text_ += csvNumber(values[i]);
  }
  text_ += '\n';
}

void Csv::write(const std::string& path) const {
  if (path.empty()) {
    if (std::fwrite(text_.data(), 1, text_.size(), stdout) != text_.size() ||
        std::fflush(stdout) != 0) {
      throw HydroError(Fault::FileNotWritable, "stdout: cannot be written");
    }
    return;
  }
  const std::string temporary = path + fmt::format(".tmp{}", getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << text_;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) {
    std::filesystem::remove(temporary, error);
    throw HydroError(Fault::FileNotWritable, path + ": cannot be written");
  }
}

}  // namespace cutwater::command
