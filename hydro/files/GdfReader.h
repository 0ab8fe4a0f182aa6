#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// WAMIT low-order geometry: a header line; ULEN GRAV; ISX ISY; NPAN; then four vertices a panel,
/// in any wrapping. Each of the first three records begins on a new line and may carry text after
/// its numbers. ISX, ISY = 1: x = 0, y = 0 is a plane of symmetry, and the images are added here.
/// @param text  whole file.  @param name  for messages.
/// @throws HydroError FileMalformed, MeshEmpty, MeshNotFinite. Not installed; used by MeshIO.cpp.
struct GdfSurface {
  SurfaceMesh mesh;
  bool mirrored = false;  ///< ISY was 1
};
GdfSurface parseGdf(const std::string& text, const std::string& name);

}  // namespace cutwater
