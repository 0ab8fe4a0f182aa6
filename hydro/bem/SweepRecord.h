#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "hydro/bem/settings/SolveSettings.h"
#include "hydro/database/SolverOutput.h"

namespace cutwater {

/// Hash of a mesh: two databases of the same panels have the same.
std::string hashOf(const SurfaceMesh& mesh);

/// Hash of all that a finished frequency depends on.
std::uint64_t journalKey(const CoefficientTables& c, const SolveSettings& settings);

/// All numbers of frequency i in a row, and back. Sizes are those that `c` has room for.
std::vector<double> packed(CoefficientTables& c, std::size_t i);
void unpack(const std::vector<double>& numbers, CoefficientTables& c, std::size_t i);

}  // namespace cutwater
