#include "demos/cutwater/output/OutputFile.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"

namespace cutwater::command {

namespace {
std::string output;
}

void setOutput(const std::string& path) {
  if (!path.empty()) requireWritable(path);
  output = path;
}

bool isOutput(const std::string& path) {
  std::error_code none;
  return !output.empty() && std::filesystem::equivalent(path, output, none);
}

void writeText(const std::string& text, const std::string& path) {
  if (!path.empty()) return writeWhole(path, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return;
  if (errno == EPIPE) {  // the reader has seen enough, as `head` does: end as other programs end
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw HydroError(Fault::FileNotWritable,
                   std::string("stdout: cannot be written: ") + std::strerror(errno));
}

}  // namespace cutwater::command
