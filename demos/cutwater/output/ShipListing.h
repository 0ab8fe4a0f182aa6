#pragma once
#include <string>

#include "demos/cutwater/output/Listing.h"
#include "hydro/database/Coefficients.h"
#include "hydro/geometry/Hydrostatics.h"

/// What more than one command tells of a ship and its database.
namespace cutwater::command {

/// What the ship is: mass, centre of gravity, gyradii, water, hull file, what is added to it.
void listShip(Listing& rows, const ShipParticulars& ship);
void listHydrostatics(Listing& rows, const ShipParticulars& ship, const Hydrostatics& h);

/// Length, beam and draught of the panels of both sides, their volume and the hull's [m³].
std::string sizeText(const SurfaceMesh& wholeWet, double hullVolume);

/// Largest distance of A(∞) of the ω = ∞ problem itself from the one in use, in % of √(A_jj A_kk).
double infinityDifference(const Coefficients& coefficients);
/// Of `table`, called "added_mass" or "damping", as the solver found it if the file tells [%]; the
/// matrices themselves are symmetrised in ours.
double solversAsymmetry(const Coefficients& coefficients, const std::string& name,
                        const OverFrequency<Mat6>& table);

}  // namespace cutwater::command
