#pragma once
#include <string>

namespace cutwater {

/// Refuses COLLADA text that Assimp 5.2.5's importer would not survive: index lists (<p>, <vcount>,
/// <v>, <h>) with anything but numbers make it read the same place for ever, allocating as it goes,
/// and accessors that reach beyond their array make it read outside memory.
/// @param name  of the file, for messages.
/// @throws HydroError FileMalformed. O(text). Not installed; used by MeshIO.cpp.
void checkCollada(const std::string& text, const std::string& name);

}  // namespace cutwater
