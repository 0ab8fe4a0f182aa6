#pragma once
#include <string>
#include <string_view>

namespace cutwater {

/// Makes `text` the file `path`, whole or not at all: written beside it under a name of this
/// process's own, then renamed. A link's target is replaced; a device or a pipe is
/// written as it is.
/// @throws HydroError FileNotWritable, naming `path`; nothing is left behind.
void writeWhole(const std::string& path, std::string_view text);

}  // namespace cutwater
