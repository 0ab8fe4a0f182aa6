#pragma once
#include <string>

#include "hydro/files/MeshIO.h"

namespace cutwater::command {

/// A hull whose volume can be trusted.
struct HullVolume {
  SurfaceMesh surface;  ///< hull axes [m]
  bool symmetric = false;
  FilePlacement file = {};
};
/// The repaired hull; where the repair refuses, the outer surface that keeps the water out.
/// @throws HydroError as readAnyHull.
HullVolume readHullVolume(const std::string& mesh, const MeshReadOptions& options);

/// The waterline, in the file's unit, at which the hull displaces `volume` [m³].
/// @param start  where the search begins; options.waterline is not read.
/// @param highest  beyond which water would come in, or the hull ends; the file's unit.
/// @throws HydroError ValueOutOfRange if the hull carries less up to there; as readHullVolume.
double waterlineFor(const std::string& mesh, MeshReadOptions options, double volume, double start,
                    double highest);

}  // namespace cutwater::command
