#pragma once
#include <string>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater::command {

/// What is drawn.
struct HullPicture {
  const SurfaceMesh& surface;  ///< both sides, hull axes [m], z = 0 at calm water
  bool symmetric;              ///< the body plan has the fore body right, the after body left
  std::string title;
  std::vector<std::string> lines;  ///< below the title
};

/// Profile, plan and body plan of a hull as one SVG. The groups `profile`, `plan` and `body` hold
/// paths in metres, hull axes; in each an element of class `waterline` is calm water.
std::string svgOf(const HullPicture& picture);

}  // namespace cutwater::command
