#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// Strict readers of two simple formats. Assimp 5.2.5 hangs on a PLY header that ends early, reads
/// beyond damaged binary PLY data, and replaces bad OFF indices by others; here every count, index
/// and number is checked. Polygons are divided as by addPolygon.
namespace cutwater {

/// Reads PLY, text and both binary kinds; `vertex` x, y, z and `face` vertex_indices (or
/// vertex_index), all else skipped.
/// @param file  whole file.  @param name  for messages.
/// @throws HydroError FileMalformed, MeshNotFinite, MeshIndexOutOfRange.
SurfaceMesh parsePly(const std::string& file, const std::string& name);

/// Reads OFF and its variants with more numbers a vertex (COFF, NOFF, …); those are skipped.
/// @throws as parsePly.
SurfaceMesh parseOff(const std::string& file, const std::string& name);

}  // namespace cutwater
