#include "demos/cutwater/input/Floating.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/base/Radians.h"
#include "hydro/ship/FloatingAttitude.h"
#include "hydro/ship/StillWater.h"

namespace cutwater::command {

namespace {

constexpr double kStart = 0.3;      // of the height that is under water at first
constexpr double kLightest = 2e-3;  // of what the whole hull displaces

}  // namespace

MeshReadOptions inWater(const std::string& mesh, MeshReadOptions options) {
  const Bounds box = bounds(readSurface(mesh, options));
  const double height = box.high.z() - box.low.z(), draught = -box.low.z();
  if (draught > 0.01 * height && draught < 0.99 * height) return options;
  const double unit = filePlacement(options).metresPerUnit;
  options.waterline += (box.low.z() + kStart * height) / unit;
  return options;
}

MeshReadOptions sunk(const std::string& mesh, const PanelledHull& drawn, MeshReadOptions options,
                     double mass, const Water& water) {
  const ShipParticulars ship = afloat(drawn, {.mass = mass, .level = true}, water).ship;
  naming(mesh, [&] {
    StillWater still(ship);
    const double volume = mass / water.density, whole = still.wholeVolume();
    if (volume >= whole || volume < kLightest * whole)
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("[mass] mass is {:.6g} kg, the whole hull displaces {:.6g} kg: "
                                   "it {}",
                                   mass, whole * water.density,
                                   volume >= whole ? "sinks"
                                                   : "hardly touches the water; is it "
                                                     "in kilograms, not in tonnes?"));
    const double height = still.afloat(volume, {.height = ship.cog.z()}).height - ship.cog.z();
    options.waterline -= height / drawn.file.metresPerUnit;
  });
  return options;
}

FloatingHull floating(const std::string& mesh, const PanelledHull& upright,
                      const MeshReadOptions& options, const Loading& loading, const Water& water,
                      double waterline) {
  const ShipParticulars ship = afloat(upright, loading, water).ship;
  FloatingAttitude rest;
  naming(mesh, [&] { rest = floatingAttitude(ship, !upright.symmetric || ship.cog.y() != 0.0); });
  FloatingHull made{options, Vec3::Zero()};
  made.options.trimDeg = rest.trim / kDegree;
  made.options.heelDeg = rest.heel / kDegree;
  // The hull turns about the point of its z axis that comes to lie on calm water.
  const Mat3 turn = Attitude{.roll = rest.heel, .pitch = rest.trim}.rotation();
  const double below = rest.height / turn(2, 2);  // that point, below the upright origin [m]
  const double unit = upright.file.metresPerUnit;
  made.options.waterline = options.waterline - below / unit;
  made.cog = turn * (ship.cog + below * Vec3::UnitZ());
  const double deeper = (made.options.waterline - waterline) * unit;
  say(fmt::format("{}: floats {:.3f} m {} than drawn, {:.2f} deg {}, {:.2f} deg to {}", mesh,
                  std::abs(deeper), deeper >= 0 ? "deeper" : "higher",
                  std::abs(made.options.trimDeg), rest.trim >= 0 ? "bow down" : "bow up",
                  std::abs(made.options.heelDeg), rest.heel >= 0 ? "starboard" : "port"));
  return made;
}

}  // namespace cutwater::command
