#pragma once
#include "demos/report_page/Json.h"
#include "hydro/database/Coefficients.h"

namespace cutwater::page {

/// A closed hull as triangles about G: {"points", "faces"}; null without one.
void hullJson(Json& json, const ShipParticulars& ship);

/// "ship": particulars, hydrostatics, hull, panels and righting levers. What a database of another
/// code lacks is null.
void shipJson(Json& json, const Coefficients& coefficients);

}  // namespace cutwater::page
