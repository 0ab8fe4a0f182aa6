#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// Strict readers of two simple formats, made because Assimp 5.2.5 hangs on a PLY header that ends
/// early, reads beyond damaged binary PLY data, and replaces bad OFF indices by others. Every
/// count, index and number is checked. Not installed; used by MeshIO.cpp. Polygons are divided as
/// by addPolygon.
/// @param file  whole file.  @param name  for messages.
/// @throws HydroError FileMalformed, MeshEmpty, MeshNotFinite, MeshIndexOutOfRange.
namespace cutwater {

/// Text and both binary kinds; `vertex` x, y, z and `face` vertex_indices (or vertex_index), all
/// else skipped.
SurfaceMesh parsePly(const std::string& file, const std::string& name);

/// OFF and its variants with more numbers a vertex (COFF, NOFF, …); those are skipped.
SurfaceMesh parseOff(const std::string& file, const std::string& name);

}  // namespace cutwater
