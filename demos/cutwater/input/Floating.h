#pragma once
#include "hydro/files/MeshIO.h"
#include "hydro/ship/Afloat.h"

namespace cutwater::command {

/// Options with which the mesh stands in the water; if it does not with these, three tenths of its
/// height deep.
MeshReadOptions inWater(const std::string& mesh, MeshReadOptions options);

/// Options with which a hull displaces `mass` [kg], upright.
/// @param drawn  the hull as it was read with `options`.
/// @throws HydroError naming the mesh: why it does not float.
MeshReadOptions sunk(const std::string& mesh, const PanelledHull& drawn, MeshReadOptions options,
                     double mass, const Water& water);

/// How a hull is to be read so that it floats, and where its centre of gravity then is.
struct FloatingHull {
  MeshReadOptions options;  ///< waterline, trim and heel that were found
  Vec3 cog;                 ///< [m], in the axes of the hull as it floats
};

/// Lets a hull with a closed surface float: sinkage, trim and, unless it is symmetric with G in the
/// centreplane, heel. What was found is said.
/// @param upright  the hull as it was read with `options`, which turn it not.
/// @param loading  mass and cog [m] in the axes of that hull.
/// @param waterline  of the drawing, for what is said [the file's unit].
/// @throws HydroError naming the mesh: why it does not float.
FloatingHull floating(const std::string& mesh, const PanelledHull& upright,
                      const MeshReadOptions& options, const Loading& loading, const Water& water,
                      double waterline);

}  // namespace cutwater::command
