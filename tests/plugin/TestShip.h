#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater::test {

/// The floating half sphere of radius 5 m whose decay the IEA's task 10 compared: m = 261 800 kg,
/// ρ = 1000, g = 9.81, G 2 m below calm water, C33 = 7.695e5 N/m. Surge, sway and heave
/// coefficients are the analytic ones (tests/memory/hemisphere_hulme.csv), so no solver is
/// involved; the spin of a sphere makes no waves. Wave forces for every heading are a smooth
/// stand-in of the right size.
Coefficients hemisphere();

/// A slender ship of 4000 t and 110 m with added mass and damping in all modes, sway and yaw, heave
/// and pitch coupled, A(ω) that belongs to B(ω); Tuck's form, so that it has terms of speed. Waves
/// as hemisphere().
Coefficients slenderShip();

inline constexpr double kSphereGravity = 9.81;

}  // namespace cutwater::test
