#pragma once
#include <string>

#include "demos/report_page/Json.h"
#include "hydro/database/Coefficients.h"

namespace cutwater::page {

/// A closed hull as triangles about G: {"points", "faces"}; null without one.
void hullJson(Json& json, const ShipParticulars& ship);

/// "ship": particulars, hydrostatics, hull, panels and righting levers. What a database of another
/// code lacks is null.  @param file  its database, for warnings.
void shipJson(Json& json, const Coefficients& coefficients, const std::string& file);

}  // namespace cutwater::page
