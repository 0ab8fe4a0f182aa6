#include "hydro/database/Coefficients.h"

#include "hydro/Errors.h"

namespace cutwater {

void requireFinished(const Coefficients& coefficients, const char* forWhat) {
  if (coefficients.status != CoefficientStatus::Unfinished) return;
  throw HydroError(
      Fault::DatabaseIncomplete,
      std::string(forWhat) + ": the database is unfinished: " + coefficients.unfinishedBecause);
}

}  // namespace cutwater
