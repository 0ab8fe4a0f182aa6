#pragma once
#include "hydro/database/Coefficients.h"

namespace cutwater {

/// What the panel solver returns (bem/BuildCoefficients.h): A and B not symmetric, irregular
/// frequencies not masked, frequencies that the panels do not resolve still among the others. It
/// cannot be written to a file or used in the time domain; `finish` (finish/Finish.h) makes
/// `Coefficients` of it.
struct SolverOutput : CoefficientTables {
  SolverOutput() = default;
};

}  // namespace cutwater
