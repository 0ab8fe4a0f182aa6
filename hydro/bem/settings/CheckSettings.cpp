#include "hydro/bem/settings/CheckSettings.h"

#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/Radians.h"

namespace cutwater {

void check(const ShipParticulars& ship, const SolveSettings& settings) {
  if (ship.wetSurface.faces.empty())
    throw HydroError(Fault::MeshEmpty, "buildCoefficients: the wet surface has no faces");
  if (settings.omega.empty())
    throw HydroError(Fault::BadArgument, "buildCoefficients: no frequencies");
  double before = 0.0;
  for (const double omega : settings.omega) {
    if (!std::isfinite(omega) || omega <= before)
      throw HydroError(std::isfinite(omega) && omega > 0.0 ? Fault::FrequenciesNotIncreasing
                                                           : Fault::ValueOutOfRange,
                       "buildCoefficients: frequency " + std::to_string(omega) + " rad/s after " +
                           std::to_string(before) + "; they must rise from above 0");
    before = omega;
  }
  for (const double heading : settings.headings)
    requireRadians("buildCoefficients: a heading", heading, kTurn);
  for (const double speed : settings.speeds)
    if (!std::isfinite(speed))
      throw HydroError(Fault::ValueOutOfRange, "buildCoefficients: a speed is not finite");
  before = 0.0;
  for (const double omega : settings.waveOmega) {
    if (!std::isfinite(omega) || omega <= before)
      throw HydroError(Fault::ValueOutOfRange, "buildCoefficients: wave frequency " +
                                                   std::to_string(omega) + " rad/s after " +
                                                   std::to_string(before) +
                                                   "; they must rise from above 0");
    before = omega;
  }
  if (settings.influence != Influence::Adjoint &&
      (settings.speeds.empty() || settings.headings.empty() || settings.waveOmega.empty()))
    throw HydroError(Fault::BadArgument,
                     "buildCoefficients: a table of diffraction forces needs speeds, headings and "
                     "wave frequencies");
  if (settings.panelShape < PanelShape::Flat || settings.panelShape > PanelShape::Auto)
    throw HydroError(Fault::BadArgument, "buildCoefficients: panelShape " +
                                             std::to_string(static_cast<int>(settings.panelShape)) +
                                             " is not Flat, Curved or Auto");
  if (!(ship.density > 0.0) || !(ship.gravity > 0.0))
    throw HydroError(Fault::ValueOutOfRange,
                     "buildCoefficients: density " + std::to_string(ship.density) +
                         " kg/m³ and gravity " + std::to_string(ship.gravity) +
                         " m/s² must be above 0");
}

}  // namespace cutwater
