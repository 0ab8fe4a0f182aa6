#pragma once
#include "demos/report_page/Json.h"
#include "hydro/database/Coefficients.h"

namespace cutwater::page {

/// "gates": what a good database meets, a number beside its limit each, and what to do where it
/// does not. `passes` is null where the number is to be looked at but nothing says how far it may
/// go, or where the database does not tell it.
///     symmetry         A_jk = A_kj and B_jk = B_kj, as the solver found them
///     Kramers-Kronig   A(∞) = A(ω) + (1/ω)∫K⁰ sin ωτ dτ is the same at every ω
///     memory           ∫₀^∞ K⁰ dτ = 0, as no wave is radiated at ω = 0
///     energy           B has no eigenvalue below 0, as waves take energy and give none
///     stability        no motion grows by itself at any speed
void gatesJson(Json& json, const Coefficients& coefficients);

}  // namespace cutwater::page
