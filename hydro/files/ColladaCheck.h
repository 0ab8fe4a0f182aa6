#pragma once
#include <string>

namespace cutwater {

/// Refuses COLLADA text that Assimp 5.2.5's importer would not survive. Index lists (<p>, <vcount>,
/// <v>, <h>) with anything but numbers make it read the same place for ever, allocating as it goes;
/// accessors that reach beyond their array make it read outside memory. O(text).
/// @param name  of the file, for messages.
/// @throws HydroError FileMalformed.
void checkCollada(const std::string& text, const std::string& name);

}  // namespace cutwater
