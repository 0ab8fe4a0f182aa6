#pragma once
#include <string>

#include "hydro/files/MeshIO.h"

namespace cutwater::command {

/// A hull whose volume can be trusted, repaired if that goes.
struct HullVolume {
  SurfaceMesh surface;  ///< hull axes [m]
  bool symmetric = false;
  FilePlacement file = {};
  std::string problem;  ///< why it is not repaired; empty if it is
};
/// The repaired hull; where the repair refuses, the faces as they are, if the volumes below calm
/// water by x, by y and by z agree within 1 % and are not those of thin planks alone.
/// @throws HydroError what the repair says if they do not.
HullVolume readHullVolume(const std::string& mesh, const MeshReadOptions& options);

/// The waterline, in the file's unit, at which the hull displaces `volume` [m³].
/// @param start  where the search begins; options.waterline is not read.
/// @param highest  beyond which water would come in, or the hull ends; the file's unit.
/// @throws HydroError ValueOutOfRange if the hull carries less up to there; as readHullVolume.
double waterlineFor(const std::string& mesh, MeshReadOptions options, double volume, double start,
                    double highest);

}  // namespace cutwater::command
