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

/// Whether a ship must lie about as it would float, as linear theory takes it.
enum class Balance { Needed, Free };
/// Warns on stderr where mass and displacement or centre of gravity and buoyancy do not balance.
/// @throws HydroError naming file, field and value; with Balance::Needed also where the mass is
///   more than a fifth off, or the ship would trim or heel by more than 3°.
ShipFile readShipFile(const std::string& path, Balance balance = Balance::Free);

}  // namespace cutwater::command
