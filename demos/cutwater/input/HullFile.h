#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/cutwater/input/Toml.h"
#include "hydro/files/MeshIO.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::command {

/// What MeshReadOptions may say, in files and on the command line.
inline const std::vector<std::string> kAxisNames{"x", "-x", "y", "-y", "z", "-z"};
inline const std::vector<std::string> kUnitNames{"m", "mm", "cm", "ft", "in"};
inline const std::vector<std::string> kSymmetryNames{"auto", "none", "half"};
inline const std::vector<std::string> kPanelsByNames{"auto", "sections", "surface"};

/// Reads a mesh. With a count it is repaired and divided anew into about as many panels a side, and
/// what was repaired is said on stderr; without, its faces below water are the panels.
/// @throws HydroError naming the file.
PanelledHull readPanelled(const std::string& mesh, const MeshReadOptions& options,
                          std::optional<int> count, PanelsBy by = PanelsBy::Auto);

/// One of kPanelsByNames.
PanelsBy panelsBy(const std::string& name);

/// The [hull] section of a SHIP.toml. `count` overrides its `panels`, `by` its `panels_by` if it is
/// not Auto.
PanelledHull readHullSection(TomlFile& file, std::optional<int> count = {},
                             PanelsBy by = PanelsBy::Auto);

}  // namespace cutwater::command
