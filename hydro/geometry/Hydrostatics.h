#pragma once
#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// Volume, centres, metacentric heights and restoring matrix of a hull at rest.
///     const SurfaceMesh wet = wholeWet(panelledAsItIs(readHull("frigate.obj")));  // ship/Afloat.h
///     const Hydrostatics h = hydrostatics(wet, {0, 0, 1.29}, kSeaWaterDensity, kStandardGravity);
///     std::printf("GM %.2f m, draught %.2f m\n", h.gmT, h.draft);
///
/// Positions in hull axes (x forward, y port, z up from calm water); lengths are those of
/// the wet surface.
/// THEORY.md, chapter 2.
struct Hydrostatics {
  double volume = 0.0;            ///< V [m³]
  double displacement = 0.0;      ///< ρV [kg]
  double wettedArea = 0.0;        ///< [m²]
  double waterplaneArea = 0.0;    ///< [m²]
  Vec3 buoyancy = Vec3::Zero();   ///< centre of buoyancy [m]; lcb is its x
  Vec3 flotation = Vec3::Zero();  ///< centroid of the waterplane [m]; lcf is its x
  double kb = 0.0;                ///< centre of buoyancy above the keel (the lowest point) [m]
  double bmT = 0.0, bmL = 0.0;    ///< metacentric radii [m]: inertia of the waterplane about its
                                  ///< centroid, over V
  double gmT = 0.0, gmL = 0.0;    ///< z_B + BM − z_G [m]
  double draft = 0.0;             ///< depth of the lowest point [m]
  double length = 0.0;            ///< of the waterline, along x [m]
  double beam = 0.0;              ///< of the waterline, along y [m]
  Mat6 restoring = Mat6::Zero();  ///< C about G [N/m, N, N m]
};

/// Hydrostatics of a wet surface. With x, y measured from G and z from calm water:
///     C33 = ρg A         C34 = ρg ∫y dA                C35 = −ρg ∫x dA
///     C44 = ρg[∫y² dA + V(z_B − z_G)]    C45 = −ρg ∫xy dA    C46 = −ρgV (x_B − x_G)
///     C55 = ρg[∫x² dA + V(z_B − z_G)]    C56 = −ρgV (y_B − y_G),   the rest by symmetry or 0
/// Weight acts in G: it has no moment about G and the mass does not enter, so the matrix holds for
/// m ≠ ρV as well. C46 and C56 (not C64, C65) vanish for a ship that floats level.
/// [Newman 1977, 6.16], with moments about G.
/// @param wet  the whole surface below calm water, both sides, open on z = 0 only.
/// @param centreOfGravity [m], density [kg/m³], gravity [m/s²].
/// @throws HydroError HullNotInWater if it encloses no volume or has no waterplane,
///         ValueOutOfRange for density or gravity ≤ 0.
Hydrostatics hydrostatics(const SurfaceMesh& wet, const Vec3& centreOfGravity, double density,
                          double gravity);

}  // namespace cutwater
