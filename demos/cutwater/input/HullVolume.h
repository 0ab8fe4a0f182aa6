#pragma once
#include <string>

#include "hydro/files/MeshIO.h"

namespace cutwater::command {

/// A hull whose volume can be trusted: repaired, or where the repair refuses the outer surface that
/// keeps the water out.
/// @throws HydroError as readAnyHull.
Hull readTrustedHull(const std::string& mesh, const MeshReadOptions& options);

/// The waterline, in the file's unit, at which the hull displaces `volume` [m³].
/// @param start  where the search begins; options.waterline is not read.
/// @param highest  beyond which water would come in, or the hull ends; the file's unit.
/// @throws HydroError ValueOutOfRange if the hull carries less up to there; as readTrustedHull.
double waterlineFor(const std::string& mesh, MeshReadOptions options, double volume, double start,
                    double highest);

}  // namespace cutwater::command
