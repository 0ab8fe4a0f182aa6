#include "demos/cutwater/commands/Precision.h"

#include <unistd.h>

#include <filesystem>

#include "hydro/Errors.h"

namespace cutwater::command {

namespace {
char** arguments = nullptr;
#ifdef BT_USE_DOUBLE_PRECISION
constexpr bool kDouble = true;
#else
constexpr bool kDouble = false;
#endif
}  // namespace

void rememberArguments(char** argv) { arguments = argv; }

void usePrecision(bool doublePrecision) {
  if (doublePrecision == kDouble) return;
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  const auto other = self.parent_path() / (doublePrecision ? "cutwater" : "cutwater-float32");
  execv(other.c_str(), arguments);
  throw HydroError(Fault::FileNotReadable,
                   other.string() + " cannot be run: ./run build " + other.filename().string());
}

}  // namespace cutwater::command
