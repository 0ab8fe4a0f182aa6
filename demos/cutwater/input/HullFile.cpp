#include "demos/cutwater/input/HullFile.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/geometry/panelling/Panelling.h"

namespace cutwater::command {

namespace {

constexpr double kVolumeOff = 0.01;  // from here on it is said

void warnOfVolume(const std::string& mesh, const AnyHull& made) {
  const double off = made.panelVolume / made.volume - 1;
  if (std::abs(off) <= kVolumeOff) return;
  warn(
      fmt::format("{}: panels enclose {:.6g} m3, the hull {:.6g} m3 ({:+.1f} %); more panels "
                  "follow it better",
                  mesh, made.panelVolume, made.volume, 100 * off));
}

// Faces that share their edges, or nearly so, as other panel methods take them.
PanelledHull readAsItIs(const std::string& mesh, const MeshReadOptions& options) {
  try {
    return panelledAsItIs(readHull(mesh, options));
  } catch (const HydroError& error) {
    if (error.fault() != Fault::HullNotClosed && error.fault() != Fault::HullInverted) throw;
    CrackedHull made;
    try {
      made = readCracked(mesh, options);
    } catch (const HydroError&) {
      throw error;
    }
    warn(
        fmt::format("{}: {} edges below water have one face (hanging nodes or gaps below {:.2g} "
                    "m); the volumes by x, y and z are {:.6g}, {:.6g} and {:.6g} m3",
                    mesh, made.looseEdges, made.tolerance, made.volumes.x(), made.volumes.y(),
                    made.volumes.z()));
    return {std::move(made.hull.surface), std::move(made.panels), made.hull.symmetric,
            made.hull.file};
  }
}

}  // namespace

PanelledHull readPanelled(const std::string& mesh, const MeshReadOptions& options,
                          std::optional<int> count, PanelsBy by) {
  if (!count) return readAsItIs(mesh, options);
  AnyHull made = readAnyHull(mesh, *count, options, by);
  for (const std::string& line : made.done) say(mesh + ": " + line);
  warnOfVolume(mesh, made);
  return {std::move(made.hull.surface), std::move(made.panels), made.hull.symmetric, made.hull.file,
          made.by == PanelsBy::Surface};
}

PanelsBy panelsBy(const std::string& name) {
  return name == "sections"  ? PanelsBy::Sections
         : name == "surface" ? PanelsBy::Surface
                             : PanelsBy::Auto;
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
  const bool faces = fault == Fault::HullNotClosed || fault == Fault::HullPartHidden ||
                     fault == Fault::HullInverted;
  if (faces && !panels)
    advice += "; with [hull] panels = 250 the mesh is repaired and divided into panels";
  return advice;
}

}  // namespace

PanelledHull readHullSection(TomlFile& file, std::optional<int> count, PanelsBy by) {
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
  const PanelsBy own = panelsBy(hull.text("panels_by", "auto", kPanelsByNames));
  hull.finish();
  try {
    return readPanelled(mesh, options, panels, by == PanelsBy::Auto ? own : by);
  } catch (const HydroError& error) {
    throw HydroError(error.fault(), error.what() + adviceFor(hull, mesh, error.fault(), panels));
  }
}

}  // namespace cutwater::command
