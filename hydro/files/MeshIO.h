#pragma once
#include <string>

#include "hydro/geometry/anyhull/AnyHull.h"
#include "hydro/geometry/repair/CrackedHull.h"
#include "hydro/geometry/repair/MeshRepair.h"

/// Hulls from mesh files.
///     const RepairedHull ship = readRepaired("yacht.glb", {.up = "y", .forward = "-z"});
///     for (const std::string& line : ship.done) std::puts(line.c_str());
namespace cutwater {

/// How the axes and units of a file are to be read.
struct MeshReadOptions {
  std::string up = "z";       ///< the file's axis that points up: "x", "-x", "y", "-y", "z", "-z"
  std::string forward = "x";  ///< the file's axis that points to the bow
  std::string unit = "m";     ///< "m", "mm", "cm", "ft" or "in"
  double waterline = 0.0;     ///< height of calm water along `up`, in the file's unit
  double trimDeg = 0.0;       ///< bow down; the hull turns about the point on calm water at (0, 0)
  double heelDeg = 0.0;       ///< starboard down, about the same point: R = R_y(trim) R_x(heel)
  bool anyFormat = false;  ///< any other format that Assimp reads; its rare importers are less safe
  std::string symmetric = "auto";  ///< "auto", "none" or "half"
};

/// How a file's own axes lie in hull axes with these options; readHull and readRepaired note it in
/// Hull::file. The file's own axes are those after its scene nodes are placed and, in COLLADA, its
/// element `unit` is turned to metres, as engines do when they load such a file.
/// @throws HydroError BadArgument, ValueOutOfRange, naming the option.
FilePlacement filePlacement(const MeshReadOptions& options);

/// The faces of a file in hull axes, before any check of the hull: x forward, y port, z up from
/// calm water. By the file's ending (any case): .obj .stl (binary or text) .ply .gltf .glb .off
/// .dae .gdf (WAMIT, low order, its symmetries applied). Quadrilaterals stay; polygons of more
/// corners and re-entrant quadrilaterals are divided; the transformations of scene nodes are
/// applied; points and lines are ignored. COLLADA is read with its own unit and up axis as written,
/// so `up` says what the file says. Nothing is written to the terminal.
/// @throws HydroError, one line naming file and value: FileNotReadable, FormatNotSupported,
///   FileMalformed, MeshEmpty, MeshNotFinite, MeshIndexOutOfRange; BadArgument, ValueOutOfRange for
///   the options.
SurfaceMesh readSurface(const std::string& path, const MeshReadOptions& options = {});

/// readSurface, then makeHull. @throws what they throw.
Hull readHull(const std::string& path, const MeshReadOptions& options = {});

/// readSurface, then crackedHull. @throws what they throw.
CrackedHull readCracked(const std::string& path, const MeshReadOptions& options = {});

/// readSurface, then repairedHull. @throws what they throw.
RepairedHull readRepaired(const std::string& path, const MeshReadOptions& options = {});

/// readSurface, then anyHull with `count` panels a side. @throws what they throw.
AnyHull readAnyHull(const std::string& path, int count, const MeshReadOptions& options = {},
                    PanelsBy by = PanelsBy::Auto);

/// Writes Wavefront OBJ: to a temporary file beside it, then renamed, so that it is whole or not
/// there.
/// @param comment  put on top, line by line.
/// @throws HydroError FileNotWritable.
void writeObj(const std::string& path, const SurfaceMesh& mesh, const std::string& comment = {});

}  // namespace cutwater
