#include "hydro/database/Coefficients.h"

#include "hydro/Errors.h"
#include "hydro/geometry/panels/WetSurface.h"

namespace cutwater {

WetSurface CoefficientTables::wet() const& noexcept {
  return {ship.wetSurface, ship.symmetric, panelShape};
}

void requireFinished(const Coefficients& coefficients, const char* forWhat) {
  if (coefficients.status != CoefficientStatus::Unfinished) return;
  throw HydroError(
      Fault::DatabaseIncomplete,
      std::string(forWhat) + ": the database is unfinished: " + coefficients.unfinishedBecause);
}

}  // namespace cutwater
