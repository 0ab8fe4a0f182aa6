#pragma once
#include <vector>

#include "hydro/database/Coefficients.h"

namespace cutwater::command {

/// The wave frequencies at which tables of a database are written unless others are asked for.
inline const std::vector<double>& defaultWaveOmega(const Coefficients& coefficients) {
  return coefficients.waveOmega.empty() ? coefficients.omega : coefficients.waveOmega;
}

}  // namespace cutwater::command
