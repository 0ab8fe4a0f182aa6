#pragma once
#include <string>

/// The one file that a command writes.
namespace cutwater::command {

/// States the output before anything is read; main() does it once. Empty: stdout.
/// @throws HydroError FileNotWritable.
void setOutput(const std::string& path);

/// True if `path` is the output itself, under whatever name: a command may not read it.
bool isOutput(const std::string& path);

/// Writes `text` to stdout if `path` is empty, else as writeWhole (hydro/base/AtomicFile.h).
/// @throws HydroError FileNotWritable.
void writeText(const std::string& text, const std::string& path);

}  // namespace cutwater::command
