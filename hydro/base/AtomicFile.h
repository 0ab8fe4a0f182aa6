#pragma once
#include <string>
#include <string_view>

/// Files that are there whole or not at all.
namespace cutwater {

/// Makes `text` the file `path`, whole or not at all: written beside it under a name that nothing
/// else has, synced, then renamed. A file that was there keeps its mode; of a link, what it points
/// at is replaced. A pipe or a character device is written as it is.
/// @throws HydroError FileNotWritable, naming `path` and the reason; nothing is left behind.
void writeWhole(const std::string& path, std::string_view text);

/// Refuses what writeWhole would refuse, as far as that can be known before: for work whose result
/// the file is to hold. @throws as writeWhole.
void requireWritable(const std::string& path);

/// requireWritable, and `path` is not a pipe or a device. @throws as writeWhole.
void requireRegular(const std::string& path);

/// Writes all of `bytes` to a file that is open.  @return 0, or errno.
int writeAll(int file, std::string_view bytes) noexcept;

}  // namespace cutwater
