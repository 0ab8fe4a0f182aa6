#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/outer/WaterSurvey.h"
#include "hydro/geometry/repair/CleanSurface.h"

namespace cutwater {

/// A surface that holds the water out, as far as it can be made to.
struct TightSurface {
  SurfaceMesh mesh;    ///< triangles
  WaterSurvey survey;  ///< of it, with slitTolerance
  std::vector<std::string> done;
};

/// Slits between loose edges [m] that hold water back, twice this wide.
double slitTolerance(const SurfaceMesh& mesh);

/// Closes holes up to kWidestHole of the length where water gets in through them; a hole that lets
/// no water in (of an inner skin, a plate) stays as it is.
/// @throws HydroError HullNotClosed, naming the place, where water is on both sides of most faces.
TightSurface withoutLeaks(const SurfaceMesh& clean, const std::string& name);

}  // namespace cutwater
