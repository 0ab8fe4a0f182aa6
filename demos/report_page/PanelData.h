#pragma once
#include "demos/report_page/Json.h"
#include "hydro/database/Coefficients.h"

namespace cutwater::page {

/// "panels": the solver's panels of both sides and of the lid, about G, with their aspect ratio and
/// pressures; null without a wet surface.
///
/// Pressure of the waves that the ship radiates follows from the adjoint vectors b. By reciprocity
/// b_j,i = iρ∫φ_j dS over panel i, φ_j the potential of mode j at unit velocity, so that a unit
/// amplitude of it presses with
///     |p| = ω_e² |b_j,i| / S_i     [Pa/m, Pa/rad]
void panelsJson(Json& json, const Coefficients& coefficients);

}  // namespace cutwater::page
