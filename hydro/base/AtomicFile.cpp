#include "hydro/base/AtomicFile.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

namespace fs = std::filesystem;

bool put(const fs::path& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file.good();
}

[[noreturn]] void refuse(const std::string& path, const std::error_code& why) {
  throw HydroError(Fault::FileNotWritable,
                   path + ": cannot be written" + (why ? ": " + why.message() : ""));
}

}  // namespace

void writeWhole(const std::string& path, std::string_view text) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    if (!put(path, text)) refuse(path, {});
    return;
  }
  error.clear();
  const fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
  if (!target.empty()) {
    const fs::path first = target.string() + ".part" + std::to_string(::getpid());
    error.clear();
    if (put(first, text)) {
      fs::rename(first, target, error);
      if (!error) return;
    }
    std::error_code ignored;
    fs::remove(first, ignored);
  }
  refuse(path, error);
}

}  // namespace cutwater
