#pragma once
#include <string>

#include "hydro/bem/settings/SolveSettings.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::command {

/// A SHIP.toml with its hull read and its equilibrium computed.
struct ShipFile {
  ShipParticulars particulars;  ///< complete: hull, mass, restoring
  Hydrostatics hydrostatics;
  SolveSettings solve;
};

/// Warns on stderr where mass and displacement or centre of gravity and buoyancy do not balance.
/// @throws HydroError naming file, field and value.
ShipFile readShipFile(const std::string& path);

}  // namespace cutwater::command
