#include "demos/cutwater/output/Csv.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"

namespace cutwater::command {

double phaseDegrees(Complex z) {
  const double degrees = std::arg(z) * 180.0 / kPi;
  return degrees < -180.0 + 5e-7 ? 180.0 : degrees;  // what nine digits would write as -180
}

void Csv::row(const std::vector<double>& values, const std::string& prefix) {
  text_ += prefix;
  addCsvRow(text_, values);
}

void writeText(const std::string& text, const std::string& path) {
  if (!path.empty()) return writeWhole(path, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw HydroError(Fault::FileNotWritable, "stdout: cannot be written");
  }
}

void requireWritable(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.empty()) return;
  const auto folder = fs::absolute(path).parent_path();
  if (fs::is_directory(path) || access(folder.c_str(), W_OK) != 0) {
    throw HydroError(Fault::FileNotWritable,
                     path + ": cannot be written (no such folder, or no permission)");
  }
}

}  // namespace cutwater::command
