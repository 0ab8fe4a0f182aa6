#include "demos/cutwater/input/Floating.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/cutwater/output/Messages.h"
#include "hydro/Errors.h"
#include "hydro/base/Radians.h"
#include "hydro/ship/FloatingAttitude.h"

namespace cutwater::command {

FloatingHull floating(const std::string& mesh, const PanelledHull& drawn,
                      const MeshReadOptions& options, const Loading& loading, const Water& water) {
  const ShipParticulars ship = afloat(drawn, loading, water).ship;
  FloatingAttitude rest;
  naming(mesh, [&] { rest = floatingAttitude(ship, !drawn.symmetric || ship.cog.y() != 0.0); });
  FloatingHull made{options, Vec3::Zero()};
  made.options.trimDeg = rest.trim / kDegree;
  made.options.heelDeg = rest.heel / kDegree;
  // The hull turns about the point of its z axis that comes to lie on calm water.
  const Mat3 turn =
      (Eigen::AngleAxisd(rest.trim, Vec3::UnitY()) * Eigen::AngleAxisd(rest.heel, Vec3::UnitX()))
          .toRotationMatrix();
  const double below = rest.height / turn(2, 2);  // that point, below the origin as drawn [m]
  made.options.waterline = options.waterline - below / drawn.file.metresPerUnit;
  made.cog = turn * (ship.cog + below * Vec3::UnitZ());
  say(fmt::format("{}: floats {:.3g} m {} than drawn, {:.2f} deg {}, {:.2f} deg to {}", mesh,
                  std::abs(rest.height), rest.height > 0 ? "higher" : "deeper",
                  std::abs(made.options.trimDeg), rest.trim >= 0 ? "bow down" : "bow up",
                  std::abs(made.options.heelDeg), rest.heel >= 0 ? "starboard" : "port"));
  return made;
}

}  // namespace cutwater::command
