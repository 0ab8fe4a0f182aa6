#pragma once
#include <string>
#include <vector>

#include "demos/cutwater/input/RunFile.h"
#include "demos/report_page/Json.h"
#include "demos/report_page/RunColumns.h"
#include "hydro/database/Coefficients.h"

namespace cutwater::page {

/// A RUN.toml, and the CSV of the same stem beside it that `simulate` or `sweep` wrote of it.
struct ShownRun {
  command::RunFile file;
  RunKind kind = RunKind::Simulate;
  std::string csv;                 ///< its path
  std::optional<Coefficients> of;  ///< its ship; absent for a body that is no ship
  bool ofPage = true;              ///< that is the page's ship
  const ShipParticulars* ship() const { return of ? &of->ship : nullptr; }
};

/// Reads RUN.toml and what it names, but not yet the rows of the CSV.
/// @param database  the page's, `coefficients` what it holds: a body swims in its water.
/// @throws HydroError naming file, field or column, and value.
ShownRun readShownRun(const std::string& path, const std::string& database,
                      const Coefficients& coefficients);

/// One of "runs".
/// @throws HydroError naming the CSV, line, column and value.
void runJson(Json& json, const ShownRun& run, double gravity);

}  // namespace cutwater::page
