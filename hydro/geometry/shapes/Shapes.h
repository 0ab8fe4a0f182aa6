#pragma once
#include "hydro/geometry/SurfaceMesh.h"

/// Hulls known by a formula: box, ellipsoid, sphere, Wigley hulls, a frigate.
///     const SurfaceMesh wet = wetWigley(wigley(3), 40, 10);           // port half below water
///     const SurfaceMesh hull = closedWigley(wigley(3), 0.1, 40, 10);  // watertight, with deck
///
/// Every mesh is inscribed: its vertices lie on the surface, unscaled, so that volume and area
/// approach the formula's from below at second order in the panel size.
/// `wet…` is the port half (y ≥ 0) below calm water, normals out, ready for makePanels(·, true).
/// `closed…` is the whole watertight hull, both sides with deck: the same faces below water first
/// (port, then, mirrored, starboard), continued above it, with waterline vertices on z = 0 exactly.
/// One such file serves the solver "as is", nonlinear buoyancy and collision.
/// All throw HydroError BadArgument for counts below 1 and ValueOutOfRange for lengths ≤ 0.
namespace cutwater {

/// Box amidships at x = 0, with `freeboard` above water; faces divided in nx × (half breadth)
/// ny × (draft) nz. Lengths in m.
struct BoxShape {
  double length, breadth, draft, freeboard;
};
SurfaceMesh wetBox(const BoxShape& box, int nx, int ny, int nz);
SurfaceMesh closedBox(const BoxShape& box, int nx, int ny, int nz);

/// Half ellipsoid x²/a² + y²/b² + z²/c² = 1, z ≤ 0, poles at bow and stern: stations at equal steps
/// of the eccentric angle (dense at the ends), girthwise equal steps of angle. V = ⅔π a b c,
/// waterplane π a b, centroid −⅜ c. The closed form is wall-sided above water, with deck.
struct EllipsoidShape {
  double a, b, c;  ///< [m]
};
SurfaceMesh wetHalfEllipsoid(const EllipsoidShape& e, int along, int girth);
SurfaceMesh closedHalfEllipsoid(const EllipsoidShape& e, double freeboard, int along, int girth);

/// Floating hemisphere, pole at the bottom: `around` meridian strips on the port half times `down`
/// rings. 27 × 16 = 432 and 40 × 26 = 1040 give panels of mean aspect 1.
SurfaceMesh wetHemisphere(double radius, int around, int down);
/// Whole sphere whose centre lies on calm water.
SurfaceMesh closedSphere(double radius, int around, int down);

/// Journée's Wigley hulls: with ξ = 2x/L, ζ = −z/T
///     2y/B = (1 − ζ²)(1 − ξ²)(1 + 0.2 ξ²) + α ζ²(1 − ζ⁸)(1 − ξ²)⁴        [Journée 1992]
struct WigleyShape {
  double length, breadth, draft, alpha;
};
/// Hull I, II, III or IV of the report: L = 3 m, T = 0.1875 m. @throws BadArgument otherwise.
WigleyShape wigley(int hull);
SurfaceMesh wetWigley(const WigleyShape& hull, int along, int girth);
/// Wall-sided above water.
SurfaceMesh closedWigley(const WigleyShape& hull, double freeboard, int along, int girth);

/// FRIGATE-124, a formula hull with the particulars of a frigate: L 124.5 m, B 14.8 m, T 4.97 m, V
/// 4509 m³; x forward from midships. Round bilge, raked bow, transom that is dry in calm water: at
/// the aft end of the waterline the keel line rises to z = 0, so the last wet panels end on the
/// waterplane. `along` stations × `girth` strips; quadrilaterals but for the fan at the stem and
/// one split corner at the transom: along × girth + 1 panels a side.
/// @param crowding  strips closer together towards calm water, from 1 − crowding to 1 + crowding of
///   their mean width; 0: all of equal girth. The default is that of closedFrigate.
SurfaceMesh wetFrigate(int along, int girth, double crowding = 0.6);
SurfaceMesh closedFrigate(int along, int girth);
/// Stations and strips of the panel meshes in use: 224, 433 or 1040 a side (±2); for any other
/// count the division whose panels are about twice as long as their girth.
struct FrigateDivision {
  int along, girth;
};
FrigateDivision frigateDivision(int panelsPerSide);

}  // namespace cutwater
