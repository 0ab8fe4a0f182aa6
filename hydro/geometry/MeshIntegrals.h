#pragma once
#include "hydro/geometry/SurfaceMesh.h"

/// Volume, area and waterplane of a hull from its surface alone, by the divergence theorem. Exact
/// for flat faces; a twisted quadrilateral counts as the mean of its two triangulations. O(faces).
namespace cutwater {

/// V = ∫ z n_z dS and ∫ x dV, ∫ y dV = ∫ (x, y) z n_z dS, ∫ z dV = ∫ ½z² n_z dS. In this form,
/// parts of the surface that are missing on z = 0 or on a vertical plane (the centreline of a half
/// hull) would add nothing: it holds for closed surfaces and for wet hulls alike. Negative if
/// normals point inwards.
/// THEORY.md, chapter 2.
struct VolumeIntegrals {
  double volume = 0.0;         ///< [m³]
  Vec3 moment = Vec3::Zero();  ///< ∫ r dV [m⁴]
  /// [m]; not finite for a surface that encloses nothing.
  Vec3 centroid() const { return moment / volume; }
};
VolumeIntegrals volumeIntegrals(const SurfaceMesh& mesh);

/// Sum of the face areas [m²].
double surfaceArea(const SurfaceMesh& mesh);

/// Integrals over the waterplane of a surface that is open at z = 0: ∫ f dA = −∫ f(x, y) n_z dS
/// over the hull below, since f does not depend on z. Zero for a closed surface.
struct WaterplaneIntegrals {
  double area = 0.0;                    ///< [m²]
  double x = 0.0, y = 0.0;              ///< ∫ x dA, ∫ y dA [m³]
  double xx = 0.0, xy = 0.0, yy = 0.0;  ///< ∫ x² dA, … [m⁴] about the origin
};
WaterplaneIntegrals waterplaneIntegrals(const SurfaceMesh& wet);

}  // namespace cutwater
