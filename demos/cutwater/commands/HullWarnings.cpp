#include "demos/cutwater/commands/HullWarnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "hydro/base/EnumNames.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/PressureHull.h"

namespace cutwater::command {

namespace {

// Of the waves' pressure: from here on it is seen in the motions.
constexpr double kCoarse = 0.05;

std::string coarseLine(const RunFile& run, const HullNotes& worst) {
  return fmt::format(
      "[motion] hull_triangles = {}: too few for these waves{}: {:.2g} % of their pressure is "
      "missed, more than {:.2g} %; give more",
      run.model.hullTriangles, worst.of.empty() ? "" : ", " + worst.of, 100.0 * worst.pressureError,
      100.0 * kCoarse);
}

}  // namespace

HullNotes hullNotes(const Ship& ship) {
  HullNotes notes{.closedHull = ship.hydrodynamics().closedHull()};
  const PressureHull* const hull = ship.pressureHull();
  notes.nonlinear = hull != nullptr;
  if (hull == nullptr) return notes;
  notes.pressureError = hull->pressureError();
  notes.weight = hull->warning();
  return notes;
}

std::vector<std::string> hullWarnings(const RunFile& run, const std::vector<HullNotes>& notes) {
  std::vector<std::string> lines;
  if (notes.empty()) return lines;
  const HullNotes& worst = *std::max_element(
      notes.begin(), notes.end(),
      [](const HullNotes& a, const HullNotes& b) { return a.pressureError < b.pressureError; });
  if (!worst.weight.empty()) lines.push_back(worst.weight);
  if (worst.pressureError > kCoarse) lines.push_back(coarseLine(run, worst));
  if (worst.nonlinear) return lines;
  if (run.model.mean == Mean::Free && !run.model.mode && !worst.closedHull)
    lines.push_back(fmt::format(
        "[motion] mode is \"linear\": {} holds no closed hull; solve the ship from a closed mesh "
        "for \"nonlinear\"",
        run.database));
  if (run.sea.profile != run.usualProfile())
    lines.push_back(fmt::format("[waves] profile = \"{}\" has no effect in mode = \"linear\"",
                                nameOf(kWaveProfileNames, run.sea.profile)));
  return lines;
}

}  // namespace cutwater::command
