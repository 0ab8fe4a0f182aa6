#include <fmt/format.h>

#include <filesystem>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/HullFile.h"
#include "demos/cutwater/output/ShipListing.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panelling/Panelling.h"

namespace cutwater::command {

namespace {

PanelledHull readAny(const std::string& hull, int count, const MeshReadOptions& options,
                     PanelsBy by) {
  if (std::filesystem::path(hull).extension() != ".toml")
    return readPanelled(hull, options, count, by);
  TomlFile file(hull);
  const HullRequest request = readHullRequest(file, count, by);
  if (request.floats)
    warn(hull +
         ": [hull] float = true needs the rest of the file: panels are of the hull as drawn");
  return readPanelled(request);
}

}  // namespace

void panel(const std::string& hull, int count, const MeshReadOptions& options, PanelsBy by,
           const std::string& out) {
  const PanelledHull made = readAny(hull, count, options, by);
  const SurfaceMesh wet = wholeWet(made);
  const std::size_t panels = made.panels.faces.size();
  const double whole =
      volumeIntegrals(displacingSurface({made.surface, made.symmetric, false})).volume;
  const std::string about =
      fmt::format("{} panels{}, {}, area {:.6g} m2", panels, made.symmetric ? " a side" : "",
                  sizeText(wet, whole), surfaceArea(wet));
  writeObj(
      out, wet,
      fmt::format("{} of the wet part of {}\nmetres; x forward, y to port, z up from calm water; "
                  "made by cutwater panel",
                  about, std::filesystem::path(hull).filename().string()));
  say(fmt::format("{}: {}; {:.1f} % of them more than 3 times as long as wide", out, about,
                  100.0 * stretchedShare(made.panels)));
}

}  // namespace cutwater::command
