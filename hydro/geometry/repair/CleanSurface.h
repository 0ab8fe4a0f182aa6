#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/Hull.h"

namespace cutwater {

/// A surface from anywhere as triangles that share their vertices: the first step to a hull.
struct CleanSurface {
  SurfaceMesh mesh;               ///< triangles, of both sides
  double size = 0.0;              ///< diagonal of the box around it [m]
  std::vector<std::string> done;  ///< one line each, for people; empty if nothing was wrong
};

/// Part of the size below which vertices are one: 1 mm on a ship of 100 m.
inline constexpr double kWeld = 1e-5;
/// Part of the length up to which a hole may be wide and a half hull off the centreplane.
inline constexpr double kWidestHole = 0.02;

/// Merges vertices closer than kWeld of the size, divides quadrilaterals by their first diagonal,
/// drops faces without area and doubles, and mirrors a half hull: all of it on one side, and with
/// Symmetry::Auto open along the centreplane below water for a third of its length.
/// @param name  of the file, for messages.
/// @throws HydroError, naming file and place: MeshEmpty, MeshNotFinite, MeshIndexOutOfRange,
///   HullNotInWater if it is wholly above water (below is said); HullNotSymmetric: Symmetry::Half
///   and vertices on both sides.
CleanSurface cleanSurface(const SurfaceMesh& raw, const std::string& name, Symmetry symmetry);

}  // namespace cutwater
