#include "demos/report_figures/Report.h"

#include <cmath>
#include <filesystem>

#include "demos/cutwater/input/ShipFile.h"
#include "hydro/Errors.h"
#include "hydro/files/MeshIO.h"

namespace cutwater::report {

namespace {

std::vector<double> everyNth(double from, double step, int count, int every, int first) {
  std::vector<double> values;
  for (int i = first; i < count; i += every) values.push_back(from + step * i);
  return values;
}

/// The division `file` of the ship, G over its centre of buoyancy, no supplementary terms.
Mesh divided(int panels, const ShipParticulars& ship, const std::string& file) {
  Loading loading{.cog = ship.cog, .level = true, .gyradii = ship.gyradii};
  Afloat made = afloat(panelledAsItIs(readHull(file)), loading, {ship.density, ship.gravity});
  made.ship.name = ship.name;
  return {panels, std::move(made.ship), made.hydrostatics};
}

}  // namespace

std::vector<double> Job::omega() const { return everyNth(0.1, 0.1, 60, every, every - 1); }
std::vector<double> Job::waveOmega() const { return everyNth(0.2, 0.05, 37, every, 0); }

std::vector<Mesh> readMeshes(const std::string& shipFile, int panels) {
  const ShipParticulars ship = command::readShipFile(shipFile).particulars;
  const auto folder = std::filesystem::absolute(shipFile).parent_path();
  std::vector<Mesh> meshes;
  for (const int n : {224, 433, 1040}) {
    if (panels != 0 && panels != n) continue;
    const auto file = folder / ("frigate_" + std::to_string(n) + ".obj");
    meshes.push_back(divided(n, ship, file.string()));
  }
  if (meshes.empty()) throw HydroError(Fault::BadArgument, "--panels: must be 224, 433 or 1040");
  return meshes;
}

SolveSettings ours(const Job& job) {
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  settings.omega = job.omega();
  return settings;
}

SolveSettings reports(const Job& job, int sourcePoints, int galerkinPoints) {
  SolveSettings settings = ours(job);
  settings.formulation = Formulation::Source;
  settings.derivatives = Derivatives::Source;
  settings.sourcePoints = sourcePoints;
  settings.galerkinPoints = galerkinPoints;
  settings.lid = false;
  return settings;
}

double dampingUnit(const ShipParticulars& ship, int mode) {
  const double radius = mode < Roll ? 1.0 : ship.gyradii[mode - Roll];
  return ship.mass * radius * radius * std::sqrt(ship.gravity / kLength);
}

}  // namespace cutwater::report
