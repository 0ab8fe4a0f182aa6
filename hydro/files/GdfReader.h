#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// A hull read from a WAMIT file.
struct GdfSurface {
  SurfaceMesh mesh;       ///< mirror images included
  bool mirrored = false;  ///< ISY was 1
};

/// Reads WAMIT's low-order geometry: a header line; ULEN GRAV; ISX ISY; NPAN; then four vertices a
/// panel, in any wrapping. Each of the first three records begins on a new line and may carry text
/// after its numbers. ISX, ISY = 1 say that x = 0, y = 0 is a plane of symmetry; the images are
/// added here.
/// @param text  whole file.  @param name  for messages.
/// @throws HydroError FileMalformed, MeshEmpty, MeshNotFinite.
GdfSurface parseGdf(const std::string& text, const std::string& name);

}  // namespace cutwater
