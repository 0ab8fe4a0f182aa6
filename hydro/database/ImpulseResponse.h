#pragma once
#include <vector>

#include "hydro/Conventions.h"

namespace cutwater {

/// K(iΔτ), i = 0, 1, …, for programs that read it from the file instead of making it from B; made
/// by RetardationMatrix::table.
struct ImpulseResponse {
  double step = 0.0;         ///< Δτ [s]
  std::vector<Mat6> values;  ///< [unit of B / s]
};

}  // namespace cutwater
