#pragma once
#include "hydro/files/MeshIO.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::command {

/// How a hull is to be read so that it floats, and where its centre of gravity then is.
struct FloatingHull {
  MeshReadOptions options;  ///< waterline, trim and heel that were found
  Vec3 cog;                 ///< [m], in the axes of the hull as it floats
};

/// Lets a hull with a closed surface float: sinkage, trim and, unless it is symmetric with G in the
/// centreplane, heel. What was found is said.
/// @param drawn  the hull as it was read with `options`, which turn it not.
/// @param loading  mass and cog [m] in the axes of that hull.
/// @throws HydroError naming the mesh: why it does not float.
FloatingHull floating(const std::string& mesh, const PanelledHull& drawn,
                      const MeshReadOptions& options, const Loading& loading, const Water& water);

}  // namespace cutwater::command
