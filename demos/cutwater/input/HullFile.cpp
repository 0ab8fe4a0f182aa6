#include "demos/cutwater/input/HullFile.h"

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/geometry/panelling/Panelling.h"
#include "hydro/geometry/repair/MeshRepair.h"

namespace cutwater::command {

PanelledHull readPanelled(const std::string& mesh, const MeshReadOptions& options,
                          std::optional<int> count) {
  if (!count) return panelledAsItIs(readHull(mesh, options));
  RepairedHull repaired = readRepaired(mesh, options);
  for (const std::string& line : repaired.done) say(mesh + ": " + line);
  SurfaceMesh panels = panelled(repaired.hull, *count, mesh);
  return {std::move(repaired.hull.surface), std::move(panels), repaired.hull.symmetric,
          repaired.hull.file};
}

namespace {

// What the file's owner may have meant otherwise.
std::string adviceFor(const TomlSection& hull, const std::string& mesh, Fault fault,
                      const std::optional<int>& panels) {
  std::string advice;
  const bool gltf = mesh.ends_with(".glb") || mesh.ends_with(".gltf");
  if (gltf && (!hull.has("up") || !hull.has("forward")))
    advice +=
        "; is the hull upright? [hull] up is \"z\" and forward \"x\" unless given, glTF has "
        "up = \"y\", forward = \"z\"";
  if (fault == Fault::HullNotClosed && !panels)
    advice += "; with [hull] panels = 250 the mesh is repaired and divided into panels";
  return advice;
}

}  // namespace

PanelledHull readHullSection(TomlFile& file, std::optional<int> count) {
  TomlSection hull = file.section("hull");
  if (!hull.has("mesh")) hull.refuse("mesh", "is missing; it names the hull file");
  const std::string mesh = hull.file("mesh");
  MeshReadOptions options;
  options.up = hull.text("up", options.up, kAxisNames);
  options.forward = hull.text("forward", options.forward, kAxisNames);
  if (options.up.back() == options.forward.back())
    hull.refuse("forward", "is the axis that points up");
  options.unit = hull.text("unit", options.unit, kUnitNames);
  options.waterline = hull.number("waterline", 0.0, -1e6, 1e6);
  options.trimDeg = hull.number("trim_deg", 0.0, -45.0, 45.0);
  options.heelDeg = hull.number("heel_deg", 0.0, -89.9, 89.9);
  options.anyFormat = hull.boolean("any_format", false);
  options.symmetric = hull.text("symmetric", "auto", kSymmetryNames);
  std::optional<int> panels = count;
  if (hull.isNumber("panels")) {
    const int own = hull.integer("panels", 0, kFewestPanels, kMostPanels);
    panels = count.value_or(own);
  } else {
    hull.text("panels", "as-is", {"as-is"});
  }
  hull.finish();
  try {
    return readPanelled(mesh, options, panels);
  } catch (const HydroError& error) {
    throw HydroError(error.fault(), error.what() + adviceFor(hull, mesh, error.fault(), panels));
  }
}

}  // namespace cutwater::command
