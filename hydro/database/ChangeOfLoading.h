#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// The database of the same hull on the same waterline with another loading, without solving again:
///     const Coefficients heavier = withLoading(ship, mass, {-2.4, 0, 1.5}, {5.9, 29, 29});
/// Gives exactly what the solver would about the new centre of gravity G′ = G + d.
/// n′_{4..6} = n_{4..6} − d × n, so with
///     P = [ I  0 ; −[d×]  I ]    n′ = P n,  φ′ = P φ,  Z′ = P Z Pᵀ
/// for A, B, ∂A, ∂B and their limits; rows of the adjoint vectors transform with P; tables of F_I
/// and F_D also get the phase e^{ik(d_x cos β − d_y sin β)} of a crest over G′. The waterplane's
/// part of C transforms as Z does; buoyancy and weight act at their new distance. Supplementary
/// terms keep their values, now about G′.
/// @param mass [kg] > 0; must equal ρV to 0.1 %, or be no further from it than the mass before.
/// @param cog G′ in hull axes [m]; must stand over the centre of buoyancy to 0.1 % of the length
///             along and of the beam across, or be no further off than G before. Otherwise the ship
///             would trim or heel, and that is another wetted surface.
/// @param gyradii [m] about G′, > 0 (0 where the database has 0: not known).
/// @throws HydroError ValueOutOfRange naming value and bound; BadArgument if y_G moves on a hull
///         solved by its half (even and odd modes mix).
Coefficients withLoading(const Coefficients& coefficients, double mass, const Vec3& cog,
                         const Vec3& gyradii);

}  // namespace cutwater
