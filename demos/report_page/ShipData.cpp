#include "demos/report_page/ShipData.h"

#include <cstdlib>

#include "demos/cutwater/output/Messages.h"
#include "demos/cutwater/output/ShipListing.h"
#include "demos/report_page/Encoding.h"
#include "demos/report_page/PanelData.h"
#include "hydro/Errors.h"
#include "hydro/base/Radians.h"
#include "hydro/ship/Afloat.h"
#include "hydro/ship/Righting.h"

namespace cutwater::page {

namespace {

// Rows as [name, value, unit], numbers as numbers.
void rowsJson(Json& json, const command::Listing& rows) {
  json.beginArray();
  for (const auto& [name, value, unit] : rows.rows()) {
    json.beginArray().value(name);
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') {
      json.value(value);
    } else {
      json.value(number);
    }
    json.value(unit).end();
  }
  json.end();
}

void hydrostaticsJson(Json& json, const ShipParticulars& ship) {
  if (ship.hull.faces.empty() && ship.wetSurface.faces.empty()) {
    json.null();
    return;
  }
  command::Listing rows;
  listHydrostatics(rows, ship, hydrostaticsOf(ship));
  rowsJson(json, rows);
}

// Null for a ship without a closed hull, or of which no trim balances.
void rightingJson(Json& json, const ShipParticulars& ship, const std::string& file) {
  if (ship.hull.faces.empty()) {
    json.null();
    return;
  }
  constexpr int kStep = 5;  // [deg]
  std::vector<double> heels, levers;
  try {
    Righting righting(ship, RightingTrim::Free);
    for (int heel = 0; heel <= 180; heel += kStep) {
      heels.push_back(heel);
      levers.push_back(righting.at(heel * kDegree).gz);
    }
  } catch (const HydroError& error) {
    command::warn(file + ": no righting levers on the page: " + error.what());
    json.null();
    return;
  }
  json.beginObject().key("heelDeg").list(heels).key("gz").list(levers).end();
}

}  // namespace

void hullJson(Json& json, const ShipParticulars& ship) {
  if (ship.hull.faces.empty()) {
    json.null();
    return;
  }
  const SurfaceMesh triangles = triangulated(ship.hull);
  std::vector<double> points;
  for (const Vec3& vertex : triangles.vertices) {
    const Vec3 place = vertex - ship.cog;
    points.insert(points.end(), place.begin(), place.end());
  }
  std::vector<std::uint32_t> faces;
  for (const Face& face : triangles.faces) {
    for (int i = 0; i < 3; ++i) faces.push_back(static_cast<std::uint32_t>(face[i]));
  }
  json.beginObject().key("points");
  blob32(json, points);
  json.key("faces");
  blobOf(json, faces);
  json.end();
}

void shipJson(Json& json, const Coefficients& c, const std::string& file) {
  const ShipParticulars& ship = c.ship;
  json.beginObject().field("name", ship.name).field("mass", ship.mass);
  json.key("cog").list({ship.cog.data(), 3}).key("gyradii").list({ship.gyradii.data(), 3});
  json.field("gravity", ship.gravity).field("density", ship.density);
  json.field("length", ship.length()).field("beam", ship.beam());
  json.field("draught", ship.draught()).field("symmetric", ship.symmetric);
  command::Listing rows;
  listShip(rows, ship);
  json.key("particulars");
  rowsJson(json, rows);
  json.key("hydrostatics");
  hydrostaticsJson(json, ship);
  json.key("hull");
  hullJson(json, ship);
  json.key("panels");
  panelsJson(json, c);
  json.key("righting");
  rightingJson(json, ship, file);
  json.end();
}

}  // namespace cutwater::page
