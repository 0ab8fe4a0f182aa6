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

/// Reads a mesh. With a count it is repaired and divided anew into about as many panels a side, and
/// what was repaired is said on stderr; without, its faces below water are the panels.
/// @throws HydroError naming the file.
PanelledHull readPanelled(const std::string& mesh, const MeshReadOptions& options,
                          std::optional<int> count, PanelsBy by = PanelsBy::Auto,
                          bool quiet = false);

/// What the [hull] section of a SHIP.toml asks for.
struct HullRequest {
  std::string mesh;
  MeshReadOptions options;
  std::optional<int> panels;  ///< absent: the file's own faces
  PanelsBy by = PanelsBy::Auto;
  bool floats = false;     ///< the waterline, trim and heel are to be found
  bool axesGiven = false;  ///< up and forward are said
  bool quiet = false;      ///< what is done to the mesh is not said
};
/// `count` overrides its `panels`, `by` its `panels_by` if it is not Auto.
HullRequest readHullRequest(TomlFile& file, std::optional<int> count = {},
                            PanelsBy by = PanelsBy::Auto);
/// The hull, or what its owner may have meant otherwise in the message.
/// @throws HydroError naming the file.
PanelledHull readPanelled(const HullRequest& request);

}  // namespace cutwater::command
