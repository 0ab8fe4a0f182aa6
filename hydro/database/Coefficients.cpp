#include "hydro/database/Coefficients.h"

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/geometry/panels/WetSurface.h"

namespace cutwater {

WetSurface CoefficientTables::wet() const& noexcept {
  return {ship.wetSurface, ship.symmetric, panelShape};
}

std::string Provenance::setting(const std::string& key) const {
  const std::size_t at = settings.find(key + " = ");
  if (at == std::string::npos) return {};
  const std::size_t from = at + key.size() + 3,
                    end = std::min(settings.find('\n', from), settings.size());
  std::string value = settings.substr(from, end - from);
  std::erase(value, '"');
  return value;
}

void requireFinished(const Coefficients& coefficients, const char* forWhat) {
  if (coefficients.status != CoefficientStatus::Unfinished) return;
  throw HydroError(
      Fault::DatabaseIncomplete,
      std::string(forWhat) + ": the database is unfinished: " + coefficients.unfinishedBecause);
}

}  // namespace cutwater
