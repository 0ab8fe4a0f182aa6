#include "demos/report_page/Page.h"

#include <cmath>
#include <set>

#include "demos/cutwater/output/Messages.h"
#include "demos/report_page/Gates.h"
#include "demos/report_page/Json.h"
#include "demos/report_page/RunData.h"
#include "demos/report_page/ShipData.h"
#include "demos/report_page/Tables.h"
#include "demos/report_page/Template.h"
#include "hydro/Errors.h"
#include "hydro/database/CoefficientsFile.h"

namespace cutwater::page {

namespace {

// As web/index.html has it; the ends of the tags tell it from what scripts say of it.
constexpr std::string_view kMarker = ">/*CUTWATER-DATA*/<";

// At rest, and those of the runs of the page's ship.
std::set<double> speedsOf(const std::vector<ShownRun>& runs) {
  std::set<double> speeds{0.0};
  for (const ShownRun& run : runs)
    if (run.of && run.ofPage) speeds.insert(run.file.start.speed);
  return speeds;
}

// First of all, so that a run that does not fit is refused before long work.
std::string runsJson(const std::vector<ShownRun>& runs, const Coefficients& c) {
  Json json;
  json.beginArray();
  for (const ShownRun& run : runs)
    runJson(json, run, run.of ? run.of->ship.gravity : c.ship.gravity);
  return json.end().text();
}

}  // namespace

std::string pageData(const std::string& database, const std::vector<std::string>& runs) {
  std::string warning;
  const Coefficients c = readCoefficients(database, &warning);
  command::warn(warning);
  command::warnOfResonances(database, c);
  std::vector<ShownRun> shown;
  for (const std::string& run : runs) shown.push_back(readShownRun(run, database, c));
  const std::string ofRuns = runsJson(shown, c);
  Json json;
  command::naming(database, [&] {
    json.beginObject().field("format", 1).field("title", c.ship.name);
    json.field("version", CUTWATER_VERSION).key("ship");
    shipJson(json, c, database);
    json.key("coefficients");
    coefficientsJson(json, c);
    json.key("excitation");
    excitationJson(json, c, database);
    json.key("retardation");
    retardationJson(json, c, database);
    json.key("raos");
    raosJson(json, c, database, speedsOf(shown));
    json.key("gates");
    gatesJson(json, c);
  });
  return json.key("runs").raw(ofRuns).end().text();
}

void requirePage() {
  const std::string_view text = pageTemplate();
  if (text.find(kMarker) != std::string_view::npos) return;
  throw HydroError(Fault::FileNotReadable,
                   "report: this program was built without the page: " + std::string(text));
}

std::string pageWith(const std::string& data) {
  requirePage();
  std::string page(pageTemplate());
  return page.replace(page.find(kMarker) + 1, kMarker.size() - 2, data);
}

}  // namespace cutwater::page
