#pragma once
#include "hydro/geometry/outer/GridPlanes.h"

namespace cutwater {

/// A first look at any surface in the water, on a uniform grid of some million nodes.
struct WaterSurvey {
  WaterGrid water;
  GridCrossings crossings;
  double spacing = 0.0;            ///< of the grid [m]
  Bounds wet;                      ///< of what is below water [m]
  double area = 0.0;               ///< of the outer surface below water [m²]
  double volume = 0.0;             ///< below water, by counting nodes [m³]
  Vec3 middle = Vec3::Zero();      ///< of that volume [m]
  double plateArea = 0.0;          ///< of faces with water on both sides [m²]
  Vec3 platePlace = Vec3::Zero();  ///< the middle of one of them
};

/// @param triangles      surface in hull axes; must outlive the result.
/// @param openTolerance  [m] slits up to twice as wide hold water back.
WaterSurvey surveyWater(const SurfaceMesh& triangles, double openTolerance);

/// Whether the outer surface below water that was surveyed is its own mirror image in y = 0. Faces
/// of one side may be divided otherwise than those of the other.
/// @param tolerance  [m] how near the images must lie.
bool isMirrorImage(const SurfaceMesh& triangles, const WaterSurvey& survey, double tolerance);

}  // namespace cutwater
