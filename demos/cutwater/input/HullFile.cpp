#include "demos/cutwater/input/HullFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/geometry/panelling/Panelling.h"

namespace cutwater::command {

namespace {

// From here on it is said; of fewer than 433 panels a side that are inscribed from what these lack,
// which curved panels (PanelShape) make up for.
constexpr double kVolumeOff = 0.01, kInscribed = 4.3;
// Longer than any ship, and shorter than any model that is towed [m]; broader and deeper than any
// body that is not laid wrongly, of the length and of the breadth.
constexpr double kLongest = 1000.0, kShortest = 0.05, kBroadest = 2.5, kDeepest = 4.0;
constexpr double kShallowest = 0.01;  // part of the height that is in the water

void warnOfVolume(const std::string& mesh, const AnyHull& made, int count) {
  const double off = made.panelVolume / made.volume - 1;
  const double inscribed = made.by == PanelsBy::Sections ? kInscribed / count : 0.0;
  if (std::abs(off) <= std::max(kVolumeOff, inscribed)) return;
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

// Places in hull axes, as messages name them, each with the same in the file's axes where these are
// others.
std::string withFilePlaces(const std::string& line, const MeshReadOptions& options) {
  const FilePlacement file = filePlacement(options);
  if (file.rotation.isIdentity() && file.metresPerUnit == 1.0 && file.origin.isZero()) return line;
  static const std::regex place(R"(\((-?[0-9.e+-]+), (-?[0-9.e+-]+), (-?[0-9.e+-]+)\))");
  std::string out;
  auto from = line.begin();
  for (std::sregex_iterator m(line.begin(), line.end(), place), end; m != end; ++m) {
    const Vec3 hull(std::stod((*m)[1]), std::stod((*m)[2]), std::stod((*m)[3]));
    const Vec3 p = file.rotation.transpose() * (hull - file.origin) / file.metresPerUnit;
    out.append(from, (*m)[0].second);
    out += fmt::format(", in the file ({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
    from = (*m)[0].second;
  }
  return out.append(from, line.end());
}

}  // namespace

PanelledHull readPanelled(const std::string& mesh, const MeshReadOptions& options,
                          std::optional<int> count, PanelsBy by, bool quiet) {
  if (!count) return readAsItIs(mesh, options);
  AnyHull made = readAnyHull(mesh, *count, options, by);
  if (!quiet) {
    for (const std::string& line : made.done) say(mesh + ": " + withFilePlaces(line, options));
    warnOfVolume(mesh, made, *count);
  }
  return {std::move(made.hull.surface), std::move(made.panels), made.hull.symmetric, made.hull.file,
          made.by == PanelsBy::Surface};
}

namespace {

// What the file's owner may have meant otherwise.
std::string adviceFor(const HullRequest& request, Fault fault) {
  std::string advice;
  const bool gltf = request.mesh.ends_with(".glb") || request.mesh.ends_with(".gltf");
  if (gltf && !request.axesGiven)
    advice +=
        "; is the hull upright? [hull] up is \"z\" and forward \"x\" unless given, glTF has "
        "up = \"y\", forward = \"z\"";
  const bool faces = fault == Fault::HullNotClosed || fault == Fault::HullPartHidden ||
                     fault == Fault::HullInverted;
  if (faces && !request.panels)
    advice += "; with [hull] panels = 250 the mesh is repaired and divided into panels";
  if (fault == Fault::HullNotInWater)
    advice +=
        "; [hull] waterline is the height of calm water in the file, 0 unless given: is its "
        "origin at the keel?";
  return advice;
}

// Lengths that a ship has not: the unit is another one, or the hull lies on its side or across.
void requireShipshape(const HullRequest& request, const PanelledHull& hull) {
  const Bounds box = bounds(wholeWet(hull));
  const Vec3 size = box.high - box.low;
  const auto refuse = [&](const std::string& what) {
    throw HydroError(
        Fault::ValueOutOfRange,
        fmt::format("{}: the hull would be {:.4g} x {:.4g} x {:.4g} m in the water; {}",
                    request.mesh, size.x(), size.y(), size.z(), what));
  };
  const Bounds whole = bounds(hull.surface);
  if (size.z() < kShallowest * (whole.high.z() - whole.low.z()))
    refuse(
        "[hull] waterline is the height of calm water in the file, 0 unless given: is its origin "
        "at the keel?");
  if (size.x() > kLongest || size.maxCoeff() < kShortest)
    refuse("is [hull] unit right? It is m, mm, cm, ft or in, and m unless given");
  if (size.y() > kBroadest * size.x())
    refuse("is [hull] forward right? It is the file's axis to the bow, x unless given");
  if (size.z() > kDeepest * size.y() && size.x() > kDeepest * size.y())
    refuse("is [hull] up right? It is the file's axis that points up, z unless given");
}

}  // namespace

HullRequest readHullRequest(TomlFile& file, std::optional<int> count, PanelsBy by) {
  TomlSection hull = file.section("hull");
  if (!hull.has("mesh")) hull.refuse("mesh", "is missing; it names the hull file");
  HullRequest request;
  request.mesh = hull.file("mesh");
  MeshReadOptions& options = request.options;
  request.axesGiven = hull.has("up") && hull.has("forward");
  options.up = hull.text("up", options.up, kAxisNames);
  options.forward = hull.text("forward", options.forward, kAxisNames);
  if (options.up.back() == options.forward.back())
    hull.refuse("forward", "is the axis that points up");
  options.unit = hull.text("unit", options.unit, kUnitNames);
  options.waterline = hull.number("waterline", 0.0, -1e6, 1e6);
  request.floats = hull.boolean("float", false);
  for (const char* key : {"trim_deg", "heel_deg"})
    if (request.floats && hull.has(key)) hull.refuse(key, "is found by float = true");
  options.trimDeg = hull.number("trim_deg", 0.0, -45.0, 45.0);
  options.heelDeg = hull.number("heel_deg", 0.0, -89.9, 89.9);
  options.anyFormat = hull.boolean("any_format", false);
  options.symmetric = hull.text("symmetric", "auto", kSymmetryNames);
  request.panels = count;
  if (hull.isNumber("panels")) {
    const int own = hull.integer("panels", 0, kFewestPanels, kMostPanels);
    request.panels = count.value_or(own);
  } else {
    hull.text("panels", "as-is", {"as-is"});
  }
  const PanelsBy own = hull.choice("panels_by", kPanelsByNames, PanelsBy::Auto);
  request.by = by == PanelsBy::Auto ? own : by;
  hull.finish();
  return request;
}

PanelledHull readPanelled(const HullRequest& request) {
  try {
    PanelledHull hull =
        readPanelled(request.mesh, request.options, request.panels, request.by, request.quiet);
    requireShipshape(request, hull);
    return hull;
  } catch (const HydroError& error) {
    throw HydroError(error.fault(), withFilePlaces(error.what(), request.options) +
                                        adviceFor(request, error.fault()));
  }
}

}  // namespace cutwater::command
