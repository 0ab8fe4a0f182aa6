#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/commands/ShipToml.h"
#include "demos/cutwater/output/HullPicture.h"
#include "demos/cutwater/output/OutputFile.h"
#include "hydro/base/AtomicFile.h"

namespace cutwater::command {

namespace {

namespace fs = std::filesystem;

void requireNew(const std::string& path, bool force) {
  std::error_code none;
  if (!force && fs::exists(fs::symlink_status(path, none)))
    throw HydroError(Fault::FileNotWritable,
                     path + ": is there already; --force writes over it, -o names another file");
  requireWritable(path);
}

// For the file in its own folder: relative where there is a way, with / as separator.
std::string relativeName(const std::string& mesh, const std::string& toml) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(toml)).parent_path();
  return fs::weakly_canonical(fs::absolute(mesh)).lexically_proximate(folder).generic_string();
}

// What CLI11 lets through: "nan" and "inf" are numbers to it.
void requireSensible(const NewOptions& o) {
  const auto check = [](const char* option, std::optional<double> value, double low, double high) {
    if (value && !(*value >= low && *value <= high))
      throw UsageError(fmt::format("{} {:g}: must be in {:g}..{:g}", option, *value, low, high));
  };
  check("--waterline", o.waterline, -1e6, 1e6);
  check("--draught", o.draught, 1e-6, 1e4);
  check("--displacement", o.displacement, 1e-9, 1e15);
  check("--mass", o.mass, 1e-9, 1e15);
  check("--cog-height", o.cogHeight, -1e4, 1e4);
  check("--trim", o.trimDeg, -45.0, 45.0);
  check("--heel", o.heelDeg, -89.0, 89.0);
  check("--density", o.density, 1.0, 1e5);
}

std::string sizes(const Hydrostatics& h) {
  return fmt::format("L x B x T {:.4g} x {:.4g} x {:.4g} m, volume {:.5g} m3", h.length, h.beam,
                     h.draft, h.volume);
}

std::string stability(const NewShip& ship) {
  const Hydrostatics& h = ship.hydrostatics;
  return fmt::format(
      "mass {:.5g} kg, centre of gravity [{:.4g}, {:.4g}, {:.4g}] m, GM {:.3g} m "
      "across, {:.3g} m along",
      ship.mass, ship.cog.x(), ship.cog.y(), ship.cog.z(), h.gmT, h.gmL);
}

void report(const NewShip& ship) {
  say(ship.mesh + ": what it is taken for, and the option that says otherwise");
  for (const NewFact& fact : ship.facts)
    say(fmt::format("  {:<12} {:<8} {}{} ({})", fact.name, fact.value, fact.word,
                    fact.reason.empty() ? "" : ": " + fact.reason, fact.option));
  if (!ship.directed) say("  it is no ship with a bow: x is an axis, not a way to go");
  say("  " + sizes(ship.hydrostatics));
  say("  " + stability(ship) + (ship.givenMass ? "" : "; mass: density x volume (--mass)"));
}

void warnOfNewShip(const NewShip& ship) {
  const Hydrostatics& h = ship.hydrostatics;
  if (!ship.problem.empty())
    warn("`cutwater solve` will refuse the hull as it is: " + ship.problem);
  if (h.gmT <= 0.0)
    warn(fmt::format("GM is {:.3g} m: it is not stable upright; a lower --cog-height", h.gmT));
  const double excess = ship.mass / h.displacement - 1.0;
  if (std::abs(excess) > 1e-3)
    warn(
        fmt::format("--mass {:g} is {:+.3g} % of density x volume, {:.6g} kg: it would not float "
                    "as drawn; without a waterline or a draught the waterline is found for it",
                    ship.mass, 100.0 * excess, h.displacement));
}

}  // namespace

void newShipFile(const std::string& hull, const NewOptions& options, bool force,
                 const std::string& out) {
  if (fs::path(out).extension() != ".toml")
    throw UsageError("-o " + shortened(out) + ": must end in .toml");
  if (fs::path(hull).extension() == ".toml")
    throw HydroError(Fault::BadArgument, hull + ": is a ship.toml already, not a mesh");
  requireSensible(options);
  if (options.up && options.forward && options.up->back() == options.forward->back())
    throw UsageError("--forward " + *options.forward + ": is the axis that points up");
  const std::string picture = fs::path(out).replace_extension(".svg").string();
  for (const std::string& path : {out, picture}) requireNew(path, force);
  const NewShip ship = newShip(hull, options);
  const std::string name = fs::path(hull).filename().string();
  const std::string svg = svgOf(
      {ship.hull.surface, ship.hull.symmetric, name, {sizes(ship.hydrostatics), stability(ship)}});
  report(ship);
  warnOfNewShip(ship);
  writeText(shipToml(ship, relativeName(hull, out)), out);
  writeText(svg, picture);
  const std::string next = fmt::format("; look at the picture, then: cutwater solve {} -o {}", out,
                                       fs::path(out).replace_extension(".h5").string());
  say(out + " and " + picture + " are written" + (ship.problem.empty() ? next : ""));
}

}  // namespace cutwater::command
