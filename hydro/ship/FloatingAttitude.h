#pragma once
#include "hydro/ship/ShipParticulars.h"

namespace cutwater {

/// How a ship comes to rest in calm water, from how its hull is drawn.
///     const FloatingAttitude rest = floatingAttitude(ship, false);
struct FloatingAttitude {
  double height = 0.0;  ///< of the origin of hull axes above calm water [m]
  double trim = 0.0;    ///< bow down [rad]
  double heel = 0.0;    ///< starboard down [rad]
};

/// Where weight and buoyancy balance: ρV = m, and the centre of buoyancy lies below G.
/// @param ship     hull (closed), mass, cog, density and gravity are read.
/// @param mayHeel  looks for the heel as well, within 45°; else it is 0, as of a symmetric ship
///                 with its G in the centreplane.
/// @throws HydroError as Righting; ValueOutOfRange if it has no stable heel there.
FloatingAttitude floatingAttitude(const ShipParticulars& ship, bool mayHeel);

}  // namespace cutwater
